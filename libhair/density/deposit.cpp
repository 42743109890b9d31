#include <libhair/density/deposit.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/density/cell_writer.h>
#include <libhair/density/deposit_kernels.h>
#include <libhair/density/extinction.h>

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

/// Metres of strand that a point stands for: the mean over at most 256 of the strands that are
/// read, every stride-th.
float lengthOfPoint(StrandView strands, std::uint32_t stride) {
  const std::size_t read = (strands.strandCount() + stride - 1) / stride;
  const std::size_t step = (read + 255) / 256 * stride;
  std::size_t count = 0;
  for (std::size_t s = 0; s < strands.strandCount(); s += step) count += strands.strand(s).size();
  return count > 0 ? static_cast<float>(sumOfLengths(strands, step) / static_cast<double>(count))
                   : 0.0f;
}

/// What one point of Deposit::Points is worth: f · ds, or metres.
float pointQuantum(StrandView strands, std::uint32_t stride, const Fibre& fibre,
                   const DensityMapSettings& settings) {
  const float ds = settings.cellSize;
  if (settings.quantity == Quantity::Length)
    return lengthOfPoint(strands, stride) * fibre.hairsPerStrand;
  if (settings.pointExtinction > 0) return settings.pointExtinction * ds;
  // Over all directions the sine of the angle to the light is pi / 4 on average.
  constexpr float kMeanSine = 0.785398163f;
  return lengthOfPoint(strands, stride) * kMeanSine * fibre.width * fibre.hairsPerStrand *
         fibre.opacity / (ds * ds);
}

/// How long one thread takes for a point, in nanoseconds, roughly: what decides whether there is
/// work enough for another one.
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
  return {scale.perCell * weight, scale.acrossOnly, scale.frame};
}

void depositRange(StrandView strands, StrandRange range, const SegmentScale& scale,
                  const DensityMapSettings& settings, CellWriter& writer) {
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

void run(StrandView strands, const Fibre& fibre, DensityMap& map, std::uint32_t stride,
         std::span<const float> weights) {
  const DensityMapSettings& settings = map.settings;
  const float ds = settings.cellSize;
  const bool length = settings.quantity == Quantity::Length;
  // Deviation: extinctionOf, not -ln(1 - opacity).
  const float perStrand = length
                              ? fibre.hairsPerStrand * ds
                              : fibre.width * fibre.hairsPerStrand * extinctionOf(fibre, ds) / ds;
  const SegmentScale scale{perStrand * static_cast<float>(stride) / kQuantum, !length, map.frame};
  const std::size_t read = (strands.strandCount() + stride - 1) / stride;
  const std::size_t nanoseconds = strands.pointCount() / stride * costOfPoint(settings.deposit);
  writeCells(read, 32, nanoseconds, map,
             [&](CellWriter& writer, std::size_t begin, std::size_t end) {
               depositRange(strands, {begin, end, stride, weights}, scale, settings, writer);
             });
}

}  // namespace

void deposit(StrandView strands, const Fibre& fibre, DensityMap& map, std::uint32_t strandStride,
             std::span<const float> weights) {
  require(map.bricks.valid(), "deposit: clear() the density map first");
  require(strandStride > 0 && strandStride < 1u << 30, "deposit: strand stride ", strandStride,
          " is not in 1 to 2^30 - 1");
  require(fibre.width >= 0 && fibre.opacity >= 0 && fibre.hairsPerStrand >= 0 &&
              std::isfinite(fibre.width * fibre.opacity * fibre.hairsPerStrand),
          "deposit: fibre width ", fibre.width, " m, opacity ", fibre.opacity, " or ",
          fibre.hairsPerStrand, " hairs a strand is negative or not finite");
  const DensityMapSettings& settings = map.settings;
  require(
      settings.quantity == Quantity::OpticalDepth || !map.light.atPoint(),
      "deposit: lengths are not told apart under a light at a point, whose cells differ in size; "
      "give the density map a parallel light");
  require(weights.empty() || weights.size() == strands.strandCount(),
          "deposit: ", strands.strandCount(), " strands but ", weights.size(), " weights");
  if (strands.pointCount() == 0) return;
  if (map.empty()) {
    map.frame = makeCellFrame(map.light, strands.points.front(), settings.cellSize, settings.cells);
    map.quantum = settings.deposit == Deposit::Points
                      ? pointQuantum(strands, strandStride, fibre, settings)
                      : kQuantum;
  }
  map.fibreShadow = std::max(map.fibreShadow, fibre.width * extinctionOf(fibre, settings.cellSize));
  run(strands, fibre, map, strandStride, weights);
}

}  // namespace hair
