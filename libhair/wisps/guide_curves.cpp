#include <libhair/wisps/guide_curves.h>

#include <algorithm>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair {

namespace {

// Weights on points i - 1 .. i + 2 at t in [0, 1] between points i and i + 1 of n. Beyond its ends
// the strand goes on by reflection (p_-1 = 2 p_0 - p_1), folded into the weights that exist.
GuideCurves::Sample catmullRom(std::uint32_t i, float t, std::uint32_t n) {
  const float t2 = t * t, t3 = t2 * t;
  const float w[4] = {0.5f * (-t3 + 2 * t2 - t), 0.5f * (3 * t3 - 5 * t2 + 2),
                      0.5f * (-3 * t3 + 4 * t2 + t), 0.5f * (t3 - t2)};
  // The window of four points that exist; at the ends it does not start at i - 1.
  const std::uint32_t start = static_cast<std::uint32_t>(
      std::clamp<int>(static_cast<int>(i) - 1, 0, std::max(0, static_cast<int>(n) - 4)));
  GuideCurves::Sample sample{start, {0, 0, 0, 0}};
  const auto add = [&](int point, float weight) {
    if (point < 0) {
      sample.weights[0 - start] += 2 * weight, sample.weights[1 - start] -= weight;
    } else if (point >= static_cast<int>(n)) {
      sample.weights[n - 1 - start] += 2 * weight, sample.weights[n - 2 - start] -= weight;
    } else {
      sample.weights[static_cast<std::uint32_t>(point) - start] += weight;
    }
  };
  for (int k = 0; k < 4; ++k) add(static_cast<int>(i) - 1 + k, w[k]);
  return sample;
}

}  // namespace

GuideCurves::GuideCurves(const GuideStrands& guides, std::uint32_t samples_, bool withFrames)
    : samples(samples_) {
  require(samples >= 2, "guide curves: ", samples, " samples a guide; a strand needs at least 2");
  const std::uint32_t n = guides.pointsPerGuide();
  basis.reserve(samples);
  for (std::uint32_t k = 0; k < samples; ++k) {
    const float u =
        static_cast<float>(k) * static_cast<float>(n - 1) / static_cast<float>(samples - 1);
    const std::uint32_t i = std::min(static_cast<std::uint32_t>(u), n - 2);
    basis.push_back(catmullRom(i, u - static_cast<float>(i), n));
  }
  points.resize(guides.guideCount() * samples);
  if (withFrames) frames.resize(points.size());
}

void sampleGuides(const GuideStrands& guides, GuideCurves& curves) {
  const std::uint32_t n = guides.pointsPerGuide(), samples = curves.samples;
  const std::uint32_t window = std::min(n, 4u);
  const glm::mat3 turn = glm::mat3_cast(guides.worldFromHead.rotation);
  parallelFor(guides.groupCount(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t group = begin; group < end; ++group) {
      const std::size_t used = std::min(kLanes, guides.guideCount() - group * kLanes);
      const LaneVec3* p = &guides.position[group * n];
      const auto sampleAt = [&](std::uint32_t k) {
        const GuideCurves::Sample& s = curves.basis[k];
        LaneVec3 x;
        for (std::uint32_t w = 0; w < window; ++w) x = x + lanes(s.weights[w]) * p[s.start + w];
        return x;
      };
      LaneVec3 tangent = rotate(turn, guides.rootTangent[group]);
      LaneVec3 normal = rotate(turn, guides.rootNormal[group]);
      LaneVec3 before = sampleAt(0), here = before;
      for (std::uint32_t k = 0; k < samples; ++k) {
        const LaneVec3 next = k + 1 < samples ? sampleAt(k + 1) : here;
        for (std::size_t l = 0; l < used; ++l)
          curves.points[(group * kLanes + l) * samples + k] = lane(here, l);
        if (!curves.frames.empty()) {
          const LaneVec3 chord = next - before;
          const LaneVec3 direction = (1.0f / max(length(chord), lanes(1e-12f))) * chord;
          normal = transportNormal(normal, tangent, direction);
          // Transport keeps the right angle but for rounding, which would add up on long strands.
          normal = normal - dot(normal, direction) * direction;
          normal = (1.0f / max(length(normal), lanes(1e-12f))) * normal;
          tangent = direction;
          const LaneVec3 binormal = cross(tangent, normal);
          for (std::size_t l = 0; l < used; ++l)
            curves.frames[(group * kLanes + l) * samples + k] = {lane(normal, l), lane(binormal, l),
                                                                 lane(tangent, l)};
        }
        before = here;
        here = next;
      }
    }
  });
}

}  // namespace hair
