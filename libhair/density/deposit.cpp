#include <libhair/density/density_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <libhair/core/error.h>
#include <libhair/density/cell_writer.h>
#include <libhair/density/deposit_kernels.h>
#include <libhair/density/grid_cells.h>

namespace hair {

namespace {

template <class Writer>
void depositSegments(std::span<const glm::vec3> points, SegmentScale scale, float longest,
                     const CellFrame& frame, Writer& writer) {
  if (points.empty()) return;
  glm::vec3 a = frame.cellCoordinates(points.front());
  glm::ivec3 at = floorToCell(a);
  Bounds box;
  box.extend(a);
  std::uint32_t pending = 0;
  Rounder rounder;
  for (const glm::vec3 p : points.subspan(1)) {
    const glm::vec3 b = frame.cellCoordinates(p);
    const glm::ivec3 cell = floorToCell(b);
    box.extend(b);
    if (longerThan(longest, a, b)) {
      writer.add(at, addSaturating(pending, rounder.take(scale.amount(a, b))));
      pending = 0;
      at = cell;
    } else {
      depositSegment(a, b, rounder.take(scale.amount(a, b)), at, cell, pending, writer);
    }
    a = b;
  }
  writer.add(at, pending);
  writer.extend(floorToCell(box.lower), floorToCell(box.upper));
}

float toFloat(double amount) {
  return static_cast<float>(std::min(amount, double{std::numeric_limits<float>::max()}));
}

/// Amount per point for Deposit::Points.
float pointQuantum(StrandView strands, std::uint32_t stride, const SegmentMeasure& measure) {
  if (measure.perPoint > 0) return measure.perPoint;
  // Over all directions the sine of the angle to an axis is pi / 4 on average.
  const float part = measure.of == SegmentMeasure::Of::Length ? 1.0f : 0.785398163f;
  return metresPerPoint(strands, stride) * part * toFloat(measure.perMetre);
}

/// Estimated time for a point on one thread, nanoseconds; limits the number of threads.
std::size_t costOfPoint(Deposit how) {
  switch (how) {
    case Deposit::Points:
      return 3;
    case Deposit::Columns:
      return 12;
    case Deposit::Segments:
      return 35;
  }
  return 1;
}

SegmentScale weighted(const SegmentScale& scale, const StrandRange& range, std::size_t r) {
  const float weight = range.weights.empty() ? 1.0f : range.weights[r * range.stride];
  return {scale.of, scale.perCell * weight, scale.frame};
}

void depositRange(StrandView strands, StrandRange range, const SegmentScale& scale,
                  const DensityGridSettings& settings, CellWriter& writer) {
  const auto longest = static_cast<float>(settings.cells);
  switch (settings.deposit) {
    case Deposit::Points:
      return writePoints(strands, range, writer);
    case Deposit::Columns:
      return writeColumns(strands, range, scale, longest, writer);
    case Deposit::Segments:
      for (std::size_t r = range.begin; r < range.end; ++r)
        depositSegments(strands.strand(r * range.stride), weighted(scale, range, r), longest,
                        scale.frame, writer);
      return;
  }
}

}  // namespace

float metresPerPoint(StrandView strands, std::uint32_t strandStride) {
  const std::size_t read = (strands.strandCount() + strandStride - 1) / strandStride;
  const std::size_t step = (read + 255) / 256 * strandStride;
  std::size_t count = 0;
  for (std::size_t s = 0; s < strands.strandCount(); s += step) count += strands.strand(s).size();
  return count > 0 ? static_cast<float>(sumOfLengths(strands, step) / static_cast<double>(count))
                   : 0.0f;
}

void deposit(StrandView strands, const SegmentMeasure& measure, DensityGrid& grid,
             std::uint32_t strandStride, std::span<const float> weights) {
  require(grid.cells->bricks.valid(), "deposit: clear() the density grid first");
  require(strandStride > 0 && strandStride < 1u << 30, "deposit: strand stride ", strandStride,
          " is not in 1 to 2^30 - 1");
  require(measure.perMetre >= 0 && std::isfinite(measure.perMetre) && measure.perPoint >= 0 &&
              std::isfinite(measure.perPoint),
          "deposit: an amount of ", measure.perMetre, " a metre or ", measure.perPoint,
          " a point is negative or not finite");
  require(weights.empty() || weights.size() == strands.strandCount(),
          "deposit: ", strands.strandCount(), " strands but ", weights.size(), " weights");
  if (strands.pointCount() == 0) return;
  const DensityGridSettings& settings = grid.settings;
  if (grid.empty()) {
    grid.cells->frame =
        makeCellFrame(grid.space, strands.points.front(), settings.cellSize, settings.cells);
    grid.quantum = settings.deposit == Deposit::Points
                       ? pointQuantum(strands, strandStride, measure)
                       : kQuantum;
  }
  const float perCell = toFloat(measure.perMetre * static_cast<double>(settings.cellSize));
  const SegmentScale scale{measure.of, perCell * static_cast<float>(strandStride) / kQuantum,
                           grid.cells->frame};
  const std::size_t read = (strands.strandCount() + strandStride - 1) / strandStride;
  const std::size_t nanoseconds =
      strands.pointCount() / strandStride * costOfPoint(settings.deposit);
  writeCells(read, 32, nanoseconds, grid,
             [&](CellWriter& writer, std::size_t begin, std::size_t end) {
               depositRange(strands, {begin, end, strandStride, weights}, scale, settings, writer);
             });
}

}  // namespace hair
