#include <libhair/shadow/transmittance.h>

#include <algorithm>

#include <libhair/core/approximate.h>
#include <libhair/core/parallel.h>

namespace hair {

namespace {

// Below this no display and no sum can tell the light from none; denormals would be slow.
constexpr float kDark = 1e-30f;

constexpr std::size_t kBlock = 16;

/// Sixteen cells: after[j] = before[j] · exp(-depth · counts[j]).
void attenuateBlock(const std::uint32_t* counts, const float* before, float depth, float* after) {
  for (std::size_t j = 0; j < kBlock; ++j) {
    // Two exact conversions of 16 bits: baseline x86-64 has none for 32 unsigned bits.
    const float count = static_cast<float>(static_cast<std::int32_t>(counts[j] >> 16)) * 65536.0f +
                        static_cast<float>(static_cast<std::int32_t>(counts[j] & 0xffffu));
    const float t = before[j] * expMinusApproximate(count * depth);
    after[j] = t < kDark ? 0.0f : t;
  }
}

void attenuateRow(const std::uint32_t* counts, const float* before, float depth, float* after,
                  std::size_t n) {
  std::size_t j = 0;
  for (; j + kBlock <= n; j += kBlock) {
    std::uint32_t any = 0;
    for (std::size_t l = 0; l < kBlock; ++l) any |= counts[j + l];
    if (any != 0)
      attenuateBlock(counts + j, before + j, depth, after + j);
    else
      std::copy_n(before + j, kBlock, after + j);
  }
  for (; j < n; ++j) {
    const float t = before[j] * expMinusApproximate(static_cast<float>(counts[j]) * depth);
    after[j] = t < kDark ? 0.0f : t;
  }
}

}  // namespace

void computeTransmittance(DensityMap& map) {
  const auto n = static_cast<std::size_t>(map.settings.cells);
  const auto slices = static_cast<std::size_t>(map.depth());
  const float depth = map.quantum;
  float* transmittance = map.transmittance.data();
  parallelFor(n, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = 0; s < slices; ++s) {
      const auto i =
          static_cast<std::size_t>(map.wrap(map.frame.base.x + map.lower.x + static_cast<int>(s)));
      const std::uint32_t* before = map.rowOf.data() + s * n;
      std::uint32_t* after = map.rowOf.data() + (s + 1) * n;
      for (std::size_t k = begin; k < end; ++k) {
        const std::size_t row = i * n + k;
        after[k] = before[k];
        if (!map.touched.data()[row]) continue;
        after[k] = static_cast<std::uint32_t>(row * n);
        attenuateRow(map.counts.data() + row * n, transmittance + before[k], depth,
                     transmittance + after[k], n);
      }
    }
  });
}

}  // namespace hair
