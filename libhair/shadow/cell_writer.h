#pragma once

#include <atomic>
#include <climits>
#include <cstddef>
#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/shadow/density_map.h>

namespace hair {

// Fixed point: one count is 2^-20 of an optical depth, or of a metre. A cell holds 4096 of either;
// light is gone after 70.
inline constexpr float kQuantum = 0x1p-20f;

inline constexpr std::uint32_t kFull = 0xffffffffu;

/// Writes counts into the map. Shared: other threads do so at the same time. Sums of integers do
/// not depend on their order, and neither does the number of carries out of a cell, so that which
/// cells are saturated does not depend on it either.
template <bool kShared>
class CellWriter {
 public:
  explicit CellWriter(DensityMap& map)
      : map_(map),
        counts_(map.counts.data()),
        touched_(map.touched.data()),
        n_(static_cast<std::size_t>(map.settings.cells)),
        base_(map.frame.base) {}
  CellWriter(const CellWriter&) = delete;
  CellWriter& operator=(const CellWriter&) = delete;

  ~CellWriter() {
    for (int c = 0; c < 3; ++c) {
      keepLeast(map_.lower[c], lower_[c]);
      keepMost(map_.upper[c], upper_[c]);
    }
  }

  /// All cells from one to the other may be written.
  void extend(glm::ivec3 lower, glm::ivec3 upper) {
    lower_ = glm::min(lower_, lower);
    upper_ = glm::max(upper_, upper);
  }

  void add(glm::ivec3 cell, std::uint32_t count) {
    if (count == 0) return;
    const auto i = static_cast<std::size_t>(map_.wrap(base_.x + cell.x));
    const auto j = static_cast<std::size_t>(map_.wrap(base_.y + cell.y));
    const auto k = static_cast<std::size_t>(map_.wrap(base_.z + cell.z));
    const std::size_t row = i * n_ + k;
    touch(row);
    const std::size_t index = row * n_ + j;
    std::uint32_t before;
    if constexpr (kShared) {
      before = std::atomic_ref(counts_[index]).fetch_add(count, std::memory_order_relaxed);
    } else {
      before = counts_[index];
      counts_[index] = before + count;
    }
    // The second: a single addition that does not fit was cut to kFull.
    if (before > kFull - count || count == kFull) saturate(index);
  }

 private:
  void touch(std::size_t row) {
    std::atomic_ref flag(touched_[row]);
    if (flag.load(std::memory_order_relaxed) == 0) flag.store(1, std::memory_order_relaxed);
  }
  void saturate(std::size_t index) {
    std::atomic_ref word(map_.saturation.data()[index / 32]);
    const std::uint32_t bit = 1u << (index % 32);
    if (word.fetch_or(bit, std::memory_order_relaxed) & bit) return;
    std::atomic_ref(map_.saturatedCells).fetch_add(1, std::memory_order_relaxed);
  }
  static void keepLeast(int& least, int value) {
    std::atomic_ref shared(least);
    int seen = shared.load(std::memory_order_relaxed);
    while (value < seen && !shared.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
    }
  }
  static void keepMost(int& most, int value) {
    std::atomic_ref shared(most);
    int seen = shared.load(std::memory_order_relaxed);
    while (value > seen && !shared.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
    }
  }

  DensityMap& map_;
  std::uint32_t* counts_;
  std::uint8_t* touched_;
  std::size_t n_;
  glm::ivec3 base_;
  glm::ivec3 lower_{INT_MAX}, upper_{INT_MIN};
};

}  // namespace hair
