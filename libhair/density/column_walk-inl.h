// Segments cut at the walls of columns of cells, sixteen at a time. See simd-inl.h for how kernels
// are compiled.
#if defined(HAIR_DENSITY_COLUMN_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_DENSITY_COLUMN_WALK_INL_H
#undef HAIR_DENSITY_COLUMN_WALK_INL_H
#else
#define HAIR_DENSITY_COLUMN_WALK_INL_H
#endif

#include <libhair/density/cell_walk.h>
#include <libhair/density/cell_writer-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

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
    if (size_ == 0) return;
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

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
