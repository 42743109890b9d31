// The parts of a substep against those of guides/literal.h.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/guides/substep_parts_test.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>
#include <libhair/guides/bending-inl.h>
#include <libhair/guides/links-inl.h>
#include <libhair/guides/relaxation-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// x, force [points], directions [links]: as solveBending, for the only group.
void bend(const GuideStrands& guides, const BendingFactors& factors, const LaneVec3& tangentBefore,
          const LaneVec3& normalBefore, const LaneVec3* directions, const LaneVec3* force,
          LaneVec3* x) {
  const std::uint32_t n = guides.pointsPerGuide();
  Vec3 f[kMaxGuidePoints], moved[kMaxGuidePoints], before[kMaxGuidePoints];
  for (std::uint32_t i = 0; i < n; ++i) f[i] = force[i], moved[i] = x[i];
  for (std::uint32_t i = 0; i + 1 < n; ++i) before[i] = directions[i];
  const BendingGroup group{n,
                           guides.curvature.data(),
                           guides.jointStiffness.data(),
                           guides.inverseLength.data(),
                           factors.inverseD.data(),
                           factors.below1.data(),
                           factors.below2.data(),
                           factors.damping};
  solveBending(group, {guides.rootTangent[0], guides.rootNormal[0]}, {tangentBefore, normalBefore},
               before, f, moved);
  for (std::uint32_t i = 0; i < n; ++i) store(moved[i], x[i]);
}

// Points of `touching` (a bit each) rest in all lanes on planes with these normals. Relaxation
// leaves lambda 0.
void correct(const GuideStrands& guides, LinkSolver solver, std::uint32_t touching,
             const LaneVec3* normals, Lanes* lambda, LaneVec3* x) {
  const std::uint32_t n = guides.pointsPerGuide();
  Vec3 moved[kMaxGuidePoints];
  Floats sum[kMaxGuidePoints];
  Contact contacts[kMaxGuidePoints];
  for (std::uint32_t i = 0; i < n; ++i) {
    moved[i] = x[i], sum[i] = 0.0f;
    contacts[i].touched = touching >> i & 1;
    contacts[i].touching = !none();
    contacts[i].plane.normal = normals[i];
  }
  const Lanes *length = guides.linkLength.data(), *inverseMass = guides.inverseMass.data();
  if (solver == LinkSolver::Direct)
    correctLinks(n, length, inverseMass, contacts, sum, moved);
  else
    relaxLinks(n, length, inverseMass, contacts, moved);
  for (std::uint32_t i = 0; i < n; ++i) store(moved[i], x[i]);
  for (std::uint32_t i = 0; i + 1 < n; ++i) store(sum[i], lambda[i]);
}

// The nearest plane of points that are the sixth of their strands; nothing is covered.
void nearest(std::span<const Capsule> now, std::span<const Capsule> before, float skin,
             const LaneVec3& p, LaneVec3& normal, LaneVec3& move, Lanes& offset, Lanes& distance) {
  NearCapsule near[kMaxCapsules];
  const Vec3 away(glm::vec3(100));
  const Vec3 anchors[kAnchoredPoints] = {away, away, away};
  for (std::size_t c = 0; c < now.size(); ++c)
    prepareCapsule(now[c], before[c], anchors, skin, near[c]);
  const SubstepColliders none{glm::mat3(1), glm::mat3(1), {}, {}, now, before, {}, nullptr, {}, {}};
  Clearance unknown(0);
  ContactPlane plane;
  nearestPlane(p, 5, 0.1f, skin, {none, {near, now.size()}, kFar, false}, {kFar, 0}, unknown,
               plane);
  store(plane.normal, normal), store(plane.surfaceMove, move);
  store(plane.offset, offset), store(plane.distance, distance);
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/random.h>
#include <libhair/guides/literal.h>

namespace hair {
namespace {

HWY_EXPORT(bend);
HWY_EXPORT(correct);
HWY_EXPORT(nearest);

constexpr std::uint32_t kPoints = 12, kLinks = kPoints - 1;

glm::vec3 scatter(std::uint32_t i, float reach) {
  return reach * (2.0f * glm::vec3(uniform(i, 0), uniform(i, 1), uniform(i, 2)) - 1.0f);
}

// Sixteen strands, each bent its own way, with links that differ.
Groom crooked() {
  Groom groom;
  groom.pointsPerGuide = kPoints;
  for (std::uint32_t s = 0; s < kLanes; ++s) {
    glm::vec3 p(0.02f * static_cast<float>(s), 0, 0), way(0.3f, -1, 0.2f);
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      groom.guidePoints.push_back(p);
      way = glm::normalize(way + scatter(s * kPoints + i, 0.3f));
      p += (0.01f + 0.01f * uniform(s, i)) * way;
    }
  }
  return groom;
}

// Lane l of an array.
std::vector<glm::dvec3> laneOf(const std::vector<LaneVec3>& v, std::size_t l) {
  std::vector<glm::dvec3> out;
  for (const LaneVec3& each : v) out.emplace_back(lane(each, l));
  return out;
}

void bendAgainstLiteral(float h) {
  const GuideSettings settings;
  GuideStrands guides(crooked(), settings);
  BendingFactors factors;
  factorBending(guides, h, settings.bendDamping, 1, factors);
  // Disturb points, directions and the root's frame before the substep.
  std::vector<LaneVec3> x = guides.position, force(kPoints), directions(kLinks);
  LaneVec3 tangentBefore, normalBefore;
  for (std::uint32_t l = 0; l < kLanes; ++l) {
    const glm::quat turn = glm::angleAxis(0.002f, glm::normalize(scatter(4000 + l, 1)));
    setLane(tangentBefore, l, turn * lane(guides.rootTangent[0], l));
    setLane(normalBefore, l, turn * lane(guides.rootNormal[0], l));
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      setLane(force[i], l, scatter(1000 + i * 16 + l, 0.1f));
      if (i > 0) setLane(x[i], l, lane(x[i], l) + scatter(i * 16 + l, 0.002f));
      if (i < kLinks)
        setLane(directions[i], l,
                glm::normalize(lane(guides.position[i + 1], l) - lane(guides.position[i], l) +
                               scatter(2000 + i * 16 + l, 0.001f)));
    }
  }
  std::vector<LaneVec3> y = x;
  HWY_DYNAMIC_DISPATCH(bend)
  (guides, factors, tangentBefore, normalBefore, directions.data(), force.data(), y.data());

  for (std::size_t l = 0; l < kLanes; ++l) {
    const std::vector<glm::dvec3> from = laneOf(x, l), got = laneOf(y, l);
    const std::vector<glm::dvec3> expected = literal::bend(
        literal::Guide(guides, l), {lane(guides.rootTangent[0], l), lane(guides.rootNormal[0], l)},
        {lane(tangentBefore, l), lane(normalBefore, l)}, laneOf(directions, l), laneOf(force, l),
        static_cast<double>(h), static_cast<double>(settings.bendDamping), from);
    double most = 0;
    for (std::uint32_t i = 0; i < kPoints; ++i)
      most = std::max(most, glm::distance(expected[i], from[i]));
    EXPECT_GT(most, 1e-4);
    for (std::uint32_t i = 0; i < kPoints; ++i)
      ASSERT_LT(glm::distance(got[i], expected[i]), 1e-4 * most + 3e-8) << "lane " << l;
  }
}

TEST(GuideParts, BendingSolvesItsImplicitSystem) {
  bendAgainstLiteral(1.0f / 480);
}

TEST(GuideParts, LongSubstepsTakeRestTensionIntoTheSystem) {
  bendAgainstLiteral(1.0f / 60);
}

// Links that are off their lengths, and points that touch.
struct StretchedLinks {
  GuideStrands guides{crooked(), {}};
  std::uint32_t touching = 0b001001101000;
  std::vector<LaneVec3> x = guides.position, normals{kPoints};

  StretchedLinks() {
    for (std::uint32_t i = 0; i < kPoints; ++i)
      for (std::uint32_t l = 0; l < kLanes; ++l) {
        if (i > 0) setLane(x[i], l, lane(x[i], l) + scatter(i * 16 + l, 0.001f));
        setLane(normals[i], l, glm::normalize(scatter(3000 + i * 16 + l, 1)));
      }
  }
  std::vector<literal::Contact> contacts(std::size_t l) const {
    std::vector<literal::Contact> contacts;
    for (std::uint32_t i = 0; i < kPoints; ++i)
      contacts.push_back({(touching >> i & 1) != 0, lane(normals[i], l)});
    return contacts;
  }
};

TEST(GuideParts, LinksTakeOneNewtonStep) {
  const StretchedLinks s;
  std::vector<LaneVec3> y = s.x;
  std::vector<Lanes> lambda(kLinks);
  HWY_DYNAMIC_DISPATCH(correct)
  (s.guides, LinkSolver::Direct, s.touching, s.normals.data(), lambda.data(), y.data());
  for (std::size_t l = 0; l < kLanes; ++l) {
    const literal::LinkStep expected =
        literal::correctLinks(literal::Guide(s.guides, l), s.contacts(l), laneOf(s.x, l));
    double most = 0;
    for (const double v : expected.lambda) most = std::max(most, std::abs(v));
    for (std::uint32_t i = 0; i < kLinks; ++i)
      ASSERT_NEAR(lambda[i][l], expected.lambda[i], 1e-4 * most) << "lane " << l;
    for (std::uint32_t p = 0; p < kPoints; ++p)
      ASSERT_LT(glm::distance(glm::dvec3(lane(y[p], l)), expected.x[p]), 1e-6) << "lane " << l;
  }
}

TEST(GuideParts, RelaxationTakesOneLinkAfterTheOther) {
  const StretchedLinks s;
  std::vector<LaneVec3> y = s.x;
  std::vector<Lanes> lambda(kLinks);
  HWY_DYNAMIC_DISPATCH(correct)
  (s.guides, LinkSolver::Relaxation, s.touching, s.normals.data(), lambda.data(), y.data());
  for (std::size_t l = 0; l < kLanes; ++l) {
    const literal::LinkStep expected =
        literal::relaxLinks(literal::Guide(s.guides, l), s.contacts(l), laneOf(s.x, l));
    for (std::uint32_t i = 0; i < kPoints; ++i)
      ASSERT_LT(glm::distance(glm::dvec3(lane(y[i], l)), expected.x[i]), 1e-6) << "lane " << l;
    // No later link disturbs the last: it has its length.
    EXPECT_NEAR(glm::distance(lane(y[kLinks - 1], l), lane(y[kLinks], l)),
                s.guides.linkLength[kLinks - 1][l], 1e-6f);
  }
}

TEST(GuideParts, ThePlaneIsThatOfTheNearestCapsule) {
  std::vector<Capsule> now, before;
  for (std::uint32_t c = 0; c < 5; ++c) {
    const glm::vec3 a = scatter(c, 0.2f), b = c == 2 ? a : scatter(c + 100, 0.2f);
    now.push_back({a, b, 0.03f + 0.05f * uniform(c, 7)});
    before.push_back({a + scatter(c + 200, 0.01f), b + scatter(c + 300, 0.01f), now[c].radius});
  }
  const float skin = 3e-3f;
  for (std::uint32_t i = 0; i < 500; ++i) {
    LaneVec3 p, normal, move;
    Lanes offset, distance;
    for (std::uint32_t l = 0; l < kLanes; ++l) setLane(p, l, scatter(1000 + i * 16 + l, 0.3f));
    HWY_DYNAMIC_DISPATCH(nearest)(now, before, skin, p, normal, move, offset, distance);
    for (std::size_t l = 0; l < kLanes; ++l) {
      std::size_t nearest = 0;
      glm::vec4 best(INFINITY);
      for (std::size_t c = 0; c < now.size(); ++c) {
        const glm::vec4 d = distanceAndGradient(now[c], lane(p, l));
        if (d.w < best.w) best = d, nearest = c;
      }
      ASSERT_NEAR(distance[l], best.w - skin, 1e-6f);
      ASSERT_LT(glm::distance(lane(normal, l), glm::vec3(best)), 1e-4f);
      ASSERT_NEAR(offset[l], glm::dot(lane(normal, l), lane(p, l)) - distance[l], 1e-6f);
      // The surface moves as its end points do, shared out along the axis.
      const glm::vec3 axis = now[nearest].b - now[nearest].a;
      const float t =
          nearest == 2
              ? 0
              : std::clamp(glm::dot(lane(p, l) - now[nearest].a, axis) / glm::dot(axis, axis), 0.0f,
                           1.0f);
      const glm::vec3 moved =
          glm::mix(now[nearest].a - before[nearest].a, now[nearest].b - before[nearest].b, t);
      ASSERT_LT(glm::distance(lane(move, l), moved), 1e-6f);
    }
  }
}

}  // namespace
}  // namespace hair

#endif
