// What a kernel writes with a CellWriter, sixteen at a time: the bounds of its points, and counts
// of cells. See simd-inl.h for how kernels are compiled.
#if defined(HAIR_DENSITY_CELL_WRITER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_DENSITY_CELL_WRITER_INL_H
#undef HAIR_DENSITY_CELL_WRITER_INL_H
#else
#define HAIR_DENSITY_CELL_WRITER_INL_H
#endif

#include <bit>

#include <libhair/density/cell_walk.h>
#include <libhair/density/cell_writer.h>
#include <libhair/density/cells-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

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

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
