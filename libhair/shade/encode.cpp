#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/shade/encode.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>

#include <libhair/shade/appearance.h>
#include <libhair/shade/encode-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

void encodePoints(const glm::vec3* radiance, std::size_t begin, std::size_t end,
                  std::uint32_t* colours) {
  const PointWriter to{{nullptr, colours}};
  for (std::size_t p = begin; p < end; p += kLanes) {
    const std::size_t n = std::min(kLanes, end - p);
    to.put(loadPoints(radiance + p, n), p, n);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair {

namespace {

HWY_EXPORT(encodePoints);

}  // namespace

void encodeSrgb(std::span<const glm::vec3> radiance, std::span<std::uint32_t> colours) {
  require(radiance.size() == colours.size(), "encodeSrgb: ", radiance.size(),
          " radiances but room for ", colours.size(), " colours");
  const auto encode = HWY_DYNAMIC_DISPATCH(encodePoints);
  parallelFor(radiance.size(), 2048, [&](std::size_t begin, std::size_t end) {
    encode(radiance.data(), begin, end, colours.data());
  });
}

void encodeSrgb(std::span<const glm::vec3> radiance, std::span<const std::uint32_t> first,
                std::span<const float> weights, std::span<std::uint32_t> colours) {
  encodeSrgb(radiance, colours);
  fadeColours(first, weights, colours);
}

void fadeColours(std::span<const std::uint32_t> first, std::span<const float> weights,
                 std::span<std::uint32_t> colours) {
  if (weights.empty()) return;
  require(first.size() == weights.size() + 1 && first.back() <= colours.size(),
          "fadeColours: ", weights.size(), " weights, ", first.size(), " offsets to ",
          first.empty() ? 0 : first.back(), " and ", colours.size(), " colours do not fit");
  for (std::size_t s = 0; s < weights.size(); ++s) {
    if (weights[s] >= 1) continue;
    const auto weight = static_cast<std::uint32_t>(std::lround(weights[s] * 65536));
    for (std::uint32_t p = first[s]; p < first[s + 1]; ++p) {
      const std::uint32_t opacity = ((colours[p] >> 24) * weight + 32768) >> 16;
      colours[p] = (colours[p] & 0xffffffu) | opacity << 24;
    }
  }
}

}  // namespace hair

#endif  // HWY_ONCE
