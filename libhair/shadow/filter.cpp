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

/// Where the transmittance of one slice of the map stands: the codes of its run, and which slice of
/// their bricks.
struct Slice {
  const std::uint32_t* codes;  // [across]
  std::uint32_t inBrick;
};

/// Looks up rows of 16 cells.
class Rows {
 public:
  explicit Rows(const DensityMap& map)
      : map_(map),
        n_(map.settings.cells),
        begin_(map.wrap(map.frame.base.x + map.lower.x)),
        depth_(map.depth()),
        perRow_(static_cast<std::size_t>(map.bricks.perAxis().y)),
        aliased_(map.aliased()) {}

  /// The unwrapped slice i: in front of the hair that before it, behind the hair its last one.
  Slice slice(int i) const {
    int s = i - map_.lower.x;
    // Hair deeper than the map: its far end is stored in the slices of its near end (paper, Psi).
    if (aliased_ && s >= n_) s %= n_;
    s = std::min(s, depth_ - 1);
    if (s < 0) return {map_.lightIn.data(), 0};
    const int turned = begin_ + s - n_;  // where the modulo comes round, another run begins
    const int wrapped = turned < 0 ? begin_ + s : turned;
    const int run = turned < 0
                        ? wrapped / brick::kX - begin_ / brick::kX
                        : (n_ - 1) / brick::kX - begin_ / brick::kX + 1 + wrapped / brick::kX;
    return {map_.lightIn.data() + (static_cast<std::size_t>(run) + 1) * map_.bricks.across(),
            static_cast<std::uint32_t>(wrapped % brick::kX)};
  }
  bool lit(Slice s) const { return s.codes == map_.lightIn.data(); }

  /// Cells of wrapped k, brick y along the row.
  const float* row(Slice s, int k, int y) const {
    const std::uint32_t code =
        s.codes[static_cast<std::size_t>(k / brick::kZ) * perRow_ + static_cast<std::size_t>(y)];
    return map_.transmittances.row(code, s.inBrick, k % brick::kZ);
  }
  float value(Slice s, int j, int k) const { return row(s, k, j / brick::kY)[j % brick::kY]; }

 private:
  const DensityMap& map_;
  int n_, begin_, depth_;
  std::size_t perRow_;
  bool aliased_;
};

inline const Lanes kCount = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// The mean of darkness, 1 - transmittance, over the kernel: light itself comes out as exactly 0
/// however the weights round. Rows of cells are summed up as they lie in their bricks, the weights
/// along them, which all rows share, come last.
class FootprintSum {
 public:
  /// Of the unwrapped cells from `first` to `last` along rows, for a point at y.
  FootprintSum(int first, int last, float y, const FootprintKernel& kernel, const DensityMap& map) {
    const int n = map.settings.cells;
    for (int j = first; j <= last;) {
      const int wrapped = map.wrap(map.frame.base.y + j);
      const int from = wrapped % brick::kY;
      const int cells = std::min({brick::kY - from, n - wrapped, last - j + 1});
      Piece& piece = pieces_[count_++];
      piece.brick = wrapped / brick::kY;
      const Lanes lane = kCount - static_cast<float>(from);
      const Lanes w = kernel.weights(y - static_cast<float>(j) - lane);
      // Other cells of the brick are no neighbours where the modulo comes round.
      const Lanes zero{};
      piece.weights = lane < 0 ? zero : lane < static_cast<float>(cells) ? w : zero;
      piece.dark = zero;
      j += cells;
    }
  }

  /// Row k, between two slices, `part` of the way from front to back.
  void add(const Rows& rows, Slice front, Slice back, float part, int k, float weight) {
    for (std::size_t p = 0; p < count_; ++p) {
      const float* f = rows.row(front, k, pieces_[p].brick);
      const float* b = rows.row(back, k, pieces_[p].brick);
      Lanes atFront, atBack;
      std::memcpy(&atFront, f, sizeof atFront);
      std::memcpy(&atBack, b, sizeof atBack);
      pieces_[p].dark += weight * (1.0f - (atFront + part * (atBack - atFront)));
    }
  }

  float darkness() const {
    Lanes sum{};
    for (std::size_t p = 0; p < count_; ++p) sum += pieces_[p].weights * pieces_[p].dark;
    for (std::size_t half = kLanes / 2; half > 0; half /= 2)
      for (std::size_t l = 0; l < half; ++l) sum[l] += sum[l + half];
    return sum[0];
  }

 private:
  static_assert(brick::kY == kLanes);
  struct Piece {
    int brick;
    Lanes weights, dark;
  };
  // 2 h + 2 <= 20 cells; a map of two cells comes round ten times.
  static constexpr std::size_t kMostPieces = 12;
  Piece pieces_[kMostPieces];
  std::size_t count_ = 0;
};

class Sampler {
 public:
  explicit Sampler(const DensityMap& map)
      : map_(map), n_(map.settings.cells), rows_(map), kernel_(map.settings) {}

  /// The values of the points' own cells; at most a batch of points.
  void own(std::span<const glm::vec3> points, std::span<float> out) const {
    CellBatch c;
    c.fill(map_.frame, points, glm::vec3(0));
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Slice slice = rows_.slice(c.i[p]);
      out[p] = beside(c.j[p], c.j[p], c.k[p], c.k[p])
                   ? 1.0f
                   : rows_.value(slice, map_.wrap(map_.frame.base.y + c.j[p]),
                                 map_.wrap(map_.frame.base.z + c.k[p]));
    }
  }

  /// Between the cells i-1 and i along the light, and j, j+1, k, k+1 across it, in coordinates
  /// where cell j stands at j: those of the map less `shift`.
  void linear(std::span<const glm::vec3> points, glm::vec3 shift, std::span<float> out) const {
    CellBatch c;
    c.fill(map_.frame, points, shift);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const int i = c.i[p], j = c.j[p], k = c.k[p];
      // Stored values stand at back faces: the front face of i is the back face of i - 1, and in
      // front of the first slice that is light itself, never the slice that the modulo puts there.
      const Slice back = rows_.slice(i);
      if (rows_.lit(back) || beside(j, j + 1, k, k + 1)) {
        out[p] = 1;
        continue;
      }
      const Slice front = rows_.slice(i - 1);
      const int j0 = map_.wrap(map_.frame.base.y + j), j1 = j0 + 1 == n_ ? 0 : j0 + 1;
      const int k0 = map_.wrap(map_.frame.base.z + k), k1 = k0 + 1 == n_ ? 0 : k0 + 1;
      const float y = c.y[p] - static_cast<float>(j), z = c.z[p] - static_cast<float>(k);
      // Two cells of a row are most often in one brick: then a row is looked up once.
      const int y0 = j0 / brick::kY, y1 = j1 / brick::kY;
      const auto along = [&](Slice s, int row) {
        const float* first = rows_.row(s, row, y0);
        const float* second = y1 == y0 ? first : rows_.row(s, row, y1);
        return between(first[j0 % brick::kY], second[j1 % brick::kY], y);
      };
      const auto across = [&](Slice s) { return between(along(s, k0), along(s, k1), z); };
      out[p] = between(across(front), across(back), c.x[p] - static_cast<float>(i));
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
      const Slice back = rows_.slice(c.i[p]);
      if (rows_.lit(back) || beside(j0, j1, k0, k1)) {
        out[p] = 1;
        continue;
      }
      const Slice front = rows_.slice(c.i[p] - 1);
      const float part = c.x[p] - static_cast<float>(c.i[p]);
      FootprintSum sum(j0, j1, c.y[p], kernel_, map_);
      for (int k = k0; k <= k1;) {
        const Lanes weights = kernel_.weights(c.z[p] - static_cast<float>(k) - kCount);
        for (std::size_t l = 0; l < kLanes && k <= k1; ++l, ++k)
          sum.add(rows_, front, back, part, map_.wrap(map_.frame.base.z + k), weights[l]);
      }
      const float dark = sum.darkness();
      out[p] = std::min(std::max(1 - dark, 0.0f), 1.0f);
    }
  }

 private:
  /// None of these cells holds hair, nor does any cell in front of them.
  bool beside(int j0, int j1, int k0, int k1) const {
    return (j1 < map_.lower.y) | (j0 > map_.upper.y) | (k1 < map_.lower.z) | (k0 > map_.upper.z);
  }

  const DensityMap& map_;
  int n_;
  Rows rows_;
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
  require(map.lit, "sampleTransmittance: computeTransmittance() of what was deposited comes first");
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
