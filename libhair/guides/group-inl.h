// A group of sixteen guides as a substep sees it; included by the solver's kernel
// (core/simd-inl.h).
#if defined(HAIR_GUIDES_GROUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIR_GUIDES_GROUP_INL_H
#undef HAIR_GUIDES_GROUP_INL_H
#else
#define HAIR_GUIDES_GROUP_INL_H
#endif

#include <libhair/guides/bending-inl.h>
#include <libhair/guides/links-inl.h>
#include <libhair/guides/nearby-inl.h>
#include <libhair/guides/scenery-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

/// What a substep reads and writes of one group: pointers into the arrays of GuideStrands.
struct Group {
  RootFrame rest;  // in head space
  BendingGroup bending;
  LaneVec3 *position, *velocity;
  Lanes* tension;
  const LaneVec3 *restPosition, *push;  // push: or null
  const Lanes* windShare;               // or null
  const Lanes *mass, *inverseMass, *linkLength, *mostTension, *mostCompression, *clearance;
  std::uint32_t points, tied;
  bool hasUnevenLinks;
};

/// Working memory of a group. Left uninitialised: it is sized for the longest strands.
struct Scratch {
  Vec3 x[kMaxGuidePoints], force[kMaxGuidePoints];  // points now; f per linear density
  Vec3 queriedAt[kMaxGuidePoints];                  // where colliders were last looked for
  Clearance clear[kMaxGuidePoints];                 // of the points at queriedAt
  Vec3 directions[kMaxGuidePoints];                 // of the links, unit, after the last substep
  Floats lambda[kMaxGuidePoints];                   // of the links (correctLinks)
  Floats way[kMaxGuidePoints];                      // metres of strand after the anchored points
  Contact contacts[kMaxGuidePoints];
  NearCapsule near[kMaxCapsules];
  NearPlane planes[kMaxPlanes];
  NearMesh meshes[kMaxMeshes];
};

/// Unit directions of the links.
template <class Points>
HWY_INLINE void findDirections(std::uint32_t points, const Points* x, Vec3* directions) {
  for (std::uint32_t i = 0; i + 1 < points; ++i) {
    const Vec3 e = Vec3(x[i + 1]) - Vec3(x[i]);
    directions[i] = (Floats(1.0f) / max(length(e), Floats(1e-12f))) * e;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
