#pragma once

#include <cstdint>

namespace hair {

/// Counter-based random numbers: a value depends on what it is for (strand, use), never on the
/// order of calls, so that threads and options do not change a groom.
/// Hash: Jarzynski and Olano 2020, "Hash Functions for GPU Rendering" (pcg, one output word).
inline std::uint32_t hashWord(std::uint32_t v) {
  v = v * 747796405u + 2891336453u;
  const std::uint32_t word = ((v >> ((v >> 28u) + 4u)) ^ v) * 277803737u;
  return (word >> 22u) ^ word;
}

/// Uniform in [0, 1), of one item (a strand) for one use of it.
inline float uniform(std::uint32_t item, std::uint32_t use, std::uint32_t seed = 0) {
  const std::uint32_t bits = hashWord(item ^ hashWord(use ^ hashWord(seed)));
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

}  // namespace hair
