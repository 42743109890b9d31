#pragma once

#include <climits>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <glm/glm.hpp>

#include <libhair/density/density_grid.h>
#include <libhair/density/grid_cells.h>

namespace hair {

// Fixed point: one count is 2^-20 of the unit, metres or optical depth. A cell holds up to 4096
// units; an optical depth of 70 is opaque.
inline constexpr float kQuantum = 0x1p-20f;

inline constexpr std::uint32_t kFull = 0xffffffffu;

inline std::uint32_t addSaturating(std::uint32_t a, std::uint32_t b) {
  return a > kFull - b ? kFull : a + b;
}

/// Adds counts to the cells of a store of its own, one a thread, without locks; writeCells adds up
/// the stores. Integer sums do not depend on the order. Call flush() before the writer is
/// destroyed.
class CellWriter {
 public:
  CellWriter(const DensityGrid& grid, BrickStore& store) : grid_(grid), store_(store) {}
  CellWriter(const CellWriter&) = delete;
  CellWriter& operator=(const CellWriter&) = delete;

  /// Extends the bounds of deposited cells.
  void extend(glm::ivec3 lower, glm::ivec3 upper) {
    lower_ = glm::min(lower_, lower);
    upper_ = glm::max(upper_, upper);
  }

  /// Adds to an unwrapped cell. Buffered, so that bricks are looked up in batches.
  void add(glm::ivec3 cell, std::uint32_t count) {
    x_[size_] = cell.x;
    y_[size_] = cell.y;
    z_[size_] = cell.z;
    counts_[size_] = count;
    if (++size_ == kSize) flush();
  }
  /// Writes buffered counts to the store.
  void flush();

  /// For kernels that write to the store themselves.
  const DensityGrid& grid() const { return grid_; }
  BrickStore& store() { return store_; }
  void markSaturated() { full_ = true; }

  glm::ivec3 lower() const { return lower_; }
  glm::ivec3 upper() const { return upper_; }
  bool full() const { return full_; }  ///< a sum has saturated

 private:
  static constexpr std::size_t kSize = 64;

  void addAlone(glm::ivec3 cell, std::uint32_t count);

  const DensityGrid& grid_;
  BrickStore& store_;
  std::size_t size_ = 0;
  int x_[kSize], y_[kSize], z_[kSize];
  std::uint32_t counts_[kSize];
  bool full_ = false;
  glm::ivec3 lower_{INT_MAX}, upper_{INT_MIN};
};

namespace detail {
using WriteRange = void (*)(void* context, CellWriter& writer, std::size_t begin, std::size_t end);
void writeCells(std::size_t count, std::size_t grain, std::size_t nanoseconds, DensityGrid& grid,
                WriteRange write, void* context);
}  // namespace detail

/// Calls write(writer, begin, end) on ranges of at most `grain` that cover [0, count), in parallel,
/// and adds the results to the bricks of `grid`, with bounds and saturation. `nanoseconds`:
/// estimated time on one thread; limits the number of threads. The result has the same bits for any
/// number of threads.
template <class Write>
void writeCells(std::size_t count, std::size_t grain, std::size_t nanoseconds, DensityGrid& grid,
                Write&& write) {
  using Plain = std::remove_reference_t<Write>;
  detail::writeCells(
      count, grain, nanoseconds, grid,
      [](void* context, CellWriter& writer, std::size_t begin, std::size_t end) {
        (*static_cast<Plain*>(context))(writer, begin, end);
      },
      const_cast<void*>(static_cast<const void*>(&write)));
}

}  // namespace hair
