#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/model/mesh_sdf_lookup_test.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>
#include <libhair/geometry/mesh_sdf-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// out: bound, distance, direction; in the lanes of `wanted`, a bit each.
void lookUp(const MeshSdf& sdf, const LaneVec3& p, std::uint32_t wanted, Lanes& bound,
            Lanes& distance, LaneVec3& direction) {
  std::int32_t chosen[kLanes];
  for (std::uint32_t l = 0; l < kLanes; ++l) chosen[l] = static_cast<std::int32_t>(wanted >> l & 1);
  const Mask mask = loadInts(chosen) > Ints(0);
  const SdfLookup lookup(sdf);
  store(lookup.lowerBound(p, mask), bound);
  store(lookup.distance(p, mask), distance);
  store(lookup.direction(p, mask), direction);
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include <libhair/core/instruction_set.h>
#include <libhair/core/random.h>

namespace hair {
namespace {

HWY_EXPORT(lookUp);

TriangleMesh wedge() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {0.08f, 0.01f, 0}, {0.02f, 0.07f, 0}, {0.03f, 0.02f, 0.06f}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  computeNormals(mesh);
  return mesh;
}

TEST(MeshSdfLookup, SixteenPointsGetTheBitsOfEach) {
  const MeshSdf sdf(wedge(), 0.005f, 0.02f);
  for (const std::string_view name : instructionSets()) {
    const InstructionSetLimit limit(name);
    for (std::uint32_t i = 0; i < 2000; ++i) {
      LaneVec3 p, direction;
      Lanes bound, distance;
      for (std::uint32_t l = 0; l < kLanes; ++l) {
        const std::uint32_t k = i * kLanes + l;
        // Half of them outside the grid; some on its borders, one nowhere.
        glm::vec3 q = 0.2f * glm::vec3(uniform(k, 0), uniform(k, 1), uniform(k, 2)) - 0.06f;
        if (k % 7 == 0) q.x = sdf.box().upper.x;
        if (k % 11 == 0) q.y = sdf.box().lower.y;
        if (k % 401 == 0) q.z = NAN;
        setLane(p, l, q);
      }
      const std::uint32_t wanted = i % 3 == 0 ? 0xffff : i * 2654435761u >> 16;
      HWY_DYNAMIC_DISPATCH(lookUp)(sdf, p, wanted, bound, distance, direction);
      for (std::size_t l = 0; l < kLanes; ++l) {
        const glm::vec3 q = lane(p, l);
        if (!(wanted >> l & 1) || std::isnan(q.z)) continue;
        ASSERT_EQ(bound[l], sdf.lowerBound(q)) << name;
        ASSERT_EQ(distance[l], sdf.distance(q)) << name;
        ASSERT_EQ(lane(direction, l), glm::vec3(sdf.distanceAndGradient(q))) << name;
      }
    }
  }
}

}  // namespace
}  // namespace hair

#endif
