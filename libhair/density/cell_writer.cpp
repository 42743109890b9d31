#include <libhair/density/cell_writer.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include <libhair/core/lanes.h>
#include <libhair/core/parallel.h>
#include <libhair/density/add_bricks.h>
#include <libhair/density/deposit_kernels.h>

namespace hair {

namespace {

/// Least work, nanoseconds, for another thread: start-up time, or the time to allocate and add its
/// bricks, estimated from the previous frame's.
std::size_t worthAThread(const BrickStore& bricks) {
  return std::max<std::size_t>(50000, 40 * std::max(bricks.size(), bricks.sizeBefore()));
}

std::uint32_t countFull(const BrickStore& bricks) {
  std::uint32_t full = 0;
  for (std::uint32_t slot = 1; slot <= bricks.size(); ++slot)
    full += static_cast<std::uint32_t>(
        std::count(bricks.cells(slot), bricks.cells(slot) + brick::kCells, kFull));
  return full;
}

}  // namespace

void CellWriter::flush() {
  if (std::any_of(counts_, counts_ + size_, [](std::uint32_t c) { return c >= kManyCounts; })) {
    for (std::size_t l = 0; l < size_; ++l) addAlone({x_[l], y_[l], z_[l]}, counts_[l]);
  } else {
    // Pad the last vector with zero counts.
    for (; size_ % kLanes != 0; ++size_) {
      x_[size_] = x_[0], y_[size_] = y_[0], z_[size_] = z_[0];
      counts_[size_] = 0;
    }
    writeCounts(x_, y_, z_, counts_, size_, *this);
  }
  size_ = 0;
}

void CellWriter::addAlone(glm::ivec3 cell, std::uint32_t count) {
  if (count == 0) return;
  const glm::ivec3 wrapped = grid_.wrap(cell);
  const std::uint32_t slot = store_.make(store_.place(wrapped));
  std::uint32_t& sum = store_.cells(slot)[brick::offset(wrapped)];
  sum = addSaturating(sum, count);
  full_ |= sum == kFull;
}

void detail::writeCells(std::size_t count, std::size_t grain, std::size_t nanoseconds,
                        DensityGrid& grid, WriteRange write, void* context) {
  const std::size_t blocks = (count + grain - 1) / grain;
  const std::size_t workers =
      std::max<std::size_t>(std::min({blocks, static_cast<std::size_t>(threadCount()),
                                      nanoseconds / worthAThread(grid.cells->bricks)}),
                            1);
  while (grid.cells->workers.size() + 1 < workers)
    grid.cells->workers.emplace_back(grid.settings.cells);
  std::atomic<std::size_t> next = 0;
  std::mutex joining;
  glm::ivec3 lower = grid.lower, upper = grid.upper;
  bool full = grid.saturatedCells > 0;
  hair::parallelFor(workers, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t w = begin; w < end; ++w) {
      CellWriter writer(grid, w == 0 ? grid.cells->bricks : grid.cells->workers[w - 1]);
      for (std::size_t b = next++; b < blocks; b = next++)
        write(context, writer, b * grain, std::min((b + 1) * grain, count));
      writer.flush();
      const std::scoped_lock lock(joining);
      lower = glm::min(lower, writer.lower());
      upper = glm::max(upper, writer.upper());
      full |= writer.full();
    }
  });
  grid.lower = lower;
  grid.upper = upper;
  for (std::size_t w = 1; w < workers; ++w)
    full |= addBricks(grid.cells->workers[w - 1], grid.cells->bricks);
  grid.saturatedCells = full ? countFull(grid.cells->bricks) : 0;
}

}  // namespace hair
