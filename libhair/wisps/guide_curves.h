#pragma once

#include <cstdint>
#include <vector>

#include <libhair/guides/guide_strands.h>

namespace hair {

/// Guides as smooth curves: Catmull-Rom through the points of each guide (Bertails et al. 2005,
/// section 3.1), sampled evenly in its parameter, with a frame carried along by parallel transport.
/// Smoothing the few guides once is cheaper than smoothing every drawn strand, and the same, as
/// both steps are linear.
struct GuideCurves {
  /// Orthonormal; offsets of drawn strands are in it.
  struct Frame {
    glm::vec3 normal, binormal, tangent;
    glm::vec3 toWorld(glm::vec3 v) const { return v.x * normal + v.y * binormal + v.z * tangent; }
    glm::vec3 fromWorld(glm::vec3 v) const {
      return {glm::dot(v, normal), glm::dot(v, binormal), glm::dot(v, tangent)};
    }
  };

  /// The Catmull-Rom weights of one sample on four guide points from `start` on.
  struct Sample {
    std::uint32_t start;
    float weights[4];
  };

  std::uint32_t samples = 0;      ///< a guide
  std::vector<Sample> basis;      ///< [samples]
  std::vector<glm::vec3> points;  ///< [guideCount · samples], metres, guide after guide
  std::vector<Frame> frames;      ///< [guideCount · samples]; empty if not asked for

  /// Room for these guides at `samples` >= 2 a guide. Throws Error below that.
  GuideCurves(const GuideStrands& guides, std::uint32_t samples, bool withFrames);
};

/// Samples all guides where they are now. Threads over groups of guides.
void sampleGuides(const GuideStrands& guides, GuideCurves& curves);

}  // namespace hair
