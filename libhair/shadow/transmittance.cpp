// Transmittance from counts: a walk along the light that multiplies the light by exp(-optical
// depth) of each cell. Threads share the rows of bricks across the light; a row is walked in runs
// (all slices of one brick that follow each other):
//
//     light -->       run 0  |   run 1   |   run 2   |   run 3   |
//     column y = 0    ones   | [ B0    ] |  B0'      | [ B1    ] |   [B]: a brick; its own layers
//     column y = 1    ones   |  ones     | [ B2    ] |  B2'      |   B': no brick; the last layer
//     of B
//
// lightIn gets a code for each run and column, which says where its transmittance is stored
// (Transmittances in transmittances.h). A brick has one layer more than slices, for the light
// that enters it, and one column more than cells, a copy of its neighbour's first:
//
//     layer 0 |slice 0| layer 1 |slice 1| layer 2 |slice 2| layer 3 |slice 3| layer 4
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/shadow/transmittance.cpp"
#include <algorithm>

#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>

#include <libhair/core/simd-inl.h>
#include <libhair/density/grid_cells.h>
#include <libhair/shadow/brick_range.h>
#include <libhair/shadow/density_map.h>
#include <libhair/shadow/transmittances.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

static_assert(brick::kY == kLanes);

/// Consecutive slices of one brick.
struct Run {
  int slice;  // the first, in its brick
  int count;
};

/// Attenuates the light through a run of a brick. `light`: the layer that enters. Writes that to
/// `out`, and after it the layers that leave each slice.
HWY_INLINE void attenuate(const std::uint32_t* counts, Run run, float depth, const float* light,
                          float* out) {
  // Round light below this to none: it is invisible, and denormals would be slow.
  const Floats dark(1e-30f), zero(0.0f);
  const auto cells = reinterpret_cast<const std::int32_t*>(counts) + run.slice * brick::kLayer;
  for (int z = 0; z < brick::kZ; ++z) {
    Floats t = loadFloats(light + z * Transmittances::kRow);
    float* to = out + z * Transmittances::kRow;
    store(t, to);
    for (int s = 0; s < run.count; ++s) {
      const Ints count = loadInts(cells + s * brick::kLayer + z * brick::kY);
      if (any(!(count == Ints(0)))) {
        t = t * expMinusApproximate(toFloatsUnsigned(count) * depth);
        t = select(t < dark, zero, t);
      }
      to += Transmittances::kLayer;
      store(t, to);
    }
  }
}

/// Fills the padding column of a brick's layers with the first column of its neighbour's. Where
/// there is no neighbour the light is constant: all layers get that of `next`.
HWY_INLINE void copyNeighbour(int layers, const float* next, bool constant, float* out) {
  const int step = constant ? 0 : Transmittances::kLayer;
  for (int layer = 0; layer < layers; ++layer)
    for (int z = 0; z < brick::kZ; ++z)
      out[layer * Transmittances::kLayer + z * Transmittances::kRow + brick::kY] =
          next[layer * step + z * Transmittances::kRow];
}

/// Prefetches a brick of the next run.
HWY_INLINE void prefetch(std::uint32_t slot, DensityMap& map) {
  if (slot == 0) return;
  const std::uint32_t* counts = map.grid.cells->bricks.cells(slot);
  const float* out = map.bricks->values.layer(Transmittances::code(slot));
  for (std::size_t c = 0; c < brick::kCells; c += kLanes) {
    hwy::Prefetch(counts + c);
    hwy::Prefetch(out + c);
  }
}

/// Walks one row of bricks across the light, in the columns of `range`.
void walkRow(std::size_t z, BrickRange range, DensityMap& map) {
  // Let full light enter: run 0 reads the layer of ones, 0.
  const BrickStore& bricks = map.grid.cells->bricks;
  const auto perRow = static_cast<std::size_t>(bricks.perAxis().y);
  const int slices = map.grid.depth();
  LitBricks& lit = *map.bricks;
  std::uint32_t* before = lit.lightIn.data() + z * perRow;
  for (int i = 0; i < range.count; ++i) before[range.at(i)] = Transmittances::kFixed;
  std::uint32_t last = 0;  // slice of the previous run
  for (int s = 0; s < slices;) {
    // Find the run: up to the end of its brick, of the wrap-around, or of the hair.
    const int first = map.grid.wrap(map.grid.cells->frame.base.x + map.grid.lower.x + s);
    const auto slice = static_cast<std::uint32_t>(first % brick::kX);
    const Run run{static_cast<int>(slice), std::min({brick::kX - static_cast<int>(slice),
                                                     map.grid.settings.cells - first, slices - s})};
    const std::uint32_t* slots = bricks.slots(bricks.place({first, 0, 0}) + z * perRow);
    std::uint32_t* codes = before + bricks.across();
    const std::uint32_t* next = nullptr;
    if (s + run.count < slices && first + run.count < map.grid.settings.cells)
      next = slots + bricks.across();
    // The layer that enters the run: a brick's own, elsewhere the one that all its slices read.
    const auto entering = [&](std::size_t y) HWY_ATTR {
      return lit.values.layer(slots[y] ? codes[y] - 1 + slice : codes[y] & ~Transmittances::kFixed);
    };
    // Carry the last layer of the previous run into each column, and attenuate it where a brick is.
    for (int i = 0; i < range.count; ++i) {
      const std::size_t y = range.at(i);
      if (next) prefetch(next[y], map);
      const std::uint32_t held = before[y] & Transmittances::kFixed ? before[y] : before[y] + last;
      codes[y] = held | Transmittances::kFixed;
      if (slots[y] == 0) continue;
      codes[y] = Transmittances::code(slots[y]);
      attenuate(bricks.cells(slots[y]), run, map.grid.quantum,
                lit.values.layer(held & ~Transmittances::kFixed), entering(y));
    }
    // Pad each brick from its neighbour. After the last one any will do: no filter reads there.
    for (int i = 0; i < range.count; ++i) {
      const std::size_t y = range.at(i);
      if (slots[y] == 0) continue;
      const std::size_t beside = range.at(i + 1 < range.count ? i + 1 : 0);
      copyNeighbour(run.count + 1, entering(beside), slots[beside] == 0, entering(y));
    }
    // Go on with the next run.
    before = codes;
    last = static_cast<std::uint32_t>(run.slice + run.count - 1);
    s += run.count;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <libhair/core/parallel.h>

namespace hair {

HWY_EXPORT(walkRow);

namespace {

/// Finds the run and the slice of its brick of every slice of the hair.
void findSlices(DensityMap& map) {
  const auto across = static_cast<std::int32_t>(map.grid.cells->bricks.across());
  const int n = map.grid.settings.cells,
            begin = map.grid.wrap(map.grid.cells->frame.base.x + map.grid.lower.x);
  const auto slices = static_cast<std::size_t>(map.grid.depth());
  // Reserve for the deepest hair, as that of a later frame may be deeper.
  LitBricks& lit = *map.bricks;
  lit.sliceRun.reserve(static_cast<std::size_t>(n) + 1);
  lit.sliceInBrick.reserve(static_cast<std::size_t>(n) + 1);
  lit.sliceRun.resize(slices + 1);
  lit.sliceInBrick.resize(slices + 1);
  lit.sliceRun[0] = lit.sliceInBrick[0] = 0;
  for (std::size_t s = 0; s < slices; ++s) {
    // Begin another run where the index wraps around.
    const int straight = begin + static_cast<int>(s);
    const bool turned = straight >= n;
    const int wrapped = turned ? straight - n : straight;
    const int run = turned ? (n - 1) / brick::kX - begin / brick::kX + 1 + wrapped / brick::kX
                           : wrapped / brick::kX - begin / brick::kX;
    lit.sliceRun[1 + s] = (run + 1) * across;
    lit.sliceInBrick[1 + s] = wrapped % brick::kX;
  }
}

}  // namespace

void computeTransmittance(DensityMap& map) {
  map.bricks->values.reserve(map.grid.cells->bricks.room());
  findSlices(map);
  // Count the runs, at most: run 0 before all hair, one per brick along the light, of which the
  // first and the last may be entered in part, and one more where the index wraps around.
  const auto runs = static_cast<std::size_t>(map.grid.depth()) / brick::kX + 4;
  map.bricks->lightIn.reserve((static_cast<std::size_t>(map.grid.cells->bricks.perAxis().x) + 4) *
                              map.grid.cells->bricks.across());
  // Give new codes a valid layer: filters read codes beside the hair, but do not use their values.
  map.bricks->lightIn.resize(runs * map.grid.cells->bricks.across(), Transmittances::kFixed);
  // Walk the rows that a filter may read.
  const BrickRange across = bricksToRead(map.grid, 1), rows = bricksToRead(map.grid, 2);
  parallelFor(static_cast<std::size_t>(rows.count), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      HWY_DYNAMIC_DISPATCH(walkRow)(rows.at(static_cast<int>(i)), across, map);
  });
  map.lit = true;
}

}  // namespace hair

#endif
