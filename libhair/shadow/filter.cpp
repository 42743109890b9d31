// Transmittance at points, from the values of cells, sixteen points at once. Along the light all
// filters but None are linear between the faces of a point's cell; values stand at back faces:
//
//     light -->    |  cell i-1  |   cell i   |
//               T[i-2]       T[i-1]        T[i]      T = (1 - x) T[i-1] + x T[i]
//                                 x ->
//
// Across the light they are linear, too, between values (o) at other places:
//
//     |  j-1  |   j   |  j+1  |
//     |       o----p--o       |    Paper: the value of a cell is at its far wall
//     |       |   op--+---o   |    Centred: the value of a cell is at its centre
//
// Footprint is the mean of Centred over a square about the point.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/shadow/filter.cpp"
#include <algorithm>
#include <cmath>

#include <hwy/foreach_target.h>

#include <libhair/density/cells-inl.h>
#include <libhair/shadow/density_map.h>
#include <libhair/shadow/footprint-inl.h>
#include <libhair/shadow/transmittances.h>

#ifndef HAIR_SHADOW_FILTER_VIEW
#define HAIR_SHADOW_FILTER_VIEW
namespace hair {

/// What the kernels read.
struct FilterView {
  const DensityMap& map;
  FootprintKernel kernel;
  float scale;
  int perRow;  // bricks along y
  int seam;    // the last cell of an axis, if its brick is cut off by the wrap-around; or -1
};

}  // namespace hair
#endif

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// Look-ups of transmittance in sixteen cells at once.
class Cells {
 public:
  HWY_INLINE explicit Cells(const FilterView& view)
      : view_(view),
        map_(view.map),
        lit_(*view.map.bricks),
        codes_(view.map.grid),
        n_(map_.grid.settings.cells),
        deepest_(map_.grid.depth() - 1),
        aliased_(map_.aliased()) {}

  /// The slices i - 1 (front) and i (back) of each lane.
  struct Slices {
    Ints codes;    // index in lightIn of the run of the back slice
    Ints inBrick;  // its index in its brick
    Mask lit;      // the back slice is in front of the hair
    Mask first;    // the front slice is in front of the hair
    Mask behind;   // the back slice is behind the hair: both read the last slice
  };
  /// Of unwrapped slices i.
  HWY_INLINE Slices slices(Ints i) const {
    Ints s = i - Ints(map_.grid.lower.x);
    // Wrap slices of hair deeper than the map: its far end shares those of its near end (paper,
    // Psi).
    if (HWY_UNLIKELY(aliased_)) s = wrapSlices(s);
    const Ints at = min(max(s, Ints(-1)), Ints(deepest_)) + Ints(1);
    return {gather(lit_.sliceRun.data(), at), gather(lit_.sliceInBrick.data(), at), at == Ints(0),
            at == Ints(1), s > Ints(deepest_)};
  }
  HWY_INLINE const CellCodes& codes() const { return codes_; }

  /// Index of the value of wrapped cells j, k in the back slice, and its distance from that in the
  /// front slice.
  struct Place {
    Ints back, toFront;
    Mask fixed;  // there is no brick
  };
  HWY_INLINE Place place(const Slices& s, Ints j, Ints k) const {
    const Ints brick = shiftRight<2>(k) * Ints(view_.perRow) + shiftRight<4>(j);
    const Ints code = gather(lit_.lightIn.data(), s.codes + brick);
    const Mask fixed = code < Ints(0);
    const Ints layer = (code & Ints(0x7fffffff)) + select(fixed, Ints(0), s.inBrick);
    return {layer * Ints(Transmittances::kLayer) + (k & Ints(3)) * Ints(Transmittances::kRow) +
                (j & Ints(15)),
            select(fixed | s.behind, Ints(0), Ints(Transmittances::kLayer)), fixed};
  }
  HWY_INLINE Floats value(Ints place) const { return gather(lit_.values.data(), place); }

  /// Indices of wrapped cells j and j + 1 in the front and the back slice.
  struct Row {
    Ints front, back;
    // Lanes in which cell j + 1 does not follow cell j in memory.
    bool anyElsewhere;
    Mask elsewhere;
    Ints frontNext, backNext;
  };
  HWY_INLINE Row row(const Slices& s, Ints j, Ints k) const {
    const Place here = place(s, j, k);
    Row r;
    r.front = here.back - here.toFront, r.back = here.back;
    // The padding column is valid only in bricks that exist, and that the wrap-around does not cut.
    const Mask edge = ((j & Ints(15)) == Ints(15)) & here.fixed;
    r.elsewhere = edge | (j == Ints(view_.seam));
    r.anyElsewhere = any(r.elsewhere);
    if (HWY_UNLIKELY(r.anyElsewhere)) {
      const Place beside = place(s, codes_.next(j), k);
      r.frontNext = beside.back - beside.toFront, r.backNext = beside.back;
    }
    return r;
  }
  /// Values of cells j and j + 1.
  struct RowValues {
    Pairs front, back;
  };
  HWY_INLINE RowValues values(const Row& row) const {
    const float* values = lit_.values.data();
    RowValues r{gatherPairs(values, row.front), gatherPairs(values, row.back)};
    if (HWY_UNLIKELY(row.anyElsewhere)) {
      r.front.second = select(row.elsewhere, value(row.frontNext), r.front.second);
      r.back.second = select(row.elsewhere, value(row.backNext), r.back.second);
    }
    return r;
  }

  /// All columns from j0 to j1 and k0 to k1 are outside of the hair's bounds.
  HWY_INLINE Mask beside(Ints j0, Ints j1, Ints k0, Ints k1) const {
    return (j1 < Ints(map_.grid.lower.y)) | (j0 > Ints(map_.grid.upper.y)) |
           (k1 < Ints(map_.grid.lower.z)) | (k0 > Ints(map_.grid.upper.z));
  }
  const DensityMap& map() const { return map_; }
  const LitBricks& lit() const { return lit_; }
  const FilterView& view() const { return view_; }

 private:
  static_assert(brick::kX == 4 && brick::kY == 16 && brick::kZ == 4);

  HWY_NOINLINE Ints wrapSlices(Ints slices) const {
    std::int32_t each[kLanes];
    store(slices, each);
    for (std::int32_t& s : each) s = s >= n_ ? s % n_ : s;
    return loadInts(each);
  }

  const FilterView& view_;
  const DensityMap& map_;
  const LitBricks& lit_;
  CellCodes codes_;
  int n_, deepest_;
  bool aliased_;
};

/// a at t = 0, b at t = 1; exactly a where a = b.
HWY_INLINE Floats between(Floats a, Floats b, Floats t) {
  return a + t * (b - a);
}

/// Filter::None: the values of the points' own cells.
HWY_INLINE Floats own(const Cells& cells, Vec3 u) {
  const CellCodes& codes = cells.codes();
  const Ints i = floorToInt(u.x), j = floorToInt(u.y), k = floorToInt(u.z);
  const Floats t =
      cells.value(cells.place(cells.slices(i), codes.wrap(j, 1), codes.wrap(k, 2)).back);
  return select(cells.beside(j, j, k, k), Floats(1.0f), t);
}

/// Filter::Paper and Centred: cells i-1 and i along the light, and j, j+1, k, k+1 across it, in
/// coordinates where the value of cell j is at j: those of the map minus `shift`. Constructed for
/// several vectors of points before any is read, so that their look-ups overlap.
struct Linear {
  Floats x, y, z;  // fractions from the first cell to the second
  Cells::Row low, high;
  Mask first, outside;

  Linear() = default;
  HWY_INLINE Linear(const Cells& cells, Vec3 u, float shift) {
    const CellCodes& codes = cells.codes();
    y = u.y - shift, z = u.z - shift;
    const Ints i = floorToInt(u.x), j = floorToInt(y), k = floorToInt(z);
    x = u.x - toFloats(i), y = y - toFloats(j), z = z - toFloats(k);
    const Ints j0 = codes.wrap(j, 1), k0 = codes.wrap(k, 2);
    const Cells::Slices slices = cells.slices(i);
    low = cells.row(slices, j0, k0);
    high = cells.row(slices, j0, codes.next(k0));
    first = slices.first;
    outside = slices.lit | cells.beside(j, j + Ints(1), k, k + Ints(1));
  }
  HWY_INLINE Floats value(const Cells& cells) const {
    const Cells::RowValues a = cells.values(low), b = cells.values(high);
    const auto across = [&](const Pairs& l, const Pairs& h) HWY_ATTR {
      return between(between(l.first, l.second, y), between(h.first, h.second, y), z);
    };
    // The front face of cell i is the back face of cell i - 1. Before the first slice it is full
    // light, never the slice that the modulo puts there.
    const Floats front = select(first, Floats(1.0f), across(a.front, b.front));
    return select(outside, Floats(1.0f), between(front, across(a.back, b.back), x));
  }
};

/// Filter::Footprint: the mean of darkness, 1 - transmittance, over FootprintKernel, as full light
/// then gives exactly 0 for any rounding of the weights. Sums rows of cells in pieces of one brick
/// each, and multiplies by the weights along the rows, which all rows share, at the end.
class FootprintSum {
 public:
  /// Cuts the unwrapped cells from `first` to `last` of a row into pieces, with the weights for a
  /// point at y.
  FootprintSum(int first, int last, float y, const Cells& cells) {
    const DensityGrid& grid = cells.map().grid;
    const int n = grid.settings.cells, baseY = grid.cells->frame.base.y;
    for (int j = first; j <= last;) {
      const int wrapped = grid.wrap(baseY + j);
      const int from = wrapped % brick::kY;
      const int count = std::min({brick::kY - from, n - wrapped, last - j + 1});
      Piece& piece = pieces_[count_++];
      piece.brick = wrapped / brick::kY;
      const Floats lane = toFloats(laneNumbers() - Ints(from));
      const Floats w = footprintWeights(cells.view().kernel, y - static_cast<float>(j) - lane);
      // Clear the weights of the brick's other cells, which may be elsewhere after a wrap-around.
      const Floats zero(0.0f);
      const Mask inside = (lane >= zero) & (lane < Floats(static_cast<float>(count)));
      piece.weights = select(inside, w, zero);
      piece.dark = zero;
      j += count;
    }
  }

  /// The two slices of a point, as in Cells::Slices.
  struct Rows {
    std::int32_t codes;
    std::uint32_t inBrick;
    bool first, behind;
    float part;  // fraction from front to back
  };
  /// Adds the wrapped row k.
  void add(const Cells& cells, const Rows& rows, int k, float weight) {
    const LitBricks& lit = cells.lit();
    const std::uint32_t* codes =
        lit.lightIn.data() + rows.codes + k / brick::kZ * cells.view().perRow;
    for (std::size_t p = 0; p < count_; ++p) {
      const std::uint32_t code = codes[pieces_[p].brick];
      const float* at = lit.values.row(code, rows.inBrick, k % brick::kZ);
      const bool same = rows.behind || (code & Transmittances::kFixed);
      const Floats back = loadFloats(at);
      const Floats front =
          rows.first ? Floats(1.0f) : loadFloats(same ? at : at - Transmittances::kLayer);
      pieces_[p].dark = pieces_[p].dark + weight * (1.0f - (front + rows.part * (back - front)));
    }
  }
  /// The weighted sum.
  float darkness() const {
    Floats sum(0.0f);
    for (std::size_t p = 0; p < count_; ++p) sum = sum + pieces_[p].weights * pieces_[p].dark;
    float lane[kLanes];
    store(sum, lane);
    for (std::size_t half = kLanes / 2; half > 0; half /= 2)
      for (std::size_t l = 0; l < half; ++l) lane[l] += lane[l + half];
    return lane[0];
  }

 private:
  static_assert(brick::kY == kLanes);
  struct Piece {
    int brick;
    Floats weights, dark;
  };
  // 2 h + 2 <= 20 cells, in which a map of two cells wraps around ten times.
  static constexpr std::size_t kMostPieces = 12;
  Piece pieces_[kMostPieces];
  std::size_t count_ = 0;
};

/// Filter::Footprint of up to sixteen points, one after another: lanes are cells of a row.
HWY_INLINE void footprint(const Cells& cells, Vec3 u, std::size_t count, float* out) {
  // Find slices, cells and bounds of all points.
  const DensityGrid& grid = cells.map().grid;
  const int baseZ = grid.cells->frame.base.z;
  const FootprintKernel& kernel = cells.view().kernel;
  const Floats x = u.x, y = u.y - 0.5f, z = u.z - 0.5f;
  const Floats h(kernel.halfWidth);
  const Ints i = floorToInt(x);
  const Ints j0 = floorToInt(y - h), j1 = floorToInt(y + h) + Ints(1);
  const Ints k0 = floorToInt(z - h), k1 = floorToInt(z + h) + Ints(1);
  const Cells::Slices slices = cells.slices(i);
  const std::uint32_t outside = bits(slices.lit | cells.beside(j0, j1, k0, k1));
  const std::uint32_t first = bits(slices.first), behind = bits(slices.behind);
  std::int32_t firstJ[kLanes], lastJ[kLanes], firstK[kLanes], lastK[kLanes];
  std::int32_t codes[kLanes], inBrick[kLanes];
  float part[kLanes], across[kLanes], along[kLanes];
  store(j0, firstJ), store(j1, lastJ), store(k0, firstK), store(k1, lastK);
  store(slices.codes, codes), store(slices.inBrick, inBrick);
  store(x - toFloats(i), part), store(y, along), store(z, across);
  for (std::size_t p = 0; p < count; ++p) {
    if (outside >> p & 1) {
      out[p] = 1;
      continue;
    }
    // Sum the rows of one point, sixteen weights across them at a time.
    FootprintSum sum(firstJ[p], lastJ[p], along[p], cells);
    const FootprintSum::Rows rows{codes[p], static_cast<std::uint32_t>(inBrick[p]),
                                  (first >> p & 1) != 0, (behind >> p & 1) != 0, part[p]};
    for (int k = firstK[p]; k <= lastK[p];) {
      float weights[kLanes];
      store(footprintWeights(kernel, across[p] - static_cast<float>(k) - toFloats(laneNumbers())),
            weights);
      for (std::size_t l = 0; l < kLanes && k <= lastK[p]; ++l, ++k)
        sum.add(cells, rows, grid.wrap(baseZ + k), weights[l]);
    }
    out[p] = std::min(std::max(1 - sum.darkness(), 0.0f), 1.0f);
  }
}

void sampleAll(const FilterView& view, const glm::vec3* points, std::size_t count, float* out) {
  constexpr std::size_t kVectors = 4;
  const Cells cells(view);
  const CellFrame& frame = view.map.grid.cells->frame;
  const Filter filter = view.map.settings.filter;
  // Paper: a point at lambda in cell j is between cells j - 1 (weight 1 - lambda) and j (lambda).
  // Deviation, Centred: the paper's weights put a cell's value at its corner, which shifts shadows
  // sideways by half a cell; across the light a cell's value belongs to its middle.
  const float shift = filter == Filter::Paper ? 1.0f : 0.5f;
  // Locate the cells of up to four vectors of points, then read them.
  for (std::size_t p = 0; p < count; p += kVectors * kLanes) {
    const std::size_t here = std::min(count - p, kVectors * kLanes);
    const std::size_t vectors = (here + kLanes - 1) / kLanes;
    float t[kVectors * kLanes];
    Linear linear[kVectors];
    for (std::size_t v = 0; v < vectors; ++v) {
      const std::size_t first = p + v * kLanes;
      const Vec3 u = cellCoordinates(frame, loadPoints(points + first, count - first));
      if (filter == Filter::None)
        store(own(cells, u), t + v * kLanes);
      else if (filter == Filter::Footprint)
        footprint(cells, u, std::min(count - first, kLanes), t + v * kLanes);
      else
        linear[v] = Linear(cells, u, shift);
    }
    if (filter == Filter::Paper || filter == Filter::Centred)
      for (std::size_t v = 0; v < vectors; ++v) store(linear[v].value(cells), t + v * kLanes);
    // Take off the strand's own shadow (`scale`), up to full light.
    for (std::size_t l = 0; l < here; ++l) out[p + l] = std::min(t[l] * view.scale, 1.0f);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair {

HWY_EXPORT(sampleAll);

TransmittanceSampler::TransmittanceSampler(const DensityMap& map, Of what) : map_(map), scale_(1) {
  if (map.empty()) return;
  require(map.lit, "sampleTransmittance: computeTransmittance() of what was deposited comes first");
  if (what == Of::Strands)
    scale_ = std::exp(0.5f * map.fibreShadow / map.settings.cellSize *
                      FootprintKernel(map.settings).onALine());
}

void TransmittanceSampler::sample(std::span<const glm::vec3> points, std::span<float> out) const {
  require(out.size() == points.size(), "sampleTransmittance: ", points.size(),
          " points but room for ", out.size(), " values");
  if (map_.empty()) {
    std::fill(out.begin(), out.end(), 1.0f);
    return;
  }
  const int n = map_.settings.cells;
  const FilterView view{map_, FootprintKernel(map_.settings), scale_,
                        map_.grid.cells->bricks.perAxis().y, n % brick::kY == 0 ? -1 : n - 1};
  HWY_DYNAMIC_DISPATCH(sampleAll)(view, points.data(), points.size(), out.data());
}

namespace {

void sampleInParallel(const TransmittanceSampler& sampler, std::span<const glm::vec3> points,
                      std::span<float> out) {
  require(out.size() == points.size(), "sampleTransmittance: ", points.size(),
          " points but room for ", out.size(), " values");
  parallelFor(points.size(), 2048, [&](std::size_t begin, std::size_t end) {
    sampler.sample(points.subspan(begin, end - begin), out.subspan(begin, end - begin));
  });
}

}  // namespace

void sampleTransmittance(const DensityMap& map, std::span<const glm::vec3> points,
                         std::span<float> out) {
  sampleInParallel({map, TransmittanceSampler::Of::Points}, points, out);
}

void sampleStrandTransmittance(const DensityMap& map, StrandView strands, std::span<float> out) {
  sampleInParallel({map, TransmittanceSampler::Of::Strands}, strands.points, out);
}

}  // namespace hair

#endif
