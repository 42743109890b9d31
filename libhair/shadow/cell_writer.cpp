#include <libhair/shadow/cell_writer.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include <libhair/core/parallel.h>
#include <libhair/shadow/add_bricks.h>

namespace hair {

namespace {

/// Work that is worth another thread, in nanoseconds: less is done before it has begun. Its bricks
/// are made and added up besides; there will be about as many as a frame before.
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
  const int n = map_.settings.cells;
  const glm::ivec3 base = map_.frame.base, perAxis = store_.perAxis();
  // Hair is hardly ever farther than a map from its anchor: then no division wraps a cell.
  const auto wrapAll = [&](int* c, int from) {
    unsigned beyond = 0;
    for (std::size_t l = 0; l < size_; ++l) {
      int i = c[l] + from;
      i += i < 0 ? n : 0;
      i -= i >= n ? n : 0;
      beyond |= static_cast<unsigned>(i) >= static_cast<unsigned>(n) ? 1u : 0u;
      c[l] = i;
    }
    if (beyond == 0) return;
    for (std::size_t l = 0; l < size_; ++l) c[l] = map_.wrap(c[l]);
  };
  wrapAll(x_, base.x);
  wrapAll(y_, base.y);
  wrapAll(z_, base.z);
  // As BrickStore::place and brick::offset, of numbers that are not negative.
  std::uint32_t place[kSize], offset[kSize];
  for (std::size_t l = 0; l < size_; ++l) {
    const auto x = static_cast<std::uint32_t>(x_[l]), y = static_cast<std::uint32_t>(y_[l]),
               z = static_cast<std::uint32_t>(z_[l]);
    place[l] = (x / brick::kX * static_cast<std::uint32_t>(perAxis.z) + z / brick::kZ) *
                   static_cast<std::uint32_t>(perAxis.y) +
               y / brick::kY;
    offset[l] = (x % brick::kX * brick::kZ + z % brick::kZ) * brick::kY + y % brick::kY;
  }
  for (std::size_t l = 0; l < size_; ++l) {
    const std::uint32_t count = counts_[l];
    if (count == 0) continue;
    std::uint32_t slot = store_.slot(place[l]);
    if (slot == 0) slot = store_.make(place[l]);
    std::uint32_t& sum = store_.cells(slot)[offset[l]];
    sum = addSaturating(sum, count);
    full_ |= sum == kFull;
  }
  size_ = 0;
}

void detail::writeCells(std::size_t count, std::size_t grain, std::size_t nanoseconds,
                        DensityMap& map, WriteRange write, void* context) {
  map.lit = false;
  const std::size_t blocks = (count + grain - 1) / grain;
  const std::size_t workers =
      std::max<std::size_t>(std::min({blocks, static_cast<std::size_t>(threadCount()),
                                      nanoseconds / worthAThread(map.bricks)}),
                            1);
  while (map.workers.size() + 1 < workers) map.workers.emplace_back(map.settings.cells);
  std::atomic<std::size_t> next = 0;
  std::mutex joining;
  glm::ivec3 lower = map.lower, upper = map.upper;
  bool full = map.saturatedCells > 0;
  hair::parallelFor(workers, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t w = begin; w < end; ++w) {
      CellWriter writer(map, w == 0 ? map.bricks : map.workers[w - 1]);
      for (std::size_t b = next++; b < blocks; b = next++)
        write(context, writer, b * grain, std::min((b + 1) * grain, count));
      writer.flush();
      const std::scoped_lock lock(joining);
      lower = glm::min(lower, writer.lower());
      upper = glm::max(upper, writer.upper());
      full |= writer.full();
    }
  });
  map.lower = lower;
  map.upper = upper;
  for (std::size_t w = 1; w < workers; ++w) full |= addBricks(map.workers[w - 1], map.bricks);
  map.saturatedCells = full ? countFull(map.bricks) : 0;
}

}  // namespace hair
