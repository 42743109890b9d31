#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// From chin to crown, metres: what "the head is so many pixels high" speaks of.
inline constexpr float kHeadHeight = 0.225f;

/// How much of a groom is drawn, and how fine its shadow is. {} is all of it.
///
/// Strands leave in a fixed order, and those that stay are drawn wider, so that the hair covers as
/// much as before; nobody sees one leave, as the next to go are narrower the sooner they will
/// (Cook, Halstead, Planck and Ryu 2007, "Stochastic simplification of aggregate detail").
struct LevelOfDetail {
  float strands = 1;   ///< share of the strands that is drawn at full width, (0, 1]
  float fade = 0.25f;  ///< so many more, as a share of those, are on their way out, (0, 1]
  float points = 1;    ///< share of a strand's segments, (0, 1]
  float cellSize = 0;  ///< what cells of shadow maps measure at least, metres; 0: as they are set

  /// Every strand with every point.
  bool drawsAll() const { return strands >= 1 && points >= 1; }
  /// Width of a strand of some rank (GroomDetail) as a share of that of all others, [0, 1]. Falls
  /// as the rank grows or `strands` falls, by 1 while `strands` falls by a factor of 1 + fade.
  float weightOf(float rank) const;
  /// Segments of a strand that has so many: at least 2 where it has them. Each strand changes at a
  /// moment of its own in [0, 1), so that what all strands have together changes smoothly.
  std::uint32_t segmentsOf(std::uint32_t segments, float moment) const;

  /// In every field.
  bool operator==(const LevelOfDetail&) const = default;
};

/// Throws Error, with the field, for a level out of range.
void validate(const LevelOfDetail& level);

/// What the levels of a groom are made of: measured once, on the hair at rest. Heads of the same
/// groom may share it.
struct GroomDetail {
  /// Reads each strand at rest once. Threads over strands.
  explicit GroomDetail(const Groom& groom);

  /// [strandCount], [0, 1): strands of a lower rank stay longer. Any share of the ranks from 0 on
  /// is spread evenly over the scalp: the van der Corput sequence along a space-filling curve
  /// through the roots.
  std::vector<float> rank;
  std::vector<float> length;  ///< [strandCount], at rest, metres
  float fibreWidth = 0;       ///< of the groom, metres

  /// Of the groom.
  std::size_t strandCount() const { return rank.size(); }
  /// How far strands are, root of the mean square, from those of a share `points` of their
  /// segments, metres; 0 for all of them, and growing as the share falls.
  float deviation(float points) const;
  /// What is left of strands' lengths then, (0, 1].
  float lengthKept(float points) const;
  /// The share that is so far off, metres; 1 where that is less than half of a hair's width.
  float pointsFor(float deviation) const;

 private:
  static constexpr std::size_t kShares = 41;  // eight to a halving
  std::array<float, kShares> deviation_{}, lengthKept_{};
};

/// What a picture needs of hair, per pixel. The defaults are measured (docs/measurements.md).
struct DetailSettings {
  float strandsPerPixel = 40;  ///< strands of the whole groom, per pixel of the head's height
  float pixelsOff = 0.05f;     ///< how far strands may be from where they were, pixels
  float pixelsPerCell = 3;     ///< what a cell of a shadow map measures at least
  float fade = 0.25f;          ///< LevelOfDetail::fade
};

/// How high a head is in a picture, pixels: the picture is `pictureHeight` pixels high and sees the
/// angle `fieldOfView` (radians, bottom to top) from `distance` metres.
/// Throws Error for numbers that are not positive, and angles of half a turn and more.
float headPixels(float distance, float fieldOfView, float pictureHeight);

/// The level at which hair on a head that is `pixels` high on the screen looks as all of it does.
/// `importance` in (0, 1]: a head of importance 0.5 is drawn as one half as large. Grows with both,
/// and is {} but for the fade from some size on. Throws Error for numbers that are not positive.
LevelOfDetail levelFor(const GroomDetail& detail, float pixels, float importance = 1,
                       const DetailSettings& settings = {});

}  // namespace hair
