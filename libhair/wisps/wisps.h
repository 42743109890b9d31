#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/drawn_hair.h>
#include <libhair/guides/contact.h>
#include <libhair/model/groom.h>
#include <libhair/model/level_of_detail.h>
#include <libhair/wisps/guide_curves.h>
#include <libhair/wisps/obstacles.h>

namespace HAIR_API hair {

/// How drawn strands are kept out of colliders (SIGGRAPH 2010 course, "Avoiding interpolated hair
/// collisions").
struct WispSettings {
  bool avoidColliders = true;     ///< false: drawn strands are not kept out of colliders
  float clearance = 1e-3f;        ///< metres that drawn points keep from colliders, [0, 0.1)
  std::uint32_t blendPoints = 4;  ///< points above the first hit over which a strand changes over
};

/// What of a groom is drawn (setLevel).
struct DrawnPart {
  LevelOfDetail level;               ///< as given
  std::vector<std::uint32_t> first;  ///< [strandCount + 1]; empty: all, as the groom has them
  std::vector<float> weights;  ///< [strandCount], widths as shares of the others', or empty: all 1
  float wider = 1;             ///< so much wider are strands than those of the groom
  float solid = 1;             ///< mean of the weights that are not 0
};

/// Drawn strands that follow guides, as a Groom says.
struct Wisps {
  /// Guides at rest and the head's collider (may be null): a strand groomed closer to the head
  /// than the clearance may stay as close.
  /// Throws Error: a groom whose arrays disagree (counts, guide indices, weights that do not sum
  /// to 1, strands of fewer than 2 points), offsets or settings that are out of range. Keeps a
  /// reference to the groom.
  Wisps(const Groom& groom, const GuideStrands& guidesAtRest, const WispSettings& settings = {},
        const MeshSdf* head = nullptr);

  /// What interpolateWisps last made.
  StrandView strands() const {
    return {points, drawn.first.empty() ? std::span(groom->first) : std::span(drawn.first)};
  }
  /// The groom's fibre, as wide as strands are drawn.
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
  std::uint32_t sampleOf(std::uint32_t k, std::uint32_t n) const {
    const std::uint64_t last = n - 1;
    return static_cast<std::uint32_t>((2 * std::uint64_t{k} * (curves.samples - 1) + last) /
                                      (2 * last));
  }

  const Groom* groom;             ///< as given; not owned
  WispSettings settings;          ///< as given
  DrawnPart drawn;                ///< as setLevel was told
  std::vector<glm::vec3> points;  ///< [pointCount], metres, world
  GuideCurves curves;             ///< of the guides, sampled at the last frame
  /// [strandCount]; where the root sits in the frame at its main guide's root, metres: the offset
  /// that single-strand interpolation keeps along the whole strand.
  std::vector<glm::vec3> rootOffsets;
  std::vector<float> clearance;  ///< [strandCount], metres to the head
  /// sampleOf(k, n) of every k at [tableOf[n] + k], for each n that strands have; and kLanes more.
  std::vector<std::int32_t> sampleTable;
  std::vector<std::uint32_t> tableOf;  ///< [longest strand + 1]
  WispObstacles obstacles;             ///< scratch of the frame
};

/// Guides to drawn strands. For each strand, multi-strand interpolation (Groom); where a point
/// would be inside a collider, single-strand interpolation from a few points above it to the tip;
/// and what is inside even then is put on the surface. Colliders are where they stand at the end of
/// the frame. Writes wisps.points: prepareWisps, then drawWisps of all strands. Same bits on every
/// instruction set and for any number of threads. Throws Error for more than 64 capsules, and for
/// scenery that is not valid.
void interpolateWisps(const GuideStrands& guides, const ColliderState& colliders, Wisps& wisps);

/// What a frame does once: samples the guides, and finds out which obstacles are near. Threads over
/// guides.
void prepareWisps(const GuideStrands& guides, const ColliderState& colliders, Wisps& wisps);

/// Draws strands begin to end with what prepareWisps left, on the calling thread: several threads
/// may draw strands of their own at once. Distance fields that it was given must still be there.
void drawWisps(std::size_t begin, std::size_t end, Wisps& wisps);

/// Draws one strand with all of its points, whatever is drawn: as many as the groom has.
void drawWhole(std::size_t strand, const Wisps& wisps, std::span<glm::vec3> points);

}  // namespace hair
