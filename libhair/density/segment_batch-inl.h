// Segments of strands in cell coordinates, and the counts that they add. See simd-inl.h for how
// kernels are compiled.
#if defined(HAIR_DENSITY_SEGMENT_BATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_DENSITY_SEGMENT_BATCH_INL_H
#undef HAIR_DENSITY_SEGMENT_BATCH_INL_H
#else
#define HAIR_DENSITY_SEGMENT_BATCH_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include <libhair/density/cell_writer-inl.h>
#include <libhair/density/segment_walk.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

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
inline void countSegments(std::span<const std::uint32_t> first, std::span<const float> weights,
                          std::size_t begin, std::size_t& strand, Rounder& rounder,
                          SegmentBatch& batch) {
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
HWY_NOINLINE inline void writeOdd(const SegmentScale& scale, float longest, SegmentBatch& batch,
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

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
