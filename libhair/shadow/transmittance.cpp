#include <libhair/shadow/transmittance.h>

#include <algorithm>

#include <libhair/core/approximate.h>
#include <libhair/core/parallel.h>

namespace hair {

namespace {

// Below this no display and no sum can tell the light from none; denormals would be slow.
constexpr float kDark = 1e-30f;

/// One row of a brick: light[j] and out[j] become light[j] · exp(-depth · counts[j]).
void attenuateRow(const std::uint32_t* counts, float depth, float* light, float* out) {
  std::uint32_t any = 0;
  for (std::size_t j = 0; j < brick::kY; ++j) any |= counts[j];
  if (any == 0) {
    std::copy_n(light, brick::kY, out);
    return;
  }
  for (std::size_t j = 0; j < brick::kY; ++j) {
    // Two exact conversions of 16 bits: baseline x86-64 has none for 32 unsigned bits.
    const float count = static_cast<float>(static_cast<std::int32_t>(counts[j] >> 16)) * 65536.0f +
                        static_cast<float>(static_cast<std::int32_t>(counts[j] & 0xffffu));
    const float t = light[j] * expMinusApproximate(count * depth);
    light[j] = out[j] = t < kDark ? 0.0f : t;
  }
}

/// Slices of one brick that follow each other.
struct Run {
  int slice;  // the first, in its brick
  int count;
};

/// Walks a brick: `light`, a layer, is what enters it, and then what leaves it.
void attenuateBrick(const std::uint32_t* counts, Run run, float depth, float* light, float* out) {
  const auto skip = static_cast<std::size_t>(run.slice) * brick::kLayer;
  counts += skip;
  out += skip;
  for (int s = 0; s < run.count; ++s)
    for (std::size_t row = 0; row < brick::kLayer;
         row += brick::kY, counts += brick::kY, out += brick::kY)
      attenuateRow(counts, depth, light + row, out);
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
    std::uint32_t* in = before + bricks.across();
    for (std::size_t y = 0; y < perRow; ++y) {
      if (slots[y] == 0) {
        in[y] = before[y] & Transmittances::kFixed ? before[y]
                                                   : (before[y] + last) | Transmittances::kFixed;
        continue;
      }
      in[y] = slots[y] * brick::kX;
      attenuateBrick(bricks.cells(slots[y]), run, map.quantum, light + y * brick::kLayer,
                     map.transmittances.slice(slots[y], 0));
    }
    before = in;
    last = static_cast<std::uint32_t>(run.slice + run.count - 1);
    s += run.count;
  }
}

}  // namespace

void computeTransmittance(DensityMap& map) {
  const glm::ivec3 perAxis = map.bricks.perAxis();
  const std::size_t across = map.bricks.across();
  map.transmittances.reserve(map.bricks.room());
  // Run 0 is before all hair; then bricks along the light, and one more where the modulo comes
  // round.
  map.lightIn.resize((static_cast<std::size_t>(perAxis.x) + 2) * across);
  map.lightHere.resize(across * brick::kLayer);
  parallelFor(static_cast<std::size_t>(perAxis.z), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = begin; z < end; ++z) walk(z, map);
  });
  map.lit = true;
}

}  // namespace hair
