// Deposit of sixteen points or segments at once. Deposit::Columns, the default, in four stages:
//
//   SegmentBatch   points to cell coordinates, segments to amounts, amounts to integer counts
//   walkColumns    cuts segments at the walls of columns, a segment a lane (Amanatides, Woo 1987)
//   Pieces         collects pieces of all lanes, and shares each between two slices
//   Adder          finds the bricks of cells, makes missing ones, and adds
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
#include <libhair/density/cells-inl.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include <libhair/density/deposit_kernels.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// Sixteen points from points[at] on; beyond the span, its last one is repeated.
HWY_INLINE Vec3 pointsFrom(std::span<const glm::vec3> points, std::size_t at) {
  return loadPoints(points.data() + at, points.size() - at);
}

/// The bounding box of all points, which `tell` passes on to the writer.
class PointBox {
 public:
  HWY_INLINE PointBox() : lower_(glm::vec3(1e9f)), upper_(glm::vec3(-1e9f)) {}
  HWY_INLINE void extend(Vec3 u) {
    lower_ = {min(lower_.x, u.x), min(lower_.y, u.y), min(lower_.z, u.z)};
    upper_ = {max(upper_.x, u.x), max(upper_.y, u.y), max(upper_.z, u.z)};
  }
  HWY_INLINE void tell(float margin, CellWriter& writer) const {
    LaneVec3 lower, upper;
    store(lower_, lower), store(upper_, upper);
    for (std::size_t l = 0; l < kLanes; ++l)
      writer.extend(floorToCell(lane(lower, l) - margin), floorToCell(lane(upper, l) + margin));
  }

 private:
  Vec3 lower_, upper_;
};

/// Adds counts below kManyCounts to the writer's cells, sixteen at a time.
class Adder {
 public:
  HWY_INLINE explicit Adder(CellWriter& writer)
      : writer_(writer), store_(writer.store()), slots_(store_.slots(0)) {}
  Adder(const Adder&) = delete;
  Adder& operator=(const Adder&) = delete;

  /// Queues sixteen counts, with the codes (CellCodes) of their cells.
  HWY_INLINE void add(Ints code, Ints count) {
    // Find the slots of the bricks, and make bricks that are missing.
    if (HWY_UNLIKELY(size_ == kSize)) flush();
    const Ints place = shiftRight<8>(code);
    Ints slot = gather(slots_, place);
    const Mask missing = (slot == Ints(0)) & !(count == Ints(0));
    if (HWY_UNLIKELY(any(missing))) {
      make(code, bits(missing));
      slot = gather(slots_, place);
    }
    // Queue cells and counts; zeros without a brick go to slot 0.
    store(shiftLeft<8>(slot) + (code & Ints(brick::kCells - 1)),
          reinterpret_cast<std::int32_t*>(cell_ + size_));
    store(count, reinterpret_cast<std::int32_t*>(count_ + size_));
    size_ += kLanes;
  }
  /// Adds what is queued. A count below 2^30 cannot overflow a cell that was below 2^31.
  HWY_INLINE void flush() {
    std::uint32_t* cells = store_.cells(0);
    std::uint32_t before = 0;
    for (std::size_t l = 0; l < size_; ++l) {
      std::uint32_t& sum = cells[cell_[l]];
      before |= sum;
      sum += count_[l];
    }
    if (HWY_UNLIKELY(before >> 31 != 0)) saturate();
    size_ = 0;
  }

 private:
  static_assert(brick::kCells == 256);
  HWY_NOINLINE void make(Ints code, std::uint32_t missing) {
    std::int32_t codes[kLanes];
    store(code, codes);
    for (; missing != 0; missing &= missing - 1)
      store_.make(static_cast<std::uint32_t>(codes[std::countr_zero(missing)]) / brick::kCells);
  }
  /// Undoes the additions, and repeats them one by one with saturation.
  HWY_NOINLINE void saturate() {
    std::uint32_t* cells = store_.cells(0);
    for (std::size_t l = 0; l < size_; ++l) cells[cell_[l]] -= count_[l];
    for (std::size_t l = 0; l < size_; ++l) {
      std::uint32_t& sum = cells[cell_[l]];
      sum = addSaturating(sum, count_[l]);
      if (sum == kFull) writer_.markSaturated();
    }
  }

  static constexpr std::size_t kSize = 16 * kLanes;
  CellWriter& writer_;
  BrickStore& store_;
  const std::uint32_t* slots_;
  std::size_t size_ = 0;
  std::uint32_t cell_[kSize], count_[kSize];
};

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
  const CellFrame& frame = writer.grid().frame;
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

/// Queue of pieces: parts of segments, each in one column of cells.
class Pieces {
 public:
  HWY_INLINE explicit Pieces(CellWriter& writer) : codes_(writer.grid()), adder_(writer) {}

  /// A column, within one wrap-around of [0, cells), as one number to which steps to its neighbours
  /// can be added.
  HWY_INLINE Ints column(Ints y, Ints z) const {
    const Ints n(codes_.cells());
    return shiftLeft<kY>(y + n) + (z + n);
  }
  static constexpr int kY = 16;  // bits below y

  /// Appends the pieces of the lanes `m`.
  HWY_INLINE void add(Ints column, Floats depth, Ints amount, Mask m) {
    if (HWY_UNLIKELY(size_ > kSize - kLanes)) write();
    compress(column, m, column_ + size_);
    compress(asInts(depth), m, depth_ + size_);
    size_ += compress(amount, m, amount_ + size_);
  }
  /// Shares a piece per lane between the two slices nearest to its depth, and adds it to the cells.
  HWY_INLINE void write(Ints column, Floats depth, Ints amount) {
    const Ints n(codes_.cells());
    const Ints across = codes_.across(codes_.turn(shiftRight<kY>(column) - n),
                                      codes_.turn((column & Ints(0xffff)) - n));
    const Floats x = depth - Floats(0.5f);
    const Ints slice = floorToInt(x);
    const Ints far = min(truncate(toFloats(amount) * (x - toFloats(slice))), amount);
    const Ints near = codes_.wrap(slice, 0);
    adder_.add(across + codes_.along(near), amount - far);
    adder_.add(across + codes_.along(codes_.next(near)), far);
  }
  HWY_INLINE void flush() {
    write();
    adder_.flush();
  }
  HWY_INLINE const CellCodes& codes() const { return codes_; }

 private:
  HWY_NOINLINE void write() {
    // Pad to sixteen with zero counts in the place of the first piece.
    store(Ints(column_[0]), column_ + size_);
    store(Ints(depth_[0]), depth_ + size_);
    store(Ints(0), amount_ + size_);
    for (std::size_t l = 0; l < size_; l += kLanes)
      write(loadInts(column_ + l), asFloats(loadInts(depth_ + l)), loadInts(amount_ + l));
    size_ = 0;
  }

  static constexpr std::size_t kSize = 256;
  CellCodes codes_;
  Adder adder_;
  std::size_t size_ = 0;
  // Padded: each append writes sixteen values.
  std::int32_t column_[kSize + kLanes], depth_[kSize + kLanes], amount_[kSize + kLanes];
};

/// AxisWalk (cell_walk.h) of sixteen segments: parameters of the next wall, the steps between
/// walls, and how many are left.
struct AxisWalks {
  Ints cell, way, left;
  Floats next, step;

  HWY_INLINE AxisWalks(Floats a, Floats b) : cell(floorToInt(a)) {
    const Ints last = floorToInt(b);
    const Mask up = last > cell;
    way = select(up, Ints(1), Ints(-1));
    left = max(last - cell, cell - last);
    const Floats perParameter = Floats(1.0f) / (b - a);
    const Floats wall = toFloats(cell + select(up, Ints(1), Ints(0)));
    const Floats first = max((wall - a) * perParameter, Floats(0.0f));
    next = select(left == Ints(0), Floats(AxisWalk::kNever), first);
    step = abs(perParameter);
  }
  /// As AxisWalk::cross, but leaves the cell to the caller.
  HWY_INLINE void cross(Mask now) {
    left = left - select(now, Ints(1), Ints(0));
    const Floats further = select(now, next + step, next);
    next = select(left == Ints(0), Floats(AxisWalk::kNever), further);
  }
};

/// depositColumns (segment_walk.h) of sixteen segments with counts below 2^30, all shorter than the
/// grid.
HWY_INLINE void walkColumns(Vec3 a, Vec3 b, Ints count, Pieces& pieces) {
  AxisWalks y(a.y, b.y), z(a.z, b.z);
  const CellCodes& codes = pieces.codes();
  Ints column = pieces.column(codes.wrap(y.cell, 1), codes.wrap(z.cell, 2));
  const Ints wayY = shiftLeft<Pieces::kY>(y.way), wayZ = z.way;
  const Floats whole = toFloats(count), middle = Floats(0.5f) * (b.x - a.x);
  Floats behind(0.0f);
  Ints left(0);
  for (Mask on = (count > Ints(0)) & ((y.left + z.left) > Ints(0)); any(on);) {
    // Cut at the next wall. Counts are differences of a rounded running sum, so that they add up.
    const Floats wall = min(max(min(y.next, z.next), behind), Floats(1.0f));
    const Ints reached = min(max(truncate(whole * wall), left), count);
    pieces.add(column, a.x + middle * (behind + wall), reached - left, on);
    left = select(on, reached, left);
    behind = select(on, wall, behind);
    // Step into the next column, along y or z.
    const Mask alongY = on & (y.next <= z.next), alongZ = on & !alongY;
    column = column + select(alongY, wayY, select(alongZ, wayZ, Ints(0)));
    y.cross(alongY);
    z.cross(alongZ);
    on = on & ((y.left + z.left) > Ints(0));
  }
  // Write the piece after the last wall, which all lanes have.
  pieces.write(column, a.x + middle * (behind + Floats(1.0f)), count - left);
}

/// SegmentScale::amount.
HWY_INLINE Floats amountOf(const SegmentScale& scale, Vec3 a, Vec3 b) {
  const Vec3 d = b - a;
  const Floats across = d.y * d.y + d.z * d.z;
  const bool acrossOnly = scale.of == SegmentMeasure::Of::AcrossX;
  if (scale.frame.curvature > 0) {
    const Floats g = magnification(scale.frame, Floats(0.5f) * (a + b));
    return acrossOnly ? Floats(scale.perCell) * sqrt(across) * g
                      : Floats(scale.perCell) * sqrt(across / (g * g) + d.x * d.x);
  }
  return Floats(scale.perCell) * sqrt(acrossOnly ? across : across + d.x * d.x);
}

/// Consecutive segments of any strands, those between the end of one strand and the next included.
struct SegmentBatch {
  static constexpr std::size_t kSize = 256;

  std::size_t size = 0;
  // Of point l, the start of segment l.
  float x[kSize + kLanes + 1], y[kSize + kLanes + 1], z[kSize + kLanes + 1];
  std::int32_t whole[kSize], part[kSize], count[kSize];
  std::uint32_t odd[kSize / kLanes];  // bits: too long, or too large a count for a lane

  /// Fills the batch with the segments that end in points[begin], points[begin + 1] ...; the first
  /// starts where the last batch ended.
  HWY_INLINE void fill(std::span<const glm::vec3> points, std::size_t begin,
                       const SegmentScale& scale, float longest, PointBox& box) {
    // Transform the points.
    x[0] = x[size], y[0] = y[size], z[0] = z[size];
    size = std::min(points.size() - begin, kSize);
    for (std::size_t l = 0; l < size; l += kLanes) {
      const Vec3 u = cellCoordinates(scale.frame, pointsFrom(points, begin + l));
      box.extend(u);
      store(u.x, x + l + 1), store(u.y, y + l + 1), store(u.z, z + l + 1);
    }
    // Split amounts into whole counts and parts of 2^-16, and mark odd segments.
    for (std::size_t l = 0; l < size; l += kLanes) {
      const Vec3 a = at(l), b = at(l + 1), d = b - a;
      const Floats amount = amountOf(scale, a, b);
      const Mask large = !(amount < Floats(Rounder::kWhole));
      const Floats held = select(large, Floats(0.0f), amount);
      const Ints floor = truncate(held);
      store(floor, whole + l);
      store(truncate((held - toFloats(floor)) * 65536.0f + 0.5f), part + l);
      // Subtract a cell, as rounding must not make a segment wrap around more than once.
      odd[l / kLanes] =
          bits(large | (max(max(abs(d.x), abs(d.y)), abs(d.z)) > Floats(longest - 1.0f)));
    }
    for (std::size_t l = size; l % kLanes != 0; ++l) leaveOut(l);
  }
  void begin(glm::vec3 u) {
    size = 0;
    x[0] = u.x, y[0] = u.y, z[0] = u.z;
  }
  bool anyOdd() const {
    std::uint32_t any = 0;
    for (std::size_t l = 0; l < size; l += kLanes) any |= odd[l / kLanes];
    return any != 0;
  }
  HWY_INLINE Vec3 at(std::size_t l) const {
    return {loadFloats(x + l), loadFloats(y + l), loadFloats(z + l)};
  }
  glm::vec3 point(std::size_t l) const { return {x[l], y[l], z[l]}; }
  /// Multiplies the amounts of segments [l, end) by `weight`, in fixed point.
  void weaken(std::size_t l, std::size_t end, float weight) {
    const auto times = static_cast<std::uint64_t>(std::lround(weight * 65536.0f));
    for (; l < end; ++l) {
      const auto amount = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(whole[l])) << 16) +
                          static_cast<std::uint64_t>(static_cast<std::uint32_t>(part[l]));
      const std::uint64_t less = amount * times >> 16;
      whole[l] = static_cast<std::int32_t>(less >> 16);
      part[l] = static_cast<std::int32_t>(less & 0xffff);
    }
  }
  void leaveOut(std::size_t l) {
    count[l] = 0;
    odd[l / kLanes] &= ~(1u << l % kLanes);
  }
};

/// Rounds the amounts of a batch to counts, one rounder per strand, and leaves out segments between
/// strands. `begin`: point at which the batch begins, `strand`: of that point.
void countSegments(std::span<const std::uint32_t> first, std::span<const float> weights,
                   std::size_t begin, std::size_t& strand, Rounder& rounder, SegmentBatch& batch) {
  for (std::size_t l = 0; l < batch.size;) {
    const std::size_t end = first[strand + 1] - first[0];
    if (!weights.empty() && weights[strand] < 1 && begin + l + 1 < end)
      batch.weaken(l, std::min(batch.size, end - begin - 1), weights[strand]);
    for (; l < batch.size && begin + l + 1 < end; ++l)
      batch.count[l] = static_cast<std::int32_t>(rounder.take(batch.whole[l], batch.part[l]));
    if (l == batch.size) return;
    if (begin + l + 1 == end) batch.leaveOut(l++);
    ++strand;
    rounder = {};
  }
}

/// Deposits the odd segments of a batch one by one, and leaves them out of it.
HWY_NOINLINE void writeOdd(const SegmentScale& scale, float longest, SegmentBatch& batch,
                           CellWriter& writer) {
  for (std::size_t l = 0; l < batch.size; ++l) {
    if ((batch.odd[l / kLanes] >> l % kLanes & 1) == 0) continue;
    const glm::vec3 a = batch.point(l), b = batch.point(l + 1);
    const float amount = scale.amount(a, b);
    depositColumns(
        a, b,
        amount < Rounder::kWhole ? static_cast<std::uint32_t>(batch.count[l]) : toCount(amount),
        longest, writer);
    batch.count[l] = 0;
  }
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
