#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/density/add_bricks.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include <libhair/core/parallel.h>
#include <libhair/density/add_bricks.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// Adds bricks begin to end - 1 of `from`. Slots of `sum` above `old` are uninitialised: overwrite.
bool addBricks(const BrickStore& from, std::size_t begin, std::size_t end, std::size_t old,
               BrickStore& sum) {
  const Ints lowest(std::numeric_limits<std::int32_t>::min());
  Mask full = none();
  for (std::size_t b = begin; b < end; ++b) {
    const auto* theirs =
        reinterpret_cast<const std::int32_t*>(from.cells(static_cast<std::uint32_t>(b + 1)));
    const std::uint32_t slot = sum.slot(from.places()[b]);
    auto* mine = reinterpret_cast<std::int32_t*>(sum.cells(slot));
    for (std::size_t c = 0; c < brick::kCells; c += kLanes) {
      const Ints t = loadInts(theirs + c);
      Ints s = t;
      if (slot <= old) {
        s = s + loadInts(mine + c);
        // Unsigned overflow, tested by a signed comparison.
        s = select((s + lowest) < (t + lowest), Ints(-1), s);
        full = full | (s == Ints(-1));
      }
      store(s, mine + c);
    }
  }
  return any(full);
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hair {

HWY_EXPORT(addBricks);

bool addBricks(BrickStore& from, BrickStore& sum) {
  // Claim places serially, one table look-up each; then add cells in parallel.
  const std::size_t old = sum.size();
  for (const std::uint32_t place : from.places()) sum.claim(place);
  std::atomic<bool> full = false;
  parallelFor(from.size(), 32, [&](std::size_t begin, std::size_t end) {
    if (HWY_DYNAMIC_DISPATCH(addBricks)(from, begin, end, old, sum)) full = true;
  });
  from.clear();
  return full;
}

}  // namespace hair

#endif
