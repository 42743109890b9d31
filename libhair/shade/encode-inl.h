// Writes linear radiance of sixteen points to ShadedPoints. Included by kernels once per
// instruction set (simd-inl.h), so it has no `#pragma once`.
#if defined(HAIR_SHADE_ENCODE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_SHADE_ENCODE_INL_H
#undef HAIR_SHADE_ENCODE_INL_H
#else
#define HAIR_SHADE_ENCODE_INL_H
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <libhair/core/simd-inl.h>
#include <libhair/shade/shaded_points.h>
#include <libhair/shade/srgb.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// SrgbTable::operator() of sixteen values; `bytes`: SrgbTable::bytes().
HWY_INLINE Ints srgbByte(const std::int32_t* bytes, Floats linear) {
  const Floats least(SrgbTable::kLeast), one(1.0f);
  const Floats x = select(linear > least, min(linear, one), least);
  return gather(bytes, shiftRight<23 - SrgbTable::kMantissaBits>(asInts(x) - asInts(least)));
}

/// Opaque colours of sixteen points.
HWY_INLINE Ints srgbColour(const std::int32_t* bytes, Vec3 radiance) {
  return srgbByte(bytes, radiance.x) | shiftLeft<8>(srgbByte(bytes, radiance.y)) |
         shiftLeft<16>(srgbByte(bytes, radiance.z)) | Ints(static_cast<std::int32_t>(0xff000000u));
}

/// Writes the points of a kernel.
struct PointWriter {
  ShadedPoints out;
  const std::int32_t* bytes = SrgbTable::get().bytes();

  /// Points p to p + n - 1, from the first n lanes. Encodes radiance while it is in registers,
  /// which saves a pass.
  HWY_INLINE void put(Vec3 radiance, std::size_t p, std::size_t n) const {
    if (out.radiance) {
      if (n == kLanes) {
        storePoints(radiance, out.radiance + p);
      } else {
        glm::vec3 room[kLanes];
        storePoints(radiance, room);
        std::copy_n(room, n, out.radiance + p);
      }
    }
    if (out.colours) {
      const Ints colour = srgbColour(bytes, radiance);
      if (n == kLanes) {
        store(colour, reinterpret_cast<std::int32_t*>(out.colours + p));
      } else {
        std::int32_t room[kLanes];
        store(colour, room);
        std::copy_n(room, n, reinterpret_cast<std::int32_t*>(out.colours + p));
      }
    }
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
