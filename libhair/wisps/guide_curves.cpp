#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/wisps/guide_curves.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>

#include <libhair/wisps/guide_curves.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// See transportNormal in lanes.h.
HWY_INLINE Vec3 transportNormal(Vec3 v, Vec3 from, Vec3 to) {
  const Vec3 h = from + to;
  return v - (Floats(2.0f) * dot(v, to) / max(dot(h, h), Floats(1e-12f))) * h;
}

// A ring buffer: the last sixteen samples of one row of sixteen guides, sample k at k % 16.
using Ring = Lanes[kLanes];

// Transposes the ring, whose last sample is end - 1, into the rows of `used` guides. Where fewer
// than sixteen samples are new, some are written again.
HWY_INLINE void spill(const Ring& ring, std::uint32_t end, std::size_t used, std::size_t stride,
                      float* row) {
  if (end < kLanes) {
    for (std::size_t l = 0; l < used; ++l)
      for (std::uint32_t k = 0; k < end; ++k)
        row[l * stride + k] = reinterpret_cast<const float*>(&ring[k])[l];
    return;
  }
  Floats block[kLanes];
  for (std::size_t i = 0; i < kLanes; ++i) block[i] = Floats(ring[(end + i) % kLanes]);
  transpose(block);
  for (std::size_t l = 0; l < used; ++l) store(block[l], row + l * stride + end - kLanes);
}

// Samples the groups [begin, end) of the guides.
void sampleGroups(const GuideStrands& guides, const glm::mat3& turn, std::size_t begin,
                  std::size_t end, GuideCurves& curves) {
  const std::uint32_t n = guides.pointsPerGuide(), samples = curves.samples;
  const std::uint32_t window = std::min(n, 4u);
  Ring rings[GuideCurves::kRows];
  for (std::size_t group = begin; group < end; ++group) {
    const std::size_t used = std::min(kLanes, guides.guideCount() - group * kLanes);
    const LaneVec3* p = &guides.position[group * n];
    const auto sampleAt = [&](std::uint32_t k) HWY_ATTR {
      const GuideCurves::Sample& s = curves.basis[k];
      Vec3 x = Floats(s.weights[0]) * Vec3(p[s.start]);
      for (std::uint32_t w = 1; w < window; ++w)
        x = x + Floats(s.weights[w]) * Vec3(p[s.start + w]);
      return x;
    };
    // Start with the frames at the roots.
    Vec3 tangent = rotate(turn, Vec3(guides.rootTangent[group]));
    Vec3 normal = rotate(turn, Vec3(guides.rootNormal[group]));
    Vec3 before = sampleAt(0), here = before, lower = here, upper = here;
    for (std::uint32_t k = 0; k < samples; ++k) {
      const Vec3 next = k + 1 < samples ? sampleAt(k + 1) : here;
      // Transport the frame to the tangent, the central difference.
      const Vec3 chord = next - before;
      const Vec3 direction = (Floats(1.0f) / max(length(chord), Floats(1e-12f))) * chord;
      normal = transportNormal(normal, tangent, direction);
      // Restore the right angle: rounding would add up on long strands.
      normal = normal - dot(normal, direction) * direction;
      normal = (Floats(1.0f) / max(length(normal), Floats(1e-12f))) * normal;
      tangent = direction;
      lower = {min(lower.x, here.x), min(lower.y, here.y), min(lower.z, here.z)};
      upper = {max(upper.x, here.x), max(upper.y, here.y), max(upper.z, here.z)};
      // Put the sample into the rings, and write these when full.
      const Floats row[GuideCurves::kRows] = {here.x,   here.y,    here.z,    normal.x, normal.y,
                                              normal.z, tangent.x, tangent.y, tangent.z};
      for (std::size_t c = 0; c < GuideCurves::kRows; ++c) store(row[c], rings[c][k % kLanes]);
      if ((k + 1) % kLanes == 0 || k + 1 == samples)
        for (std::size_t c = 0; c < GuideCurves::kRows; ++c)
          spill(rings[c], k + 1, used, GuideCurves::kRows * samples,
                curves.rows.data() + (group * kLanes * GuideCurves::kRows + c) * samples);
      before = here;
      here = next;
    }
    store(lower, curves.lower[group]);
    store(upper, curves.upper[group]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair {

namespace {

HWY_EXPORT(sampleGroups);

// Weights on points i - 1 .. i + 2 at t in [0, 1] between points i and i + 1 of n. A strand is
// extended beyond its ends by reflection (p_-1 = 2 p_0 - p_1), folded into the weights of its
// points.
GuideCurves::Sample catmullRom(std::uint32_t i, float t, std::uint32_t n) {
  const float t2 = t * t, t3 = t2 * t;
  const float w[4] = {0.5f * (-t3 + 2 * t2 - t), 0.5f * (3 * t3 - 5 * t2 + 2),
                      0.5f * (-3 * t3 + 4 * t2 + t), 0.5f * (t3 - t2)};
  // Clamp the window of four points to the strand; at the ends it does not start at i - 1.
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

GuideCurves::GuideCurves(const GuideStrands& guides, std::uint32_t samples_) : samples(samples_) {
  require(samples >= 2, "guide curves: ", samples, " samples a guide; a strand needs at least 2");
  const std::uint32_t n = guides.pointsPerGuide();
  basis.reserve(samples);
  for (std::uint32_t k = 0; k < samples; ++k) {
    const float u =
        static_cast<float>(k) * static_cast<float>(n - 1) / static_cast<float>(samples - 1);
    const std::uint32_t i = std::min(static_cast<std::uint32_t>(u), n - 2);
    basis.push_back(catmullRom(i, u - static_cast<float>(i), n));
  }
  rows.resize(guides.guideCount() * kRows * samples + kLanes);
  lower.resize(guides.groupCount());
  upper.resize(guides.groupCount());
}

void sampleGuides(const GuideStrands& guides, GuideCurves& curves) {
  const glm::mat3 turn = glm::mat3_cast(guides.worldFromHead.rotation);
  const auto sample = HWY_DYNAMIC_DISPATCH(sampleGroups);
  parallelFor(guides.groupCount(), 2, [&](std::size_t begin, std::size_t end) {
    sample(guides, turn, begin, end, curves);
  });
}

}  // namespace hair

#endif  // HWY_ONCE
