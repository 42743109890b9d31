#include <libhair/shadow/filter.h>

#include <algorithm>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair {

namespace {

/// a at t = 0, b at t = 1; exactly a where a = b.
float between(float a, float b, float t) {
  return a + t * (b - a);
}

class Sampler {
 public:
  explicit Sampler(const DensityMap& map)
      : map_(map),
        n_(map.settings.cells),
        first_(map.lower.x),
        depth_(map.depth()),
        aliased_(map.aliased()) {}

  /// Value of the point's own cell.
  float own(glm::vec3 u) const {
    const int j = floorToInt(u.y), k = floorToInt(u.z);
    if (beside(j, j, k, k)) return 1;
    const float* row = rowAt(slice(floorToInt(u.x)), map_.wrap(map_.frame.base.z + k));
    return row[map_.wrap(map_.frame.base.y + j)];
  }

  /// Between the cells i-1 and i along the light, and j, j+1, k, k+1 across it, where u.y and u.z
  /// are measured so that cell j stands at coordinate j.
  float linear(glm::vec3 u) const {
    const int i = floorToInt(u.x), j = floorToInt(u.y), k = floorToInt(u.z);
    if (i < first_ || beside(j, j + 1, k, k + 1)) return 1;
    const float a = u.x - static_cast<float>(i);
    const float b = u.y - static_cast<float>(j);
    const float c = u.z - static_cast<float>(k);
    const int j0 = map_.wrap(map_.frame.base.y + j), j1 = j0 + 1 == n_ ? 0 : j0 + 1;
    const int k0 = map_.wrap(map_.frame.base.z + k), k1 = k0 + 1 == n_ ? 0 : k0 + 1;
    // Stored values stand at back faces: the front face of i is the back face of i - 1, and in
    // front of the first slice that is light itself, never the slice that the modulo puts there.
    const int behind = slice(i), front = behind == 0 ? 0 : slice(i - 1);
    const float atFront = across(front, j0, j1, k0, k1, b, c);
    const float atBack = across(behind, j0, j1, k0, k1, b, c);
    return between(atFront, atBack, a);
  }

 private:
  /// None of these cells holds hair, nor does any cell in front of them.
  bool beside(int j0, int j1, int k0, int k1) const {
    return j1 < map_.lower.y || j0 > map_.upper.y || k1 < map_.lower.z || k0 > map_.upper.z;
  }

  /// Row of rowOf for the unwrapped slice i: 0 in front of the hair, the last one behind it.
  int slice(int i) const {
    if (i < first_) return 0;
    const auto s = static_cast<unsigned>(i) - static_cast<unsigned>(first_);
    const auto n = static_cast<unsigned>(n_);
    // Hair deeper than the map: its far end is stored in the slices of its near end (paper, Psi).
    if (aliased_ && s >= n) return static_cast<int>(s % n) + 1;
    return static_cast<int>(std::min(s, static_cast<unsigned>(depth_) - 1)) + 1;
  }

  const float* rowAt(int slice, int k) const {
    return map_.transmittance.data() + map_.rowOf[static_cast<std::size_t>(slice * n_ + k)];
  }

  float across(int slice, int j0, int j1, int k0, int k1, float b, float c) const {
    const float* r0 = rowAt(slice, k0);
    const float* r1 = rowAt(slice, k1);
    return between(between(r0[j0], r0[j1], b), between(r1[j0], r1[j1], b), c);
  }

  const DensityMap& map_;
  int n_, first_, depth_;
  bool aliased_;
};

}  // namespace

void sampleTransmittance(const DensityMap& map, std::span<const glm::vec3> points,
                         std::span<float> out) {
  require(out.size() == points.size(), "sampleTransmittance: ", points.size(),
          " points but room for ", out.size(), " values");
  if (map.empty()) {
    std::fill(out.begin(), out.end(), 1.0f);
    return;
  }
  const Sampler sampler(map);
  parallelFor(points.size(), 2048, [&](std::size_t begin, std::size_t end) {
    switch (map.settings.filter) {
      case Filter::None:
        for (std::size_t p = begin; p < end; ++p)
          out[p] = sampler.own(map.frame.cellCoordinates(points[p]));
        break;
      case Filter::Paper:
        // The point at lambda in cell j is between cell j - 1 (weight 1 - lambda) and j (lambda).
        for (std::size_t p = begin; p < end; ++p)
          out[p] = sampler.linear(map.frame.cellCoordinates(points[p]) - glm::vec3(0, 1, 1));
        break;
      case Filter::Centred:
        // Deviation: the paper's weights put a cell's value at its corner, which shifts shadows
        // sideways by half a cell; across the light a cell's value belongs to its middle.
        for (std::size_t p = begin; p < end; ++p)
          out[p] = sampler.linear(map.frame.cellCoordinates(points[p]) - glm::vec3(0, 0.5f, 0.5f));
        break;
    }
  });
}

}  // namespace hair
