#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>
#include <libhair/geometry/colliders.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/model/groom.h>
#include <libhair/model/level_of_detail.h>

namespace HAIR_API hair {

struct GuideCurves;
struct WispObstacles;

/// How drawn strands are kept out of colliders (SIGGRAPH 2010 course, "Avoiding interpolated hair
/// collisions").
struct WispSettings {
  bool avoidColliders = true;     ///< false: drawn strands are not kept out of colliders
  float clearance = 1e-3f;        ///< metres that drawn points keep from colliders, [0, 0.1)
  std::uint32_t blendPoints = 4;  ///< points before the first hit that blend into the fallback
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const WispSettings*) {
  using S = WispSettings;
  return std::tuple(Field("avoidColliders", &S::avoidColliders),
                    Field("clearance", &S::clearance, "[0, 0.1) m"),
                    Field("blendPoints", &S::blendPoints, "[0, inf)"));
}

/// The part of a groom that is drawn (setLevel).
struct DrawnPart {
  LevelOfDetail level;               ///< as given
  std::vector<std::uint32_t> first;  ///< [strandCount + 1]; empty: all, as the groom has them
  std::vector<float> weights;        ///< [strandCount], relative widths, [0, 1]; or empty: all 1
  float wider = 1;  ///< factor by which drawn strands are wider than those of the groom
  float solid = 1;  ///< mean of the weights that are not 0
};

/// Drawn strands, which follow guides as defined by Groom.
struct Wisps {
  /// Guides at rest and the head's collider (may be null): a strand groomed closer to the head
  /// than the clearance may stay as close.
  /// Throws Error for a groom whose arrays disagree (counts, guide indices, weights that do not sum
  /// to 1, strands of fewer than 2 points), and for offsets or settings out of range. Keeps a
  /// reference to the groom.
  Wisps(const Groom& groom, const GuideStrands& guidesAtRest, const WispSettings& settings = {},
        const MeshSdf* head = nullptr);
  ~Wisps();
  Wisps(Wisps&&) noexcept;             ///< moves all of it
  Wisps& operator=(Wisps&&) noexcept;  ///< moves all of it

  /// The strands that interpolateWisps or drawWisps last wrote.
  StrandView strands() const {
    return {points, drawn.first.empty() ? std::span(groom->first) : std::span(drawn.first)};
  }
  /// The groom's fibre, widened as strands are drawn.
  Fibre fibre() const {
    Fibre fibre = groom->fibre;
    fibre.hairsPerStrand *= drawn.wider;
    return fibre;
  }
  /// The same with all that the stages after this one need.
  DrawnHair drawnHair() const {
    const bool all = drawn.first.empty();
    return {strands(), fibre(), drawn.weights,
            all ? 1 : 1 + groom->fibre.hairsPerStrand * (drawn.wider - 1)};
  }
  /// Sample of the guide curves that point k of a strand of n points follows: the nearest, exact
  /// where strand and curves have as many points.
  std::uint32_t sampleOf(std::uint32_t k, std::uint32_t n) const;

  const Groom* groom;                   ///< as given; not owned
  WispSettings settings;                ///< as given
  DrawnPart drawn;                      ///< set by setLevel
  std::vector<glm::vec3> points;        ///< [pointCount], metres, world
  std::unique_ptr<GuideCurves> curves;  ///< of the guides, sampled at the last frame
  /// [strandCount]; roots in the frames at the roots of their main guides, metres: the offset that
  /// single-strand interpolation keeps along the whole strand.
  std::vector<glm::vec3> rootOffsets;
  std::vector<float> clearance;  ///< [strandCount], metres to the head
  /// sampleOf(k, n) at [tableOf[n] + k], for every k and each n that occurs; padded by kLanes.
  std::vector<std::int32_t> sampleTable;
  std::vector<std::uint32_t> tableOf;        ///< [longest strand + 1]
  std::unique_ptr<WispObstacles> obstacles;  ///< set by prepareWisps
};

/// Draws all strands from the guides. Each strand by multi-strand interpolation (Groom); where a
/// point would be inside a collider, by single-strand interpolation from a few points before it to
/// the tip; points inside even then are put on the surface. Uses the colliders at the end of the
/// frame. Writes wisps.points: prepareWisps, then drawWisps of all strands. Same bits on every
/// instruction set and for any number of threads. Throws Error for more than 64 capsules, and for
/// invalid scenery.
void interpolateWisps(const GuideStrands& guides, const ColliderState& colliders, Wisps& wisps);

/// The per-frame part: samples the guides, and finds the obstacles near them. Threads over guides.
/// Throws Error as interpolateWisps.
void prepareWisps(const GuideStrands& guides, const ColliderState& colliders, Wisps& wisps);

/// Draws strands [begin, end) after prepareWisps, on the calling thread: several threads may draw
/// disjoint ranges at once. The distance fields given to prepareWisps must still exist.
void drawWisps(std::size_t begin, std::size_t end, Wisps& wisps);

/// Draws one strand with all of its points in the groom, at any level, into `points`; after
/// prepareWisps.
void drawWhole(std::size_t strand, const Wisps& wisps, std::span<glm::vec3> points);

/// Sets the level of detail of drawWisps. Resizes wisps.points; its contents are undefined until
/// the next draw. Strands keep their numbers: one that is not drawn has no points. `detail`: of the
/// wisps' groom. Costs a few nanoseconds per strand of the groom. Never frees memory, so that later
/// levels need not allocate. Throws Error for a level out of range and another groom's detail.
void setLevel(const GroomDetail& detail, const LevelOfDetail& level, Wisps& wisps);

/// Draws every stride-th strand (0, stride, 2 · stride ...) with all of its points, at any level,
/// after prepareWisps. `out` has all strands of the groom; the others have no points. Threads over
/// strands. Throws Error for a stride of 0.
void drawEvery(std::uint32_t stride, const Wisps& wisps, StrandSet& out);

/// A groom of only what the level draws: less memory, where the level does not change (a crowd, a
/// file). Strands that are fading are kept from half of the full width on; all are equally wide,
/// and together cover as much as before. Drawn at rest, points are those of the level. Throws Error
/// as setLevel.
Groom groomAt(const Groom& groom, const GroomDetail& detail, const LevelOfDetail& level);

}  // namespace hair
