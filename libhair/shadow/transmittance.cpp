#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/shadow/transmittance.cpp"
#include <algorithm>

#include <hwy/foreach_target.h>

#include <libhair/core/simd-inl.h>
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

/// Walks a brick: `light` [brick::kLayer] is what enters it, and then what leaves it. `out`: the
/// layer before the run's first slice, and those after each.
HWY_INLINE void attenuate(const std::uint32_t* counts, Run run, float depth, float* light,
                          float* out) {
  // Below this no display and no sum can tell the light from none; denormals would be slow.
  const Floats dark(1e-30f), zero(0.0f);
  const auto cells = reinterpret_cast<const std::int32_t*>(counts) + run.slice * brick::kLayer;
  for (int z = 0; z < brick::kZ; ++z) {
    Floats t = loadFloats(light + z * brick::kY);
    float* to = out + z * Transmittances::kRow;
    store(t, to);
    for (int s = 0; s < run.count; ++s) {
      const Ints count = loadInts(cells + s * brick::kLayer + z * brick::kY);
      // In two exact parts: counts have 32 bits and no sign.
      const Floats n = toFloats(shiftRight<16>(count) & Ints(0xffff)) * 65536.0f +
                       toFloats(count & Ints(0xffff));
      t = t * expMinusApproximate(n * depth);
      t = select(t < dark, zero, t);
      to += Transmittances::kLayer;
      store(t, to);
    }
    store(t, light + z * brick::kY);
  }
}

/// The last column of a brick's layers: the first one of the next brick, `next`; where none is, the
/// light does not change.
HWY_INLINE void copyNeighbour(int layers, const float* next, const float* light, float* out) {
  for (int layer = 0; layer < layers; ++layer)
    for (int z = 0; z < brick::kZ; ++z)
      out[layer * Transmittances::kLayer + z * Transmittances::kRow + brick::kY] =
          next ? next[layer * Transmittances::kLayer + z * Transmittances::kRow]
               : light[z * brick::kY];
}

/// Codes of a row of bricks, after those of the run before; `last`: slice of that run, in a brick.
/// Returns where bricks are: bit y.
HWY_INLINE std::uint64_t encodeRow(const std::uint32_t* slots, const std::uint32_t* before,
                                   std::uint32_t last, std::size_t perRow, std::uint32_t* codes) {
  static_assert(1024 / brick::kY <= 64);
  std::uint64_t there = 0;
  std::size_t y = 0;
  for (; y + kLanes <= perRow; y += kLanes) {
    const Ints slot = loadInts(reinterpret_cast<const std::int32_t*>(slots + y));
    const Ints was = loadInts(reinterpret_cast<const std::int32_t*>(before + y));
    const Ints fixed(static_cast<std::int32_t>(Transmittances::kFixed));
    const Ints held = select(was < Ints(0), was, (was + Ints(static_cast<int>(last))) | fixed);
    const Ints own = slot * Ints(Transmittances::kLayers) + Ints(1);
    const Mask none = slot == Ints(0);
    store(select(none, held, own), reinterpret_cast<std::int32_t*>(codes + y));
    there |= std::uint64_t{bits(none) ^ 0xffffu} << y;
  }
  for (; y < perRow; ++y) {
    const std::uint32_t was = before[y];
    codes[y] = slots[y] != 0                  ? Transmittances::code(slots[y])
               : was & Transmittances::kFixed ? was
                                              : (was + last) | Transmittances::kFixed;
    there |= std::uint64_t{slots[y] != 0} << y;
  }
  return there;
}

/// The columns of one row of bricks across the light.
void walk(std::size_t z, DensityMap& map) {
  const BrickStore& bricks = map.bricks;
  const auto perRow = static_cast<std::size_t>(bricks.perAxis().y);
  const int slices = map.depth();
  float* light = map.lightHere.data() + z * perRow * brick::kLayer;
  std::fill_n(light, perRow * brick::kLayer, 1.0f);
  std::uint32_t* before = map.lightIn.data() + z * perRow;
  std::fill_n(before, perRow, Transmittances::kFixed);
  std::uint32_t last = 0;
  for (int s = 0; s < slices;) {
    const int first = map.wrap(map.frame.base.x + map.lower.x + s);
    const int slice = first % brick::kX;
    const Run run{slice, std::min({brick::kX - slice, map.settings.cells - first, slices - s})};
    const std::uint32_t* slots = bricks.slots(bricks.place({first, 0, 0}) + z * perRow);
    std::uint32_t* codes = before + bricks.across();
    const std::uint64_t there = encodeRow(slots, before, last, perRow, codes);
    const auto layerBefore = [&](std::size_t y) HWY_ATTR {
      return map.transmittances.layer(codes[y] - 1 + static_cast<std::uint32_t>(slice));
    };
    for (std::uint64_t rest = there; rest != 0; rest &= rest - 1) {
      const auto y = static_cast<std::size_t>(__builtin_ctzll(rest));
      attenuate(bricks.cells(slots[y]), run, map.quantum, light + y * brick::kLayer,
                layerBefore(y));
    }
    for (std::uint64_t rest = there; rest != 0; rest &= rest - 1) {
      const auto y = static_cast<std::size_t>(__builtin_ctzll(rest));
      const std::size_t beside = y + 1 < perRow ? y + 1 : 0;
      copyNeighbour(run.count + 1, there >> beside & 1 ? layerBefore(beside) : nullptr,
                    light + beside * brick::kLayer, layerBefore(y));
    }
    before = codes;
    last = static_cast<std::uint32_t>(run.slice + run.count - 1);
    s += run.count;
  }
}

void walkRows(std::size_t begin, std::size_t end, DensityMap& map) {
  for (std::size_t z = begin; z < end; ++z) walk(z, map);
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <libhair/core/parallel.h>

namespace hair {

HWY_EXPORT(walkRows);

void computeTransmittance(DensityMap& map) {
  const glm::ivec3 perAxis = map.bricks.perAxis();
  const std::size_t across = map.bricks.across();
  map.transmittances.reserve(map.bricks.room());
  // Run 0 is before all hair; then bricks along the light, and one more where the modulo comes
  // round.
  map.lightIn.resize((static_cast<std::size_t>(perAxis.x) + 2) * across);
  map.lightHere.resize(across * brick::kLayer);
  parallelFor(static_cast<std::size_t>(perAxis.z), 1, [&](std::size_t begin, std::size_t end) {
    HWY_DYNAMIC_DISPATCH(walkRows)(begin, end, map);
  });
  map.lit = true;
}

}  // namespace hair

#endif
