#pragma once

#include <algorithm>
#include <cstddef>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// Hairs on a head: what strands share where nobody says how many they stand for.
inline constexpr float kHairsOnHead = 100'000;

/// Hairs that each of so many strands stands for, where together they stand for `hairs`; at
/// least 1.
inline float hairsEach(std::size_t strands, float hairs = kHairsOnHead) {
  return strands == 0 ? 1.0f : std::max(1.0f, hairs / static_cast<float>(strands));
}

/// Choice of guides among strands.
struct BindSettings {
  std::uint32_t guides = 402;         ///< number of guides, >= 1; at most the number of strands
  std::uint32_t pointsPerGuide = 16;  ///< of every guide
  float shapeWeight = 0.5f;           ///< weight of differences of shape over those of roots, >= 0
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const BindSettings*) {
  using S = BindSettings;
  return std::tuple(Field("guides", &S::guides, "[1, inf)"),
                    Field("pointsPerGuide", &S::pointsPerGuide, "[2, 64]"),
                    Field("shapeWeight", &S::shapeWeight, "[0, inf)"));
}

/// A groom from loaded strands (head space, at least 2 points each). Guides are some of the
/// strands, far from each other in root and shape; every strand follows its three nearest guides,
/// and keeps its own shape as offsets in the frame of the nearest. With the guides at rest the
/// groom reproduces the strands to rounding. `hairs`: real hairs that the strands stand for
/// together. Throws Error for no strands, strands of fewer than 2 points or without length, and
/// settings out of range.
Groom bindGroom(StrandView strands, const BindSettings& settings = {}, float hairs = kHairsOnHead);

/// Sets the groom's offsets to the difference of `strands` (head space; points as in the groom)
/// from what its guides interpolate at rest: drawn at rest it then reproduces them to rounding.
/// Throws Error where counts differ, and as Wisps does.
void keepShape(StrandView strands, Groom& groom);

}  // namespace hair
