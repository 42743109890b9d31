// Deposit of sixteen points or segments at once. Deposit::Columns, the default, in four stages:
//
//   SegmentBatch   points to cell coordinates, segments to amounts,
//                  amounts to integer counts                                  segment_batch-inl.h
//   walkColumns    cuts segments at the walls of columns, a segment a lane
//                  (Amanatides, Woo 1987)                                     column_walk-inl.h
//   Pieces         collects pieces of all lanes, and shares each between
//                  two slices                                                 column_walk-inl.h
//   Adder          finds the bricks of cells, makes missing ones, and adds    cell_writer-inl.h
//
//        light -->   slice 0   slice 1   slice 2
//                  |         |         |         |
//     column j+1   |         |      .--*---b     |    a piece per column; its count is shared
//     -------------+---------+-----/---+---------+    between the two slices whose centres are
//     column j     |    a----*----'    |         |    nearest to its middle (*)
//
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/density/deposit_kernels.cpp"
#include <hwy/foreach_target.h>
#include <libhair/density/cell_writer-inl.h>
#include <libhair/density/column_walk-inl.h>
#include <libhair/density/segment_batch-inl.h>

#include <algorithm>

#include <libhair/density/deposit_kernels.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// Calls visit(points, first, weights) for each run of strands that are contiguous in memory: all
/// at stride 1, else one at a time. `first` [strands + 1]: as in StrandView, less first[0] indices
/// into `points`.
template <class Visit>
HWY_INLINE void forRuns(StrandView strands, StrandRange range, Visit&& visit) {
  const std::size_t run = range.stride == 1 ? range.end - range.begin : 1;
  for (std::size_t r = range.begin; r < range.end; r += run) {
    const std::size_t s = r * range.stride;
    const std::size_t from = strands.first[s], to = strands.first[s + run];
    if (from < to)
      visit(strands.points.subspan(from, to - from), strands.first.subspan(s, run + 1),
            range.weights.empty() ? range.weights : range.weights.subspan(s, run));
  }
}

void pointsKernel(StrandView strands, StrandRange range, CellWriter& writer) {
  const CellFrame& frame = writer.grid().cells->frame;
  const CellCodes codes(writer.grid());
  const Ints each(static_cast<std::int32_t>(range.stride));
  PointBox box;
  Adder adder(writer);
  forRuns(strands, range, [&](std::span<const glm::vec3> points, auto, auto) HWY_ATTR {
    for (std::size_t p = 0; p < points.size(); p += kLanes) {
      const Vec3 u = cellCoordinates(frame, pointsFrom(points, p));
      box.extend(u);
      const Ints code = codes.code(floorToInt(u.x), floorToInt(u.y), floorToInt(u.z));
      const std::size_t left = points.size() - p;
      adder.add(code, HWY_LIKELY(left >= kLanes) ? each : select(firstLanes(left), each, Ints(0)));
    }
  });
  adder.flush();
  box.tell(0, writer);
}

void columnsKernel(StrandView strands, StrandRange range, const SegmentScale& scale, float longest,
                   CellWriter& writer) {
  PointBox box;
  Pieces pieces(writer);
  SegmentBatch batch;
  forRuns(strands, range,
          [&](std::span<const glm::vec3> points, std::span<const std::uint32_t> first,
              std::span<const float> weights) HWY_ATTR {
            batch.begin(scale.frame.cellCoordinates(points[0]));
            box.extend(Vec3(batch.point(0)));
            std::size_t strand = 0;
            Rounder rounder;
            for (std::size_t p = 1; p < points.size(); p += batch.size) {
              batch.fill(points, p, scale, longest, box);
              countSegments(first, weights, p - 1, strand, rounder, batch);
              if (HWY_UNLIKELY(batch.anyOdd())) writeOdd(scale, longest, batch, writer);
              for (std::size_t l = 0; l < batch.size; l += kLanes)
                walkColumns(batch.at(l), batch.at(l + 1), loadInts(batch.count + l), pieces);
            }
          });
  pieces.flush();
  box.tell(0.5f, writer);
}

void countsKernel(const int* x, const int* y, const int* z, const std::uint32_t* counts,
                  std::size_t size, CellWriter& writer) {
  const CellCodes codes(writer.grid());
  Adder adder(writer);
  for (std::size_t l = 0; l < size; l += kLanes)
    adder.add(codes.code(loadInts(x + l), loadInts(y + l), loadInts(z + l)),
              loadInts(reinterpret_cast<const std::int32_t*>(counts + l)));
  adder.flush();
}

double lengthsKernel(StrandView strands, std::size_t step) {
  Floats sum(0.0f);
  for (std::size_t s = 0; s < strands.strandCount(); s += step) {
    const std::size_t end = strands.first[s + 1];
    for (std::size_t p = strands.first[s]; p + 1 < end; p += kLanes) {
      const Floats part = length(pointsFrom(strands.points, p + 1) - pointsFrom(strands.points, p));
      sum = sum + select(firstLanes(std::min(end - 1 - p, kLanes)), part, Floats(0.0f));
    }
  }
  float each[kLanes];
  store(sum, each);
  double total = 0;
  for (const float e : each) total += static_cast<double>(e);
  return total;
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hair {

HWY_EXPORT(pointsKernel);
HWY_EXPORT(columnsKernel);
HWY_EXPORT(countsKernel);
HWY_EXPORT(lengthsKernel);

void writePoints(StrandView strands, StrandRange range, CellWriter& writer) {
  HWY_DYNAMIC_DISPATCH(pointsKernel)(strands, range, writer);
}

void writeColumns(StrandView strands, StrandRange range, const SegmentScale& scale, float longest,
                  CellWriter& writer) {
  HWY_DYNAMIC_DISPATCH(columnsKernel)(strands, range, scale, longest, writer);
}

void writeCounts(const int* x, const int* y, const int* z, const std::uint32_t* counts,
                 std::size_t size, CellWriter& writer) {
  HWY_DYNAMIC_DISPATCH(countsKernel)(x, y, z, counts, size, writer);
}

double sumOfLengths(StrandView strands, std::size_t step) {
  return HWY_DYNAMIC_DISPATCH(lengthsKernel)(strands, step);
}

}  // namespace hair

#endif
