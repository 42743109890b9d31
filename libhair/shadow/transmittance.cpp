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

/// The columns of one row of bricks across the light.
void walk(std::size_t z, DensityMap& map) {
  const BrickStore& bricks = map.bricks;
  const auto perRow = static_cast<std::size_t>(bricks.perAxis().y);
  const int slices = map.depth();
  float* light = map.lightHere.data() + z * perRow * brick::kLayer;
  std::fill_n(light, perRow * brick::kLayer, 1.0f);
  std::uint32_t* before = map.lightIn.data() + z * perRow;
  std::fill_n(before, perRow, Transmittances::kFixed);
  std::uint32_t last = 0;  // slice of the run before
  for (int s = 0; s < slices;) {
    const int first = map.wrap(map.frame.base.x + map.lower.x + s);
    const int slice = first % brick::kX;
    const Run run{slice, std::min({brick::kX - slice, map.settings.cells - first, slices - s})};
    const std::uint32_t* slots = bricks.slots(bricks.place({first, 0, 0}) + z * perRow);
    const auto layerBefore = [&](std::uint32_t slot) HWY_ATTR {
      return map.transmittances.layer(Transmittances::code(slot) - 1 +
                                      static_cast<std::uint32_t>(slice));
    };
    std::uint32_t* in = before + bricks.across();
    bool any = false;
    for (std::size_t y = 0; y < perRow; ++y) {
      if (slots[y] == 0) {
        in[y] = before[y] & Transmittances::kFixed ? before[y]
                                                   : (before[y] + last) | Transmittances::kFixed;
        continue;
      }
      any = true;
      in[y] = Transmittances::code(slots[y]);
      attenuate(bricks.cells(slots[y]), run, map.quantum, light + y * brick::kLayer,
                layerBefore(slots[y]));
    }
    for (std::size_t y = 0; any && y < perRow; ++y) {
      if (slots[y] == 0) continue;
      const std::size_t beside = y + 1 < perRow ? y + 1 : 0;
      copyNeighbour(run.count + 1, slots[beside] ? layerBefore(slots[beside]) : nullptr,
                    light + beside * brick::kLayer, layerBefore(slots[y]));
    }
    before = in;
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
