#pragma once

#include <cstdint>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/model/groom.h>
#include <libhair/model/head.h>

namespace HAIR_API hair {

/// The hairstyles that are built in.
enum class Style : std::uint8_t {
  Smooth,  ///< brown hair to the shoulders (Bertails et al. 2005, figures 1 and 9)
  Curly,   ///< the same wisps, wound into locks
  Long,    ///< smooth, to the waist
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(Style) {
  return std::array{Word("smooth", Style::Smooth), Word("curly", Style::Curly),
                    Word("long", Style::Long)};
}

/// The parting: a line over the top of the built-in head, from the front hairline back to the
/// whorl; hair falls away from it on all sides. Metres, head space.
struct Parting {
  float x = 0.016f;       ///< right or left of the nose
  float whorlZ = -0.03f;  ///< where the line ends
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const Parting*) {
  using S = Parting;
  return std::tuple(Field("x", &S::x, "[-1, 1] m"), Field("whorlZ", &S::whorlZ, "[-1, 1] m"));
}

/// How a hairstyle is grown on the built-in head. Lengths in metres. `styleSettings` gives the
/// values of each style; the defaults here are those of Style::Smooth.
struct StyleSettings {
  std::uint32_t strands = 3350;       ///< drawn, >= wisps
  std::uint32_t points = 31;          ///< a drawn strand, >= 2
  std::uint32_t wisps = 134;          ///< of three guides each, >= 1
  std::uint32_t pointsPerGuide = 16;  ///< >= 3
  std::uint32_t seed = 1;             ///< of everything random
  float hairs = 100'000;              ///< that the drawn strands represent together

  // The cut: a guide ends at the cut height, or at the greatest length.
  float cutHeightFront = -0.13f;  ///< beside the face, head space
  float cutHeightBack = -0.17f;   ///< at the back of the head, head space
  float minLength = 0.16f;        ///< no guide is cut shorter, but for lengthVariation
  float maxLength = 0.38f;        ///< no guide is longer, but for lengthVariation
  float lengthVariation = 0.04f;  ///< share of the length, from wisp to wisp

  // How it lies.
  Parting parting = {};       ///< where hair falls to either side
  float partingJitter = 0;    ///< how far from it wisps still fall to either side
  float partAtShoulders = 1;  ///< 0: hair lies on them, 1: it falls before or behind them
  float volume = 0.016f;      ///< how far the uppermost hair lies from the head
  float rootLift = 0.3f;      ///< 0: hair leaves the scalp flat, 1: at 45 degrees
  float waviness = 0.35f;     ///< radians that wisps swing from side to side
  float turnIn = 0.35f;       ///< how much the tips turn to the neck, 0 to 1

  // How drawn strands fill a wisp.
  float clump = 0.65f;      ///< how far they come together, 0 to 1
  float clumpBy = 1;        ///< by which share of the length they have
  float spread = 0.75f;     ///< what is left of a root's place in its wisp at the tip, 0 to 1
  float curlRadius = 0;     ///< 0: no curls
  float curlPitch = 0.03f;  ///< along the guide, a turn
  float curlJitter = 0.5f;  ///< radians of phase between strands of one lock

  // Random deviations (course, "Random Variations"): of the tips of many, of the whole of few.
  float tipShare = 0.3f;          ///< of strands, [0, 1]
  float tipDeviation = 0.008f;    ///< metres, at the tip, the most
  float wholeShare = 0.1f;        ///< of strands, [0, 1]
  float wholeDeviation = 0.006f;  ///< metres, about the most
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const StyleSettings*) {
  using S = StyleSettings;
  return std::tuple(
      Field("strands", &S::strands, "[1, inf)"), Field("points", &S::points, "[2, inf)"),
      Field("wisps", &S::wisps, "[1, inf)"),
      Field("pointsPerGuide", &S::pointsPerGuide, "[3, inf)"), Field("seed", &S::seed),
      Field("hairs", &S::hairs, "(0, 1e9)"),
      Field("cutHeightFront", &S::cutHeightFront, "[-100, 100] m"),
      Field("cutHeightBack", &S::cutHeightBack, "[-100, 100] m"),
      Field("minLength", &S::minLength, "(0, 100] m"),
      Field("maxLength", &S::maxLength, "(0, 100] m"),
      Field("lengthVariation", &S::lengthVariation, "[0, 1)"), Field("parting", &S::parting),
      Field("partingJitter", &S::partingJitter, "[0, 100] m"),
      Field("partAtShoulders", &S::partAtShoulders, "[0, 1]"),
      Field("volume", &S::volume, "[0, 100] m"), Field("rootLift", &S::rootLift, "[0, 1]"),
      Field("waviness", &S::waviness, "[0, 10] radians"), Field("turnIn", &S::turnIn, "[0, 1]"),
      Field("clump", &S::clump, "[0, 1]"), Field("clumpBy", &S::clumpBy, "(0, 1]"),
      Field("spread", &S::spread, "[0, 1]"), Field("curlRadius", &S::curlRadius, "[0, 100] m"),
      Field("curlPitch", &S::curlPitch, "(0, 100] m"),
      Field("curlJitter", &S::curlJitter, "[0, 100] radians"),
      Field("tipShare", &S::tipShare, "[0, 1]"),
      Field("tipDeviation", &S::tipDeviation, "[0, 100] m"),
      Field("wholeShare", &S::wholeShare, "[0, 1]"),
      Field("wholeDeviation", &S::wholeDeviation, "[0, 100] m"));
}

/// The settings of each style.
StyleSettings styleSettings(Style style);

/// Grows a hairstyle on the built-in head, whose distance field is `headSdf` (cells of 4 mm do).
/// At rest every guide point but the root is at least kGuideClearance outside of the head, the
/// links of a guide are equal to 1e-4, and drawn strands stay outside of the head and off the
/// face. The same settings give the same bits for any number of threads. Throws Error for
/// settings out of range.
Groom makeGroom(const StyleSettings& settings, const MeshSdf& headSdf);

/// Metres; see makeGroom.
inline constexpr float kGuideClearance = 0.002f;

}  // namespace hair
