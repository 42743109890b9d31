// The parts of a substep against literal ones: dense systems in double, one strand at a time.

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

// x, force [points], directions [links]: as solveBending. The root's frame stays.
void bend(const GuideStrands& guides, const BendingFactors& factors, const LaneVec3* directions,
          const LaneVec3* force, LaneVec3* x) {
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
  const RootFrame root{guides.rootTangent[0], guides.rootNormal[0]};
  solveBending(group, root, root, before, f, moved);
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

// The solution of a full system, by elimination.
template <class Value>
std::vector<Value> solve(std::vector<std::vector<double>> a, std::vector<Value> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return b;
}

struct Frame {
  glm::dvec3 tangent, normal;
  glm::dvec3 fromWorld(glm::dvec3 v) const {
    return {glm::dot(v, normal), glm::dot(v, glm::cross(tangent, normal)), glm::dot(v, tangent)};
  }
  glm::dvec3 toWorld(glm::dvec3 v) const {
    return v.x * normal + v.y * glm::cross(tangent, normal) + v.z * tangent;
  }
  void over(glm::dvec3 to) {
    const glm::dvec3 h = tangent + to;
    normal -= 2 * glm::dot(normal, to) / glm::dot(h, h) * h;
    tangent = to;
  }
};

TEST(GuideParts, BendingSolvesItsImplicitSystem) {
  const GuideSettings settings;
  GuideStrands guides(crooked(), settings);
  BendingFactors factors;
  const float h = 1.0f / 480;
  factorBending(guides, h, settings.bendDamping, 1, factors);
  std::vector<LaneVec3> x = guides.position, force(kPoints), directions(kLinks);
  for (std::uint32_t i = 0; i < kPoints; ++i)
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      setLane(force[i], l, scatter(1000 + i * 16 + l, 0.1f));
      if (i > 0) setLane(x[i], l, lane(x[i], l) + scatter(i * 16 + l, 0.002f));
      if (i < kLinks)
        setLane(directions[i], l,
                glm::normalize(lane(guides.position[i + 1], l) - lane(guides.position[i], l) +
                               scatter(2000 + i * 16 + l, 0.001f)));
    }
  std::vector<LaneVec3> y = x;
  HWY_DYNAMIC_DISPATCH(bend)(guides, factors, directions.data(), force.data(), y.data());

  const double damping = static_cast<double>(settings.bendDamping) / h;
  for (std::size_t l = 0; l < kLanes; ++l) {
    // Joint i takes q_i = sum_j q[i][j] x_j, the root's direction aside.
    std::vector<std::vector<double>> q(kLinks, std::vector<double>(kPoints)), a;
    for (std::uint32_t i = 0; i < kLinks; ++i) {
      const double next = 1.0 / guides.linkLength[i][l];
      q[i][i + 1] += next, q[i][i] -= next;
      if (i == 0) continue;
      const double before = 1.0 / guides.linkLength[i - 1][l];
      q[i][i] -= before, q[i][i - 1] += before;
    }
    std::vector<glm::dvec3> r;
    for (std::uint32_t i = 1; i < kPoints; ++i) r.emplace_back(lane(force[i], l));
    Frame now{lane(guides.rootTangent[0], l), lane(guides.rootNormal[0], l)}, then = now;
    glm::dvec3 d = now.tangent, dThen = then.tangent;
    for (std::uint32_t i = 0; i < kLinks; ++i) {
      const glm::dvec3 next = (glm::dvec3(lane(x[i + 1], l)) - glm::dvec3(lane(x[i], l))) /
                              static_cast<double>(guides.linkLength[i][l]);
      const glm::dvec3 nextThen = lane(directions[i], l), c = lane(guides.curvature[i], l);
      const glm::dvec3 e = now.fromWorld(next - d) - c;
      const glm::dvec3 change = e - (then.fromWorld(nextThen - dThen) - c);
      const glm::dvec3 g =
          static_cast<double>(guides.jointStiffness[i][l]) * now.toWorld(e + damping * change);
      for (std::uint32_t j = 1; j < kPoints; ++j) r[j - 1] -= q[i][j] * g;
      now.over(glm::normalize(next)), then.over(nextThen);
      d = next, dThen = nextThen;
    }
    a.assign(kLinks, std::vector<double>(kLinks));
    for (std::uint32_t j = 0; j < kLinks; ++j) {
      a[j][j] += guides.pointMass[j + 1][l] / (static_cast<double>(h) * h);
      for (std::uint32_t k = 0; k < kLinks; ++k)
        for (std::uint32_t i = 0; i < kLinks; ++i)
          a[j][k] += (1 + damping) * guides.jointStiffness[i][l] * q[i][j + 1] * q[i][k + 1];
    }
    const std::vector<glm::dvec3> moves = solve(a, r);
    double most = 0;
    for (const glm::dvec3& move : moves) most = std::max(most, glm::length(move));
    EXPECT_GT(most, 1e-4);
    for (std::uint32_t i = 1; i < kPoints; ++i) {
      const glm::dvec3 got = glm::dvec3(lane(y[i], l)) - glm::dvec3(lane(x[i], l));
      ASSERT_LT(glm::length(got - moves[i - 1]), 1e-4 * most + 3e-8) << "lane " << l;
    }
  }
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
  // Of the points: what a force moves them by.
  std::vector<glm::dmat3> inverseMasses(std::size_t l) const {
    std::vector<glm::dmat3> w(kPoints, glm::dmat3(0));
    for (std::uint32_t i = 1; i < kPoints; ++i) {
      const glm::dvec3 n = lane(normals[i], l);
      w[i] = glm::dmat3(1);
      if (touching >> i & 1) w[i] -= 0.98 * glm::outerProduct(n, n);
      w[i] *= 1.0 / static_cast<double>(guides.pointMass[i][l]);
    }
    return w;
  }
};

TEST(GuideParts, LinksTakeOneNewtonStep) {
  const StretchedLinks stretched;
  const auto& [guides, touching, x, normals] = stretched;
  std::vector<LaneVec3> y = x;
  std::vector<Lanes> lambda(kLinks);
  HWY_DYNAMIC_DISPATCH(correct)
  (guides, LinkSolver::Direct, touching, normals.data(), lambda.data(), y.data());
  for (std::size_t l = 0; l < kLanes; ++l) {
    const std::vector<glm::dmat3> w = stretched.inverseMasses(l);
    // Row i of J: -d_i at point i, d_i at point i + 1.
    std::vector<std::vector<glm::dvec3>> j(kLinks, std::vector<glm::dvec3>(kPoints, glm::dvec3(0)));
    std::vector<double> c(kLinks);
    for (std::uint32_t i = 0; i < kLinks; ++i) {
      const glm::dvec3 e = glm::dvec3(lane(x[i + 1], l)) - glm::dvec3(lane(x[i], l));
      j[i][i + 1] = glm::normalize(e), j[i][i] = -j[i][i + 1];
      c[i] = guides.linkLength[i][l] - glm::length(e);
    }
    std::vector<std::vector<double>> a(kLinks, std::vector<double>(kLinks));
    for (std::uint32_t r = 0; r < kLinks; ++r)
      for (std::uint32_t s = 0; s < kLinks; ++s)
        for (std::uint32_t p = 0; p < kPoints; ++p) a[r][s] += glm::dot(j[r][p], w[p] * j[s][p]);
    const std::vector<double> expected = solve(a, c);
    double most = 0;
    for (const double v : expected) most = std::max(most, std::abs(v));
    for (std::uint32_t i = 0; i < kLinks; ++i)
      ASSERT_NEAR(lambda[i][l], expected[i], 1e-4 * most) << "lane " << l;
    for (std::uint32_t p = 0; p < kPoints; ++p) {
      glm::dvec3 move(0);
      for (std::uint32_t r = 0; r < kLinks; ++r) move += expected[r] * (w[p] * j[r][p]);
      const glm::dvec3 got = glm::dvec3(lane(y[p], l)) - glm::dvec3(lane(x[p], l));
      ASSERT_LT(glm::length(got - move), 1e-6) << "lane " << l;
    }
  }
}

TEST(GuideParts, RelaxationTakesOneLinkAfterTheOther) {
  const StretchedLinks s;
  std::vector<LaneVec3> y = s.x;
  std::vector<Lanes> lambda(kLinks);
  HWY_DYNAMIC_DISPATCH(correct)
  (s.guides, LinkSolver::Relaxation, s.touching, s.normals.data(), lambda.data(), y.data());
  for (std::size_t l = 0; l < kLanes; ++l) {
    const std::vector<glm::dmat3> w = s.inverseMasses(l);
    std::vector<glm::dvec3> p;
    for (std::uint32_t i = 0; i < kPoints; ++i) p.emplace_back(lane(s.x[i], l));
    for (std::uint32_t i = 0; i < kLinks; ++i) {
      const glm::dvec3 e = p[i + 1] - p[i], d = glm::normalize(e);
      const double push = (static_cast<double>(s.guides.linkLength[i][l]) - glm::length(e)) /
                          glm::dot(d, (w[i] + w[i + 1]) * d);
      p[i] -= push * (w[i] * d);
      p[i + 1] += push * (w[i + 1] * d);
      // The link itself is then at its length, but for the second order where a contact turns it.
      EXPECT_NEAR(glm::distance(p[i], p[i + 1]), static_cast<double>(s.guides.linkLength[i][l]),
                  2e-4);
    }
    for (std::uint32_t i = 0; i < kPoints; ++i)
      ASSERT_LT(glm::distance(glm::dvec3(lane(y[i], l)), p[i]), 1e-6) << "lane " << l;
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
