#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// Metres from chin to crown: the height of a head in pictures (headPixels).
inline constexpr float kHeadHeight = 0.225f;

/// The part of a groom that is drawn, and the resolution of its shadow. {} is all of it.
///
/// Strands are removed in a fixed order, and the others are drawn wider, so that the hair covers as
/// much as before. Removal is not visible: strands become narrower, the sooner they are removed the
/// more (Cook, Halstead, Planck and Ryu 2007, "Stochastic simplification of aggregate detail").
struct LevelOfDetail {
  float strands = 1;   ///< fraction of the strands that is drawn at full width, (0, 1]
  float fade = 0.25f;  ///< strands that fade out, over those of full width, (0, 1]
  float points = 1;    ///< fraction of a strand's segments, (0, 1]
  float cellSize = 0;  ///< least cell size of shadow maps, metres; 0: as set

  /// Every strand with every point.
  bool drawsAll() const { return strands >= 1 && points >= 1; }
  /// Relative width of a strand of some rank (GroomDetail), [0, 1]. Falls as the rank grows or
  /// `strands` falls, from 1 to 0 while `strands` falls by a factor of 1 + fade.
  float weightOf(float rank) const;
  /// Number of segments drawn of a strand of `segments`: at least 2 where it has them. Each strand
  /// changes at its own `moment` in [0, 1), so that their sum changes smoothly.
  std::uint32_t segmentsOf(std::uint32_t segments, float moment) const;

  /// In every field.
  bool operator==(const LevelOfDetail&) const = default;
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const LevelOfDetail*) {
  using S = LevelOfDetail;
  return std::tuple(Field("strands", &S::strands, "(0, 1]"), Field("fade", &S::fade, "(0, 1]"),
                    Field("points", &S::points, "(0, 1]"),
                    Field("cellSize", &S::cellSize, "[0, 1e6] m"));
}

/// Throws Error, with the field, for a level out of range.
void validate(const LevelOfDetail& level);

/// Measurements of a groom that its levels need: made once, on the hair at rest. Heads of the same
/// groom may share them.
struct GroomDetail {
  /// Reads each strand at rest once. Threads over strands.
  explicit GroomDetail(const Groom& groom);

  /// [strandCount], [0, 1): strands of a lower rank are removed later. The strands of any range of
  /// ranks from 0 on are spread evenly over the scalp: the van der Corput sequence along a
  /// space-filling curve through the roots.
  std::vector<float> rank;
  std::vector<float> length;  ///< [strandCount], at rest, metres
  float fibreWidth = 0;       ///< of the groom, metres

  /// Number of strands of the groom.
  std::size_t strandCount() const { return rank.size(); }
  /// Root mean square distance, metres, of strands from those drawn with the fraction `points` of
  /// their segments; 0 for all segments, growing as the fraction falls.
  float deviation(float points) const;
  /// Length of strands with the fraction `points` of their segments over their full length, (0, 1].
  float lengthKept(float points) const;
  /// The fraction of segments whose `deviation` is this, metres; 1 below half of a hair's width.
  float pointsFor(float deviation) const;

 private:
  static constexpr std::size_t kShares = 41;  // eight to a halving
  std::array<float, kShares> deviation_{}, lengthKept_{};
};

/// Required detail per pixel of a picture. The defaults are measured (docs/measurements.md).
struct DetailSettings {
  float strandsPerPixel = 40;  ///< strands of the whole groom, per pixel of the head's height
  float pixelsOff = 0.05f;     ///< allowed deviation of strands, pixels
  float pixelsPerCell = 3;     ///< least size of a cell of a shadow map, pixels
  float fade = 0.25f;          ///< LevelOfDetail::fade
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const DetailSettings*) {
  using S = DetailSettings;
  return std::tuple(Field("strandsPerPixel", &S::strandsPerPixel, "(0, inf)"),
                    Field("pixelsOff", &S::pixelsOff, "(0, inf)"),
                    Field("pixelsPerCell", &S::pixelsPerCell, "(0, inf)"),
                    Field("fade", &S::fade, "(0, 1]"));
}

/// Height of a head in a picture, pixels: at `distance` metres, in a picture of `pictureHeight`
/// pixels and the vertical angle `fieldOfView` (radians). Throws Error for numbers that are not
/// positive, and angles of half a turn or more.
float headPixels(float distance, float fieldOfView, float pictureHeight);

/// The level at which hair on a head of a height of `pixels` on the screen looks like the whole
/// groom. `importance` in (0, 1]: a head of importance 0.5 is drawn like one of half the size.
/// Grows with both, and from some size on is {} but for the fade. Throws Error for numbers that are
/// not positive.
LevelOfDetail levelFor(const GroomDetail& detail, float pixels, float importance = 1,
                       const DetailSettings& settings = {});

}  // namespace hair
