#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/shadow/transmittance.cpp"
#include <algorithm>

#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>

#include <libhair/core/simd-inl.h>
#include <libhair/shadow/brick_range.h>
#include <libhair/shadow/transmittance.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

static_assert(brick::kY == kLanes);

/// Slices of one brick that follow each other.
struct Run {
  int slice;  // the first, in its brick
  int count;
};

/// Walks a brick. `light`: the layer that enters it; `out`: that of what enters the run's first
/// slice, and then those of what leaves each.
HWY_INLINE void attenuate(const std::uint32_t* counts, Run run, float depth, const float* light,
                          float* out) {
  // Below this no display and no sum can tell the light from none; denormals would be slow.
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

/// The last column of a brick's layers: the first one of the next brick's. Where no brick is, the
/// light does not change: all layers are as `constant`.
HWY_INLINE void copyNeighbour(int layers, const float* next, bool constant, float* out) {
  const int step = constant ? 0 : Transmittances::kLayer;
  for (int layer = 0; layer < layers; ++layer)
    for (int z = 0; z < brick::kZ; ++z)
      out[layer * Transmittances::kLayer + z * Transmittances::kRow + brick::kY] =
          next[layer * step + z * Transmittances::kRow];
}

/// Brings a brick from memory that is soon to be walked.
HWY_INLINE void prefetch(std::uint32_t slot, DensityMap& map) {
  if (slot == 0) return;
  const std::uint32_t* counts = map.grid.bricks.cells(slot);
  const float* out = map.transmittances.layer(Transmittances::code(slot));
  for (std::size_t c = 0; c < brick::kCells; c += kLanes) {
    hwy::Prefetch(counts + c);
    hwy::Prefetch(out + c);
  }
}

/// The columns of one row of bricks across the light, of those in `range`.
void walkRow(std::size_t z, BrickRange range, DensityMap& map) {
  const BrickStore& bricks = map.grid.bricks;
  const auto perRow = static_cast<std::size_t>(bricks.perAxis().y);
  const int slices = map.grid.depth();
  std::uint32_t* before = map.lightIn.data() + z * perRow;
  for (int i = 0; i < range.count; ++i) before[range.at(i)] = Transmittances::kFixed;
  std::uint32_t last = 0;  // slice of the run before
  for (int s = 0; s < slices;) {
    const int first = map.grid.wrap(map.grid.frame.base.x + map.grid.lower.x + s);
    const auto slice = static_cast<std::uint32_t>(first % brick::kX);
    const Run run{static_cast<int>(slice), std::min({brick::kX - static_cast<int>(slice),
                                                     map.grid.settings.cells - first, slices - s})};
    const std::uint32_t* slots = bricks.slots(bricks.place({first, 0, 0}) + z * perRow);
    std::uint32_t* codes = before + bricks.across();
    const std::uint32_t* next = nullptr;
    if (s + run.count < slices && first + run.count < map.grid.settings.cells)
      next = slots + bricks.across();
    // What enters the run: of a brick its own layer, elsewhere the one that stands for all slices.
    const auto entering = [&](std::size_t y) HWY_ATTR {
      return map.transmittances.layer(slots[y] ? codes[y] - 1 + slice
                                               : codes[y] & ~Transmittances::kFixed);
    };
    for (int i = 0; i < range.count; ++i) {
      const std::size_t y = range.at(i);
      if (next) prefetch(next[y], map);
      const std::uint32_t held = before[y] & Transmittances::kFixed ? before[y] : before[y] + last;
      codes[y] = held | Transmittances::kFixed;
      if (slots[y] == 0) continue;
      codes[y] = Transmittances::code(slots[y]);
      attenuate(bricks.cells(slots[y]), run, map.grid.quantum,
                map.transmittances.layer(held & ~Transmittances::kFixed), entering(y));
    }
    for (int i = 0; i < range.count; ++i) {
      const std::size_t y = range.at(i);
      if (slots[y] == 0) continue;
      // Beside the range no filter looks.
      const std::size_t beside = range.at(i + 1 < range.count ? i + 1 : 0);
      copyNeighbour(run.count + 1, entering(beside), slots[beside] == 0, entering(y));
    }
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

void findSlices(DensityMap& map) {
  const auto across = static_cast<std::int32_t>(map.grid.bricks.across());
  const int n = map.grid.settings.cells,
            begin = map.grid.wrap(map.grid.frame.base.x + map.grid.lower.x);
  const auto slices = static_cast<std::size_t>(map.grid.depth());
  // Room for the deepest hair: that of a later frame may be deeper.
  map.sliceRun.reserve(static_cast<std::size_t>(n) + 1);
  map.sliceInBrick.reserve(static_cast<std::size_t>(n) + 1);
  map.sliceRun.resize(slices + 1);
  map.sliceInBrick.resize(slices + 1);
  map.sliceRun[0] = map.sliceInBrick[0] = 0;
  for (std::size_t s = 0; s < slices; ++s) {
    // Where the modulo comes round, another run begins.
    const int straight = begin + static_cast<int>(s);
    const bool turned = straight >= n;
    const int wrapped = turned ? straight - n : straight;
    const int run = turned ? (n - 1) / brick::kX - begin / brick::kX + 1 + wrapped / brick::kX
                           : wrapped / brick::kX - begin / brick::kX;
    map.sliceRun[1 + s] = (run + 1) * across;
    map.sliceInBrick[1 + s] = wrapped % brick::kX;
  }
}

}  // namespace

void computeTransmittance(DensityMap& map) {
  map.transmittances.reserve(map.grid.bricks.room());
  findSlices(map);
  // Run 0 is before all hair; then bricks along the light, which the first and the last slice may
  // share with slices that are not walked, and one more where the modulo comes round.
  const auto runs = static_cast<std::size_t>(map.grid.depth()) / brick::kX + 4;
  map.lightIn.reserve((static_cast<std::size_t>(map.grid.bricks.perAxis().x) + 4) *
                      map.grid.bricks.across());
  // What is never written is read beside the hair, and not used: it has to be some layer.
  map.lightIn.resize(runs * map.grid.bricks.across(), Transmittances::kFixed);
  const BrickRange across = bricksToRead(map.grid, 1), rows = bricksToRead(map.grid, 2);
  parallelFor(static_cast<std::size_t>(rows.count), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      HWY_DYNAMIC_DISPATCH(walkRow)(rows.at(static_cast<int>(i)), across, map);
  });
  map.lit = true;
}

}  // namespace hair

#endif
