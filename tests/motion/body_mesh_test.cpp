#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include <libhair/core/parallel.h>
#include <libhair/motion/body_mesh.h>
#include <libhair/motion/landmarks.h>
#include <libhair/motion/motion.h>

#include "clips.h"

namespace hair {
namespace {

/// Metres that a place is outside of all capsules; negative inside.
float outside(const std::vector<Capsule>& capsules, glm::vec3 p) {
  float nearest = 1e9f;
  for (const Capsule& c : capsules) {
    const glm::vec3 axis = c.b - c.a;
    const float l2 = glm::dot(axis, axis);
    const float t = l2 > 0 ? glm::clamp(glm::dot(p - c.a, axis) / l2, 0.0f, 1.0f) : 0.0f;
    nearest = std::min(nearest, glm::distance(p, c.a + t * axis) - c.radius);
  }
  return nearest;
}

const Motion& dance() {
  static const Motion motion = Motion::dance();
  return motion;
}
const BodyMesh& dancer() {
  static const BodyMesh mesh(dance().body());
  return mesh;
}

TEST(BodyMesh, IsClosedAndFacesOutwards) {
  const TriangleMesh& mesh = dancer().rest();
  EXPECT_GT(mesh.triangles.size(), 10'000u);
  EXPECT_LT(mesh.triangles.size(), 40'000u);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double volume = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
    volume +=
        glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z])) / 6.0;
  }
  // Each edge is walked once in each direction.
  EXPECT_TRUE(std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; }));
  // Litres of a slim woman without her head; parts overlap a little.
  EXPECT_GT(volume, 0.035);
  EXPECT_LT(volume, 0.075);
}

TEST(BodyMesh, TheRestStanceGivesTheRestMesh) {
  TriangleMesh out;
  dancer().skin(dance().body().rest, out);
  for (std::size_t v = 0; v < out.positions.size(); ++v) {
    ASSERT_LT(glm::distance(out.positions[v], dancer().rest().positions[v]), 1e-5f);
    ASSERT_LT(glm::distance(out.normals[v], dancer().rest().normals[v]), 1e-4f);
  }
}

TEST(BodyMesh, MovesRigidlyWithABodyMovedRigidly) {
  std::vector<RigidTransform> pose = dance().pose(4.0).worldFromJoint;
  TriangleMesh before, after;
  dancer().skin(pose, before);
  const RigidTransform move{turned({1, 2, 3}, 77), {3, -1, 2}};
  for (RigidTransform& joint : pose) joint = move * joint;
  const auto* data = (after = before).positions.data();
  dancer().skin(pose, after);
  EXPECT_EQ(after.positions.data(), data);  // no allocation
  for (std::size_t v = 0; v < before.positions.size(); ++v)
    ASSERT_LT(glm::distance(after.positions[v], move.point(before.positions[v])), 1e-5f);
}

TEST(BodyMesh, DoesNotDependOnTheThreads) {
  TriangleMesh one, seven;
  const std::vector<RigidTransform> pose = dance().pose(9.9).worldFromJoint;
  {
    const ThreadLimit limit(1);
    dancer().skin(pose, one);
  }
  const ThreadLimit limit(7);
  dancer().skin(pose, seven);
  EXPECT_EQ(one.positions, seven.positions);
  EXPECT_EQ(one.normals, seven.normals);
}

TEST(BodyMesh, HairOutsideTheCollidersIsOutsideTheDrawnBody) {
  std::vector<std::pair<std::string, Motion>> motions;
  motions.emplace_back("dance", dance());
  for (const char* name : {"jesse_dance", "05_11", "05_20"})
    if (std::filesystem::exists(realClip(name)))
      motions.emplace_back(name, Motion(clipFromBvh(readBvh(realClip(name)))));
  for (const auto& [name, motion] : motions) {
    const BodyMesh body(motion.body(), 0.02f);
    const Landmarks m = landmarksOf(motion.body());
    TriangleMesh mesh;
    std::vector<float> all;
    float worst = 0;
    for (int i = 0; i < 12; ++i) {
      const BodyPose pose = motion.pose(motion.duration() * i / 12.0);
      body.skin(pose.worldFromJoint, mesh);
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const glm::vec3 rest = body.rest().positions[v];
        // Where hair hangs: from the waist to under the skull, out to the shoulder joints.
        if (rest.y < m.trunk(0.45f).y || rest.y > m.head.y - 0.01f ||
            std::abs(rest.x) > 1.1f * m.halfShoulders())
          continue;
        all.push_back(outside(pose.capsules, mesh.positions[v]));
        worst = std::max(worst, all.back());
      }
    }
    ASSERT_FALSE(all.empty());
    std::sort(all.begin(), all.end());
    EXPECT_LT(all[all.size() * 9 / 10], 0.004f) << name;
    EXPECT_LT(all[all.size() * 98 / 100], 0.006f) << name;  // folds between capsules
    EXPECT_LT(worst, 0.018f) << name;                       // armpits of raised arms
    // Nor far inside: the picture would show hair that floats.
    EXPECT_GT(all[all.size() / 2], -0.03f) << name;
    RecordProperty(name + "_worst_mm", std::to_string(1000 * worst));
  }
}

TEST(BodyMesh, AnUnknownSkeletonIsDrawnAsItsCapsules) {
  Clip clip = chainClip(4);
  clip.skeleton.names[3] = "head";
  clip.rotations.assign(4, glm::quat(1, 0, 0, 0));
  clip.positions = clip.skeleton.offsets;
  const Motion motion(clip);
  const BodyMesh body(motion.body(), 0.01f);
  EXPECT_GT(body.rest().triangles.size(), 50u);
  TriangleMesh mesh;
  const BodyPose pose = motion.pose(0);
  body.skin(pose.worldFromJoint, mesh);
  for (const glm::vec3& p : mesh.positions) ASSERT_LT(outside(pose.capsules, p), 0.001f);
}

}  // namespace
}  // namespace hair
