#pragma once

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// How guides are chosen among strands.
struct BindSettings {
  std::uint32_t guides = 402;         ///< chosen among the strands, at most as many as there are
  std::uint32_t pointsPerGuide = 16;  ///< 2 to kMaxGuidePoints
  float shapeWeight = 0.5f;  ///< how much a difference of tips counts beside one of roots, >= 0
};

/// A groom from loaded strands (head space, at least 2 points each): guides are strands of its own,
/// chosen far from each other in root, then shape; every strand follows its three nearest guides,
/// and keeps its own shape as offsets in the frames of the nearest. Where the guides are at rest it
/// reproduces the strands to rounding.
/// Throws Error: no strands, strands of fewer than 2 points or without length.
Groom bindGroom(StrandView strands, const BindSettings& settings = {}, float hairs = 100'000);

/// Sets the groom's offsets to what its guides at rest leave of `strands` (head space; as many
/// points a strand as the groom's): drawn at rest it then reproduces them to rounding. Throws Error
/// where counts differ, and as Wisps does.
void keepShape(StrandView strands, Groom& groom);

}  // namespace hair
