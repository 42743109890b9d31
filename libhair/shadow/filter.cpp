#include <libhair/shadow/filter.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <libhair/core/error.h>
#include <libhair/core/lanes.h>
#include <libhair/core/parallel.h>
#include <libhair/shadow/cell_batch.h>
#include <libhair/shadow/footprint.h>

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
        aliased_(map.aliased()),
        kernel_(map.settings) {}

  /// The values of the points' own cells; at most a batch of points.
  void own(std::span<const glm::vec3> points, std::span<float> out) const {
    CellBatch c;
    c.fill(map_.frame, points, glm::vec3(0));
    for (std::size_t p = 0; p < points.size(); ++p) {
      const int i = beside(c.j[p], c.j[p], c.k[p], c.k[p]) ? 0 : slice(c.i[p]);
      const int j = map_.wrap(map_.frame.base.y + c.j[p]);
      const int k = map_.wrap(map_.frame.base.z + c.k[p]);
      out[p] = rowAt(i, k)[j];
    }
  }

  /// Between the cells i-1 and i along the light, and j, j+1, k, k+1 across it, in coordinates
  /// where cell j stands at j: those of the map less `shift`.
  void linear(std::span<const glm::vec3> points, glm::vec3 shift, std::span<float> out) const {
    CellBatch c;
    c.fill(map_.frame, points, shift);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const int i = c.i[p], j = c.j[p], k = c.k[p];
      const bool lit = beside(j, j + 1, k, k + 1);
      // Stored values stand at back faces: the front face of i is the back face of i - 1, and in
      // front of the first slice that is light itself, never the slice that the modulo puts there.
      const int back = lit ? 0 : slice(i), front = back == 0 ? 0 : slice(i - 1);
      const int j0 = map_.wrap(map_.frame.base.y + j), j1 = j0 + 1 == n_ ? 0 : j0 + 1;
      const int k0 = map_.wrap(map_.frame.base.z + k), k1 = k0 + 1 == n_ ? 0 : k0 + 1;
      const float y = c.y[p] - static_cast<float>(j), z = c.z[p] - static_cast<float>(k);
      const float atFront = across(front, j0, j1, k0, k1, y, z);
      const float atBack = across(back, j0, j1, k0, k1, y, z);
      out[p] = between(atFront, atBack, c.x[p] - static_cast<float>(i));
    }
  }

  /// As `linear` along the light; across it the mean over FootprintKernel.
  void footprint(std::span<const glm::vec3> points, std::span<float> out) const {
    CellBatch c;
    c.fill(map_.frame, points, {0, 0.5f, 0.5f});
    const float h = kernel_.halfWidth;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const int j0 = floorToInt(c.y[p] - h), j1 = floorToInt(c.y[p] + h) + 1;
      const int k0 = floorToInt(c.z[p] - h), k1 = floorToInt(c.z[p] + h) + 1;
      const int back = beside(j0, j1, k0, k1) ? 0 : slice(c.i[p]);
      if (back == 0) {
        out[p] = 1;
        continue;
      }
      const int front = slice(c.i[p] - 1);
      const RowWeights weights(j0, j1, c.y[p], kernel_, map_);
      float atFront = 0, atBack = 0;
      for (int k = k0; k <= k1; ++k) {
        const float w = kernel_.weight(c.z[p] - static_cast<float>(k));
        const int wrapped = map_.wrap(map_.frame.base.z + k);
        atFront += w * weights.darkness(rowAt(front, wrapped));
        atBack += w * weights.darkness(rowAt(back, wrapped));
      }
      const float dark = between(atFront, atBack, c.x[p] - static_cast<float>(c.i[p]));
      out[p] = std::min(std::max(1 - dark, 0.0f), 1.0f);
    }
  }

 private:
  /// The weights of the kernel along a row, and where they begin. Sums what is missing to full
  /// light, so that light itself comes out as exactly 1 however the weights round.
  class RowWeights {
   public:
    RowWeights(int first, int last, float y, const FootprintKernel& kernel, const DensityMap& map)
        : map_(map), first_(map.frame.base.y + first), begin_(map.wrap(first_)) {
      count_ = last - first + 1;
      chunks_ = (static_cast<std::size_t>(count_) + kLanes - 1) / kLanes;
      wraps_ = begin_ + static_cast<int>(chunks_ * kLanes) > map.settings.cells;
      for (std::size_t m = 0; m < chunks_; ++m)
        for (std::size_t l = 0; l < kLanes; ++l)
          weights_[m][l] =
              kernel.weight(y - static_cast<float>(first + static_cast<int>(m * kLanes + l)));
    }
    float darkness(const float* row) const {
      Lanes sum{};
      for (std::size_t m = 0; m < chunks_; ++m) {
        Lanes t;
        if (!wraps_) {
          std::memcpy(&t, row + begin_ + m * kLanes, sizeof t);
        } else {
          for (std::size_t l = 0; l < kLanes; ++l)
            t[l] = row[map_.wrap(first_ + static_cast<int>(m * kLanes + l))];
        }
        sum += weights_[m] * (1.0f - t);
      }
      return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
    }

   private:
    static constexpr std::size_t kMostChunks = 3;  // 2 h + 2 <= 2 · 8.7 + 2 cells
    const DensityMap& map_;
    int first_, begin_, count_;
    std::size_t chunks_;
    bool wraps_;
    Lanes weights_[kMostChunks];
  };

  /// None of these cells holds hair, nor does any cell in front of them.
  bool beside(int j0, int j1, int k0, int k1) const {
    return (j1 < map_.lower.y) | (j0 > map_.upper.y) | (k1 < map_.lower.z) | (k0 > map_.upper.z);
  }

  /// Row of rowOf for the unwrapped slice i: 0 in front of the hair, the last one behind it.
  int slice(int i) const {
    const int s = i - first_ + 1;
    // Hair deeper than the map: its far end is stored in the slices of its near end (paper, Psi).
    if (aliased_ && s > n_) return (s - 1) % n_ + 1;
    return std::min(std::max(s, 0), depth_);
  }

  const float* rowAt(int slice, int k) const {
    return map_.transmittance.data() +
           map_.rowOf[static_cast<std::size_t>(slice) * static_cast<std::size_t>(n_) +
                      static_cast<std::size_t>(k)];
  }

  float across(int slice, int j0, int j1, int k0, int k1, float y, float z) const {
    const float* r0 = rowAt(slice, k0);
    const float* r1 = rowAt(slice, k1);
    return between(between(r0[j0], r0[j1], y), between(r1[j0], r1[j1], y), z);
  }

  const DensityMap& map_;
  int n_, first_, depth_;
  bool aliased_;
  FootprintKernel kernel_;
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
    for (std::size_t p = begin; p < end; p += CellBatch::kSize) {
      const std::size_t count = std::min(end - p, CellBatch::kSize);
      const auto from = points.subspan(p, count);
      const auto to = out.subspan(p, count);
      switch (map.settings.filter) {
        case Filter::None:
          sampler.own(from, to);
          break;
        case Filter::Paper:
          // The point at lambda in cell j is between cells j - 1 (weight 1 - lambda) and j
          // (lambda).
          sampler.linear(from, {0, 1, 1}, to);
          break;
        case Filter::Centred:
          // Deviation: the paper's weights put a cell's value at its corner, which shifts shadows
          // sideways by half a cell; across the light a cell's value belongs to its middle.
          sampler.linear(from, {0, 0.5f, 0.5f}, to);
          break;
        case Filter::Footprint:
          sampler.footprint(from, to);
          break;
      }
    }
  });
}

void sampleStrandTransmittance(const DensityMap& map, StrandView strands, std::span<float> out) {
  sampleTransmittance(map, strands.points, out);
  const float own =
      0.5f * map.fibreShadow / map.settings.cellSize * FootprintKernel(map.settings).onALine();
  const float without = std::exp(own);
  for (float& t : out) t = std::min(t * without, 1.0f);
}

}  // namespace hair
