#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/shadow/transmittance.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>

#include <algorithm>

#include <hwy/cache_control.h>

#include <libhair/core/parallel.h>
#include <libhair/shadow/brick_range.h>
#include <libhair/shadow/transmittance.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// Below this no display and no sum can tell the light from none; denormals would be slow.
inline constexpr float kDark = 1e-30f;

/// One row of a brick: out = light · exp(-depth · counts).
HWY_INLINE void attenuateRow(const std::uint32_t* counts, float depth, const float* light,
                             float* out) {
  const Ints c = loadInts(reinterpret_cast<const std::int32_t*>(counts));
  Floats t = loadFloats(light);
  if (any(!(c == Ints(0)))) {
    // Two exact conversions of 16 bits: numbers have signs.
    const Floats count =
        toFloats(shiftRight<16>(c) & Ints(0xffff)) * 65536.0f + toFloats(c & Ints(0xffff));
    t = t * expMinusApproximate(count * Floats(depth));
    t = select(t < Floats(kDark), Floats(0.0f), t);
  }
  store(t, out);
}

/// Slices of one brick that follow each other.
struct Run {
  int slice;  // the first, in its brick
  int count;
};

/// Walks a brick: `light`, a slice, is what enters it.
HWY_INLINE void attenuateBrick(const std::uint32_t* counts, Run run, float depth,
                               const float* light, float* out) {
  const auto skip = static_cast<std::size_t>(run.slice) * brick::kLayer;
  counts += skip;
  out += skip;
  for (int s = 0; s < run.count; ++s) {
    for (std::size_t row = 0; row < brick::kLayer; row += brick::kY)
      attenuateRow(counts + row, depth, light + row, out + row);
    light = out;
    counts += brick::kLayer;
    out += brick::kLayer;
  }
}

/// Brings a brick from memory that is soon to be walked.
HWY_INLINE void prefetch(std::uint32_t slot, DensityMap& map) {
  if (slot == 0) return;
  const std::uint32_t* counts = map.bricks.cells(slot);
  const float* out = map.transmittances.slice(slot, 0);
  for (std::size_t c = 0; c < brick::kCells; c += kLanes) {
    hwy::Prefetch(counts + c);
    hwy::Prefetch(out + c);
  }
}

/// The columns of one row of bricks across the light, of those in `range`.
void walkRow(std::size_t z, BrickRange range, DensityMap& map) {
  const BrickStore& bricks = map.bricks;
  const auto perRow = static_cast<std::size_t>(bricks.perAxis().y);
  const int slices = map.depth();
  std::uint32_t* before = map.lightIn.data() + z * perRow;
  for (int i = 0; i < range.count; ++i) before[range.at(i)] = Transmittances::kFixed;
  std::uint32_t last = 0;  // slice of the run before
  for (int s = 0; s < slices;) {
    const int first = map.wrap(map.frame.base.x + map.lower.x + s);
    const int slice = first % brick::kX;
    const Run run{slice, std::min({brick::kX - slice, map.settings.cells - first, slices - s})};
    const std::uint32_t* slots = bricks.slots(bricks.place({first, 0, 0}) + z * perRow);
    std::uint32_t* in = before + bricks.across();
    const std::uint32_t* next = nullptr;
    if (s + run.count < slices && first + run.count < map.settings.cells)
      next = slots + bricks.across();
    for (int i = 0; i < range.count; ++i) {
      const std::size_t y = range.at(i);
      if (next) prefetch(next[y], map);
      const std::uint32_t code = before[y] & Transmittances::kFixed
                                     ? before[y]
                                     : (before[y] + last) | Transmittances::kFixed;
      in[y] = code;
      if (slots[y] == 0) continue;
      in[y] = slots[y] * brick::kX;
      attenuateBrick(bricks.cells(slots[y]), run, map.quantum, map.transmittances.row(code, 0, 0),
                     map.transmittances.slice(slots[y], 0));
    }
    before = in;
    last = static_cast<std::uint32_t>(run.slice + run.count - 1);
    s += run.count;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hair {

HWY_EXPORT(walkRow);

void computeTransmittance(DensityMap& map) {
  map.transmittances.reserve(map.bricks.room());
  // Run 0 is before all hair; then bricks along the light, which the first and the last slice may
  // share with slices that are not walked, and one more where the modulo comes round.
  const auto runs = static_cast<std::size_t>(map.depth() / brick::kX + 4);
  map.lightIn.reserve((static_cast<std::size_t>(map.bricks.perAxis().x) + 4) * map.bricks.across());
  map.lightIn.resize(runs * map.bricks.across());
  const BrickRange across = bricksToRead(map, 1), rows = bricksToRead(map, 2);
  parallelFor(static_cast<std::size_t>(rows.count), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      HWY_DYNAMIC_DISPATCH(walkRow)(rows.at(static_cast<int>(i)), across, map);
  });
  map.lit = true;
}

}  // namespace hair

#endif
