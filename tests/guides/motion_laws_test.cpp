// Laws of motion that guides follow with either solver: known frequencies, free fall, lengths, and
// that no place, direction or hand is better than another.

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/random.h>
#include <libhair/guides/guide_strands.h>

#include "sphere_groom.h"

namespace hair {
namespace {

using test::oneStrand;
using test::sphereGroom;

// A free strand that nothing slows down.
GuideSettings bare(LinkSolver solver) {
  GuideSettings settings;
  settings.bendingStiffness = 1e-14f;
  settings.airDrag = 0;
  settings.bendDamping = 0;
  settings.substep = 1e-3f;
  settings.linkSolver = solver;
  if (solver == LinkSolver::Relaxation) settings.iterations = 8;
  return settings;
}

constexpr LinkSolver kSolvers[] = {LinkSolver::Direct, LinkSolver::Relaxation};

const char* name(LinkSolver solver) {
  return solver == LinkSolver::Direct ? "direct" : "relaxation";
}

// Seconds between upward zero crossings of the tip's coordinate, by linear interpolation; mean over
// `periods`.
double periodOf(GuideStrands& guides, const GuideSettings& settings, int periods, int axis = 0) {
  GuideWorkspace workspace;
  std::vector<double> crossings;
  const auto tip = [&] {
    return static_cast<double>(guides.point(0, guides.pointsPerGuide() - 1)[axis]);
  };
  double before = tip();
  for (int i = 1; i < 20'000 && static_cast<int>(crossings.size()) <= periods; ++i) {
    stepGuides({guides.worldFromHead, {}, {}}, settings, settings.substep, workspace, guides);
    const double x = tip();
    if (before < 0 && x >= 0)
      crossings.push_back((i - x / (x - before)) * static_cast<double>(settings.substep));
    before = x;
  }
  EXPECT_GT(static_cast<int>(crossings.size()), periods);
  if (static_cast<int>(crossings.size()) <= periods) return 0;
  return (crossings.back() - crossings.front()) / periods;
}

// Moves a strand from the origin aside along `axis` by a small shape(s), s in [0, 1] from root.
template <class Shape>
void displace(GuideStrands& guides, int axis, Shape shape) {
  const std::uint32_t n = guides.pointsPerGuide();
  for (std::uint32_t i = 0; i < n; ++i) {
    glm::vec3 p = guides.point(0, i);
    p[axis] = static_cast<float>(shape(static_cast<double>(i) / (n - 1)));
    for (std::size_t l = 0; l < kLanes; ++l) setLane(guides.position[i], l, p);
  }
}

TEST(MotionLaws, AHangingChainSwingsAtTheZerosOfBesselJ0) {
  // Small oscillations of a hanging chain: omega = (j / 2) sqrt(g / L), shape J0(j sqrt(1 - s)).
  const float length = 0.3f;
  for (const LinkSolver solver : kSolvers)
    for (const double j : {2.404825557695773, 5.520078110286311, 8.653727912911013}) {
      const GuideSettings settings = bare(solver);
      GuideStrands guides(oneStrand({0, -1, 0}, length, 60), settings);
      displace(guides, 0, [&](double s) {
        return -1e-3 * (std::cyl_bessel_j(0, j * std::sqrt(1 - s)) - std::cyl_bessel_j(0, j));
      });
      const double omega = 0.5 * j * std::sqrt(9.81 / static_cast<double>(length));
      EXPECT_NEAR(periodOf(guides, settings, 2) * omega / (2 * std::numbers::pi), 1, 2e-3)
          << name(solver) << ", mode of zero " << j;
    }
}

TEST(MotionLaws, TwoEqualLinksSwingAsADoublePendulum) {
  // Masses l at the joint and l / 2 at the tip. Lower mode of small oscillations, and its shape:
  // angle of the lower link over that of the upper one.
  const double l = 0.1, g = 9.81, mu = 1 + 1 / 0.5, ratio = std::sqrt(mu);
  const double omega2 = g / l * (mu - ratio) / (mu - 1);
  for (const LinkSolver solver : kSolvers) {
    const GuideSettings settings = bare(solver);
    GuideStrands guides(oneStrand({0, -1, 0}, 0.2f, 2), settings);
    displace(guides, 0, [&](double s) {
      return s == 0 ? 0 : s < 0.75 ? -1e-3 : -1e-3 * (1 + ratio);
    });
    EXPECT_NEAR(periodOf(guides, settings, 3) * std::sqrt(omega2) / (2 * std::numbers::pi), 1, 2e-4)
        << name(solver);
  }
}

TEST(MotionLaws, APendulumTakesLongerTheFartherItSwings) {
  // Nearly a point on one link, the second being a fiftieth of the first; let go at 60 degrees:
  // T = 2 pi sqrt(l / g) / agm(1, cos(30°)).
  const float l = 0.2f, turn = std::numbers::pi_v<float> / 3;
  const glm::vec3 down(-std::sin(turn), -std::cos(turn), 0);
  Groom groom;
  groom.pointsPerGuide = 3;
  groom.guidePoints = {glm::vec3(0), l * down, 1.02f * l * down};
  double a = 1, b = std::cos(std::numbers::pi / 6);
  for (int i = 0; i < 6; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b), a = mean;
  }
  const double period = 2 * std::numbers::pi * std::sqrt(static_cast<double>(l) / 9.81) / a;
  for (const LinkSolver solver : kSolvers) {
    const GuideSettings settings = bare(solver);
    GuideStrands guides(groom, settings);
    for (LaneVec3& c : guides.curvature) c = LaneVec3{};
    // Relaxation loses some height, and a swing from less high takes less long.
    EXPECT_NEAR(periodOf(guides, settings, 3) / period, 1,
                solver == LinkSolver::Direct ? 5e-4 : 0.0125)
        << name(solver);
  }
}

TEST(MotionLaws, AClampedStrandVibratesAsABeam) {
  // First mode of a clamped beam without weight: omega = 1.8751² sqrt(E I / (rho L^4)).
  const double k = 1.875104068711961, ratio = 0.734095513758877, length = 0.1;
  for (const LinkSolver solver : kSolvers) {
    GuideSettings settings = bare(solver);
    settings.gravity = glm::vec3(0);
    settings.bendingStiffness = 1e-8f;
    settings.tipStiffness = 1;
    GuideStrands guides(oneStrand({0, -1, 0}, 0.1f, 40), settings);
    displace(guides, 0, [&](double s) {
      return -2e-4 *
             (std::cosh(k * s) - std::cos(k * s) - ratio * (std::sinh(k * s) - std::sin(k * s)));
    });
    const double omega = k * k / (length * length) *
                         std::sqrt(static_cast<double>(settings.bendingStiffness) /
                                   static_cast<double>(settings.linearDensity));
    EXPECT_NEAR(periodOf(guides, settings, 2) * omega / (2 * std::numbers::pi), 1, 1.3e-3)
        << name(solver);
  }
}

// Strands bent each its own way, in head space.
Groom crooked() {
  Groom groom;
  groom.pointsPerGuide = 16;
  for (std::uint32_t s = 0; s < 2 * kLanes; ++s) {
    glm::vec3 p(0.02f * static_cast<float>(s % kLanes), 0, 0.03f * static_cast<float>(s / kLanes));
    glm::vec3 way = glm::normalize(glm::vec3(0.3f, 0.5f - uniform(s, 9), 0.2f));
    for (std::uint32_t i = 0; i < groom.pointsPerGuide; ++i) {
      groom.guidePoints.push_back(p);
      const std::uint32_t draw = s * groom.pointsPerGuide + i;
      way = glm::normalize(
          way + 0.3f * (glm::vec3(uniform(draw, 0), uniform(draw, 1), uniform(draw, 2)) - 0.5f));
      p += (0.01f + 0.005f * uniform(draw, 3)) * way;
    }
  }
  return groom;
}

using HeadMotion = std::function<RigidTransform(double)>;

// Turns about Y and nods (1 rad, 1 Hz), and goes up and down and aside.
RigidTransform dancing(double t) {
  const auto w = static_cast<float>(2 * std::numbers::pi * t);
  return {glm::angleAxis(std::sin(w), glm::vec3(0, 1, 0)) *
              glm::angleAxis(0.3f * std::sin(1.5f * w), glm::vec3(1, 0, 0)),
          {0.1f * std::sin(w), 0.05f * std::sin(2 * w), 0}};
}

std::vector<glm::vec3> perform(const Groom& groom, const GuideSettings& rest,
                               const GuideSettings& settings, const HeadMotion& head, int frames,
                               float frame = 1.0f / 60) {
  GuideStrands guides(groom, rest, head(0));
  GuideWorkspace workspace;
  for (int f = 1; f <= frames; ++f)
    stepGuides({head(f * static_cast<double>(frame)), {}, {}}, settings, frame, workspace, guides);
  std::vector<glm::vec3> points(groom.guidePoints.size());
  guides.copyPoints(points);
  return points;
}

template <class Back>
float farthest(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b, Back back) {
  float worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, glm::distance(a[i], back(b[i])));
  return worst;
}

TEST(MotionLaws, WhatFallsWithItsRootFallsAsABody) {
  // Steps of h take a falling point to g h² n (n + 1) / 2. A groom that was made without gravity
  // keeps its shape in free fall.
  for (const LinkSolver solver : kSolvers) {
    GuideSettings settings = bare(solver);
    settings.bendingStiffness = 8e-8f;
    GuideSettings weightless = settings;
    weightless.gravity = glm::vec3(0);
    const auto depth = [&](double t) {
      return 0.5 * 9.81 * t * (t + static_cast<double>(settings.substep));
    };
    const auto fall = [&](double t) {
      return RigidTransform{{1, 0, 0, 0}, {0, static_cast<float>(-depth(t)), 0}};
    };
    const Groom groom = crooked();
    const std::vector<glm::vec3> fallen =
        perform(groom, weightless, settings, fall, 500, settings.substep);
    EXPECT_LT(farthest(groom.guidePoints, fallen,
                       [&](glm::vec3 p) { return p + glm::vec3(0, depth(0.5), 0); }),
              1e-4f)
        << name(solver);
  }
}

float stretchOf(const GuideSettings& settings) {
  GuideStrands guides(sphereGroom(64, 16), settings, dancing(0));
  GuideWorkspace workspace;
  float worst = 0;
  for (int f = 1; f <= 120; ++f) {
    stepGuides({dancing(f / 60.0), {}, {}}, settings, 1.0f / 60, workspace, guides);
    worst = std::max(worst, measureGuides(guides, settings, {}, nullptr).stretchMax);
  }
  return worst;
}

TEST(MotionLaws, LengthsAreKeptInOneSubstepAFrame) {
  GuideSettings settings;
  settings.substep = 1.0f / 60;
  EXPECT_LT(stretchOf(settings), 1e-5f);
}

TEST(MotionLaws, StretchShrinksAsRelaxationGoesOn) {
  GuideSettings settings;
  settings.linkSolver = LinkSolver::Relaxation;
  float before = 0.24f;
  for (const int iterations : {2, 8, 32}) {
    settings.iterations = iterations;
    const float stretch = stretchOf(settings);
    EXPECT_LT(stretch, 0.5f * before) << iterations;
    before = stretch;
  }
  EXPECT_LT(before, 9e-3f);
}

TEST(MotionLaws, NoPlaceOrDirectionIsBetterThanAnother) {
  // Groom, head and gravity turned, all of it elsewhere: the same motion there.
  const glm::quat turn = glm::angleAxis(2.0f, glm::normalize(glm::vec3(1, -2, 0.5f)));
  const RigidTransform there{turn, {0.7f, -0.4f, 0.3f}}, back{glm::conjugate(turn), glm::vec3(0)};
  const Groom groom = crooked();
  Groom turned = groom;
  for (glm::vec3& p : turned.guidePoints) p = turn * p;
  for (const LinkSolver solver : kSolvers) {
    GuideSettings settings;
    settings.linkSolver = solver;
    GuideSettings settingsThere = settings;
    settingsThere.gravity = turn * settings.gravity;
    const auto moves = perform(groom, settings, settings, dancing, 120);
    const auto movesThere = perform(
        turned, settingsThere, settingsThere, [&](double t) { return there * dancing(t) * back; },
        120);
    EXPECT_GT(farthest(groom.guidePoints, moves, [](glm::vec3 p) { return p; }), 0.05f);
    EXPECT_LT(farthest(moves, movesThere, [&](glm::vec3 p) { return inverse(there).point(p); }),
              3e-5f)
        << name(solver);
  }
}

TEST(MotionLaws, NoHandIsBetterThanTheOther) {
  const auto mirrored = [](glm::vec3 p) { return glm::vec3(-p.x, p.y, p.z); };
  const Groom groom = crooked();
  Groom other = groom;
  for (glm::vec3& p : other.guidePoints) p = mirrored(p);
  const auto mirroredDance = [&](double t) {
    const RigidTransform head = dancing(t);
    const glm::quat q = head.rotation;
    return RigidTransform{{q.w, q.x, -q.y, -q.z}, mirrored(head.translation)};
  };
  for (const LinkSolver solver : kSolvers) {
    GuideSettings settings;
    settings.linkSolver = solver;
    // To the bit: only signs differ.
    EXPECT_EQ(farthest(perform(groom, settings, settings, dancing, 120),
                       perform(other, settings, settings, mirroredDance, 120), mirrored),
              0)
        << name(solver);
  }
}

}  // namespace
}  // namespace hair
