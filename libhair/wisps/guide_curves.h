#pragma once

#include <cstdint>
#include <vector>

#include <libhair/guides/guide_strands.h>

namespace hair {

/// Guides as smooth curves: Catmull-Rom through the points of each guide (Bertails et al. 2005,
/// section 3.1), sampled evenly in its parameter, with a frame carried along by parallel transport.
/// Smoothing the few guides once is cheaper than smoothing every drawn strand, and the same, as
/// both steps are linear.
///
/// A guide has nine rows, one per component, so that sixteen samples of one are one load:
///
///     guide 0   x           sample 0, sample 1, ... sample `samples` - 1
///               y           sample 0, ...
///               z
///               normal x, y, z
///               tangent x, y, z
///     guide 1   x ...
struct GuideCurves {
  /// Orthonormal frame; offsets of drawn strands are given in it.
  struct Frame {
    glm::vec3 normal,  ///< carried along by parallel transport
        binormal,      ///< tangent × normal
        tangent;       ///< towards the tip
    /// A vector of this frame in world axes.
    glm::vec3 toWorld(glm::vec3 v) const { return v.x * normal + v.y * binormal + v.z * tangent; }
    /// A vector in world axes, in this frame.
    glm::vec3 fromWorld(glm::vec3 v) const {
      return {glm::dot(v, normal), glm::dot(v, binormal), glm::dot(v, tangent)};
    }
  };

  /// The Catmull-Rom weights of one sample on four guide points from `start` on.
  struct Sample {
    std::uint32_t start;  ///< first of the four points
    float weights[4];     ///< sum 1
  };

  /// First rows of the vectors of a guide, and the number of its rows.
  static constexpr std::size_t kPoint = 0,  ///< row of a point's x
      kNormal = 3,                          ///< row of a normal's x
      kTangent = 6,                         ///< row of a tangent's x
      kRows = 9;                            ///< of a guide

  std::uint32_t samples = 0;  ///< per guide
  std::vector<Sample> basis;  ///< [samples]
  /// [guideCount · kRows · samples], metres, world; padded by kLanes, so that sixteen values can be
  /// read from any place.
  std::vector<float> rows;
  /// [groupCount]; boxes of the points of a group's guides, metres.
  std::vector<LaneVec3> lower,  ///< corner towards -x, -y, -z
      upper;                    ///< corner towards +x, +y, +z

  /// Allocates the curves of these guides, with `samples` >= 2 per guide. Throws Error below that.
  GuideCurves(const GuideStrands& guides, std::uint32_t samples);

  /// Number of guides.
  std::size_t guideCount() const { return (rows.size() - kLanes) / (kRows * samples); }
  /// One component at all samples of a guide: [samples].
  const float* row(std::size_t guide, std::size_t component) const {
    return rows.data() + (guide * kRows + component) * samples;
  }
  /// A sample of a guide, metres, world.
  glm::vec3 point(std::size_t guide, std::uint32_t sample) const {
    return vector(guide, kPoint, sample);
  }
  /// The frame at a sample.
  Frame frame(std::size_t guide, std::uint32_t sample) const {
    const glm::vec3 normal = vector(guide, kNormal, sample),
                    tangent = vector(guide, kTangent, sample);
    return {normal, glm::cross(tangent, normal), tangent};
  }

 private:
  glm::vec3 vector(std::size_t guide, std::size_t component, std::uint32_t sample) const {
    const float* x = row(guide, component) + sample;
    return {x[0], x[samples], x[2 * std::size_t{samples}]};
  }
};

/// Samples all guides at their current positions. Threads over groups of guides.
void sampleGuides(const GuideStrands& guides, GuideCurves& curves);

}  // namespace hair
