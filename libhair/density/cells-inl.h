// Cells of sixteen points side by side; see simd-inl.h for how kernels are compiled.
#if defined(HAIR_DENSITY_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_DENSITY_CELLS_INL_H
#undef HAIR_DENSITY_CELLS_INL_H
#else
#define HAIR_DENSITY_CELLS_INL_H
#endif

#include <cstddef>
#include <span>

#include <libhair/core/simd-inl.h>
#include <libhair/density/density_grid.h>
#include <libhair/density/grid_cells.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// Sixteen points from points[at] on; beyond the span, its last one is repeated.
HWY_INLINE Vec3 pointsFrom(std::span<const glm::vec3> points, std::size_t at) {
  return loadPoints(points.data() + at, points.size() - at);
}

/// CellFrame::bend.
HWY_INLINE Vec3 bend(Vec3 v, float k) {
  const Floats ahead = Floats(1.0f) + Floats(k) * v.x;
  const Floats across = Floats(k * k) * (v.y * v.y + v.z * v.z);
  const Floats rho = sqrt(ahead * ahead + across);
  const Floats sum = select(ahead > Floats(0.0f), rho + ahead, across / (rho - ahead + 1e-30f));
  const Floats g = Floats(2.0f) / sum;
  const Vec3 u(
      (Floats(2.0f) * v.x + Floats(k) * (v.x * v.x + v.y * v.y + v.z * v.z)) / (Floats(1.0f) + rho),
      g * v.y, g * v.z);
  return select(sum < Floats(1e-12f), Vec3(v.x, 1e9f, 1e9f), u);
}

/// CellFrame::cellCoordinates, bit-identical.
HWY_INLINE Vec3 cellCoordinates(const CellFrame& frame, Vec3 p) {
  Vec3 u = Vec3(frame.fraction) + rotate(frame.cellFromWorld, p - Vec3(frame.anchor));
  if (frame.curvature > 0) u = bend(u, frame.curvature);
  const auto clamp = [](Floats c) HWY_ATTR { return min(max(c, Floats(-1e9f)), Floats(1e9f)); };
  return {clamp(u.x), clamp(u.y), clamp(u.z)};
}

/// CellFrame::magnification.
HWY_INLINE Floats magnification(const CellFrame& frame, Vec3 u) {
  const float k = frame.curvature;
  return (Floats(1.0f) + Floats(0.25f * k * k) * (u.y * u.y + u.z * u.z)) /
         max(Floats(1.0f) + Floats(k) * u.x, 1e-6f);
}

/// Storage codes of unwrapped cells: place · brick::kCells + offset.
class CellCodes {
 public:
  HWY_INLINE explicit CellCodes(const DensityGrid& grid)
      : grid_(grid),
        frame_(grid.cells->frame),
        cells_(grid.settings.cells),
        perY_(grid.cells->bricks.perAxis().y),
        across_(static_cast<std::int32_t>(grid.cells->bricks.across())) {}

  /// DensityGrid::wrap of unwrapped cells.
  HWY_INLINE void wrap(Ints& x, Ints& y, Ints& z) const {
    const glm::ivec3 base = frame_.base;
    x = turn(x + Ints(base.x)), y = turn(y + Ints(base.y)), z = turn(z + Ints(base.z));
    if (HWY_UNLIKELY(any(outside(x) | outside(y) | outside(z)))) {
      farther(x), farther(y), farther(z);
    }
  }
  /// DensityGrid::wrap along one axis.
  HWY_INLINE Ints wrap(Ints c, int axis) const {
    Ints i = turn(c + Ints(frame_.base[axis]));
    if (HWY_UNLIKELY(any(outside(i)))) farther(i);
    return i;
  }
  /// Wraps at most once: [-cells, 2 cells) to [0, cells). Others stay outside.
  HWY_INLINE Ints turn(Ints i) const {
    // As unsigned numbers, values outside are larger than those inside.
    return minUnsigned(minUnsigned(i, i + Ints(cells_)), i - Ints(cells_));
  }
  /// The wrapped cell after a wrapped one.
  HWY_INLINE Ints next(Ints x) const { return select(x == Ints(cells_ - 1), Ints(0), x + Ints(1)); }
  /// A code is along(x) + across(y, z), of wrapped cells.
  HWY_INLINE Ints along(Ints x) const {
    return shiftLeft<8>(shiftRight<2>(x) * Ints(across_)) + shiftLeft<6>(x & Ints(brick::kX - 1));
  }
  HWY_INLINE Ints across(Ints y, Ints z) const {
    const Ints place = shiftRight<2>(z) * Ints(perY_) + shiftRight<4>(y);
    return shiftLeft<8>(place) +
           (shiftLeft<4>(z & Ints(brick::kZ - 1)) + (y & Ints(brick::kY - 1)));
  }
  HWY_INLINE Ints code(Ints x, Ints y, Ints z) const {
    wrap(x, y, z);
    return along(x) + across(y, z);
  }
  std::int32_t cells() const { return cells_; }

 private:
  HWY_INLINE Mask outside(Ints i) const { return (i < Ints(0)) | !(i < Ints(cells_)); }
  /// Slow path: some lanes are more than one grid from the anchor. Wrapping again undoes turn().
  HWY_NOINLINE void farther(Ints& i) const {
    std::int32_t each[kLanes];
    store(i, each);
    for (std::int32_t& e : each) e = grid_.wrap(e);
    i = loadInts(each);
  }

  static_assert(brick::kX == 4 && brick::kZ == 4 && brick::kY == 16);
  const DensityGrid& grid_;
  const CellFrame& frame_;
  std::int32_t cells_, perY_, across_;
};

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
