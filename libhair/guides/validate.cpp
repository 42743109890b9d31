#include <libhair/guides/validate.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr float kFarthest = 1e8f;

// Written so that NaN fails too.
bool inWorld(glm::vec3 p) {
  return glm::all(glm::lessThan(glm::abs(p), glm::vec3(kFarthest)));
}

}  // namespace

void validate(const RigidTransform& t) {
  require(inWorld(t.translation), "head: position (", t.translation.x, ", ", t.translation.y, ", ",
          t.translation.z, ") m is not finite, or beyond 1e8 m");
  const glm::quat& q = t.rotation;
  require(std::abs(glm::dot(q, q) - 1) < 0.02f, "head: rotation (", q.w, ", ", q.x, ", ", q.y, ", ",
          q.z, ") is not of unit length; normalize it");
}

void validate(std::span<const Capsule> capsules) {
  for (std::size_t c = 0; c < capsules.size(); ++c) {
    const Capsule& capsule = capsules[c];
    require(inWorld(capsule.a) && inWorld(capsule.b) && capsule.radius >= 0 &&
                capsule.radius < kFarthest,
            "capsule ", c, ": from (", capsule.a.x, ", ", capsule.a.y, ", ", capsule.a.z, ") to (",
            capsule.b.x, ", ", capsule.b.y, ", ", capsule.b.z, ") with a radius of ",
            capsule.radius, " m is not finite, negative, or beyond 1e8 m");
  }
}

void validatePush(std::span<const LaneVec3> push) {
  // Test all without branches, and once at the end: pushes are nearly always valid.
  const Lanes most = lanes(1e6f);
  LaneMask bad{};
  for (const LaneVec3& p : push)
    bad |= ~((p.x < most) & (p.x > -most) & (p.y < most) & (p.y > -most) & (p.z < most) &
             (p.z > -most));
  for (std::size_t l = 0; l < kLanes; ++l)
    require(bad[l] == 0, "stepGuides: a push is not finite, or beyond 1e6 m/s^2");
}

float floatSpacing(float metres) {
  return std::nextafter(metres, INFINITY) - metres;
}

glm::vec3 stepOrigin(const RigidTransform& worldFromHead) {
  return 16.0f * glm::round(worldFromHead.translation / 16.0f);
}

void requirePrecision(const GuideStrands& guides, const RigidTransform& worldFromHead) {
  const glm::vec3 at = glm::abs(worldFromHead.translation);
  const float farthest = std::max({at.x, at.y, at.z}) + guides.reach();
  const float spacing = floatSpacing(farthest);
  // Each coordinate of both ends is rounded by at most half a spacing: sqrt(3) spacings along a
  // link.
  require(1.74f * spacing <= 0.01f * guides.shortestLink(), "guides: ", farthest,
          " m from the origin floats are ", spacing, " m apart, too coarse for links of ",
          guides.shortestLink(), " m; bring the origin nearer (moveOrigin), or take longer links");
}

}  // namespace hair
