// Guides at rest and on their way there: equilibrium, energy. What settings are refused.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/guides/guide_strands.h>

#include "sphere_groom.h"

namespace hair {
namespace {

using test::oneStrand;

// The default settings with either solver.
GuideSettings solvedBy(LinkSolver solver) {
  GuideSettings settings;
  settings.linkSolver = solver;
  return settings;
}
constexpr LinkSolver kSolvers[] = {LinkSolver::Direct, LinkSolver::Relaxation};

TEST(Guides, AClampedStrandSagsAsACantilever) {
  // A weightless groom, then gravity: a clamped beam under its own weight sinks at s by
  // q s² (6 L² - 4 L s + s²) / (24 E I), for small deflections.
  for (const LinkSolver solver : kSolvers) {
    GuideSettings settings = solvedBy(solver);
    settings.gravity = glm::vec3(0);
    settings.tipStiffness = 1;
    settings.bendingStiffness = 1e-6f;
    const double length = 0.1, q = 9.81 * static_cast<double>(settings.linearDensity),
                 tipSag = q * std::pow(length, 4) / (8 * 1e-6);
    GuideStrands guides(oneStrand({1, 0, 0}, 0.1f, 40), settings);
    settings.gravity = {0, -9.81f, 0};
    settings.airDrag = 50;
    GuideWorkspace workspace;
    for (int i = 0; i < 600; ++i) stepGuides({{}, {}, {}}, settings, 1.0f / 60, workspace, guides);
    for (std::uint32_t i = 1; i <= 40; ++i) {
      const double s = length * i / 40,
                   sag = q * s * s * (6 * length * length - 4 * length * s + s * s) / (24 * 1e-6);
      ASSERT_NEAR(-static_cast<double>(guides.point(0, i).y) / tipSag, sag / tipSag, 2e-3)
          << "point " << i;
    }
  }
}

// Curved strands that leave their roots at these angles above the horizon and turn down, in
// radians.
Groom curved(float first, float turnDown) {
  Groom groom;
  groom.pointsPerGuide = 16;
  for (int s = 0; s < 9; ++s) {
    glm::vec3 p(0.05f * static_cast<float>(s), 0, 0);
    const float turn = 0.08f * static_cast<float>(s - 4);
    for (int i = 0; i < 16; ++i) {
      groom.guidePoints.push_back(p);
      const float a = first - turnDown * static_cast<float>(i) + turn;
      p += 0.012f * glm::normalize(glm::vec3(std::cos(a), std::sin(a), 0.3f * std::sin(3 * a)));
    }
  }
  return groom;
}

// How far a tip moves at most in ten seconds.
float drift(const Groom& groom, const GuideSettings& settings) {
  GuideStrands guides(groom, settings);
  GuideWorkspace workspace;
  for (int frame = 0; frame < 600; ++frame)
    stepGuides({{}, {}, {}}, settings, 1.0f / 60, workspace, guides);
  float worst = 0;
  for (std::size_t g = 0; g < guides.guideCount(); ++g)
    worst = std::max(worst, glm::distance(guides.point(g, 15), groom.guide(g)[15]));
  return worst;
}

TEST(Guides, AnyGroomIsInEquilibriumWhereItIs) {
  // Slanted, upright, hanging: none moves when gravity acts from the first step on.
  for (const LinkSolver solver : kSolvers)
    EXPECT_LT(drift(curved(1.2f, 0.12f), solvedBy(solver)), 1e-8f);
}

TEST(Guides, WhatHangsIsInEquilibriumWithOneSubstepAFrameToo) {
  // Tension is then more than a step bears explicitly: the implicit system holds what is there at
  // rest.
  GuideSettings settings;
  settings.substep = 1.0f / 60;
  EXPECT_LT(drift(curved(-0.8f, 0.05f), settings), 1e-7f);
}

// Of the first strand: in motion, in gravity's field and in bent joints; per linear
// density.
double energyOf(const GuideStrands& guides) {
  double e = 0;
  const std::uint32_t n = guides.pointsPerGuide();
  for (std::uint32_t i = 0; i < n; ++i) {
    const glm::dvec3 v = lane(guides.velocity[i], 0), p = guides.point(0, i);
    e += static_cast<double>(guides.pointMass[i][0]) * (0.5 * glm::dot(v, v) + 9.81 * p.y);
  }
  glm::dvec3 before = lane(guides.rootTangent[0], 0);
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    const glm::dvec3 d = glm::dvec3(guides.point(0, i + 1) - guides.point(0, i)) /
                         static_cast<double>(guides.linkLength[i][0]);
    e += 0.5 * static_cast<double>(guides.jointStiffness[i][0]) * glm::dot(d - before, d - before);
    before = d;
  }
  return e;
}

TEST(Guides, EnergyNeverGrowsWithoutForcing) {
  const double fall = 9.81 * 0.5 * 0.3 * 0.3 * (1 - std::sqrt(0.5));
  for (const LinkSolver solver : kSolvers)
    for (const float drag : {0.0f, GuideSettings{}.airDrag}) {
      GuideSettings settings = solvedBy(solver);
      settings.airDrag = drag;
      GuideStrands guides(oneStrand(glm::normalize(glm::vec3(1, -1, 0)), 0.3f, 15), settings);
      // Let go of the groom: straight rest shape without the torque that held it up.
      for (LaneVec3& c : guides.curvature) c = LaneVec3{};
      GuideWorkspace workspace;
      const double start = energyOf(guides);
      double lowest = start;
      // Of what falling to the hanging position sets free: rounding; and links that relax swing,
      // which drag ends.
      const double grows = solver == LinkSolver::Direct ? 2e-6 : drag > 0 ? 2e-5 : 0.012;
      for (int frame = 0; frame < 600; ++frame) {
        stepGuides({{}, {}, {}}, settings, 1.0f / 60, workspace, guides);
        const double now = energyOf(guides);
        ASSERT_LT(now, lowest + grows * fall) << "frame " << frame << ", drag " << drag;
        lowest = std::min(lowest, now);
      }
      EXPECT_LT(lowest, start - 0.2 * fall);
    }
}

TEST(Guides, BadSettingsAreRefusedByName) {
  const auto message = [](auto change) {
    GuideSettings s;
    change(s);
    try {
      validate(s);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(message([](GuideSettings&) {}), "accepted");
  EXPECT_NE(message([](GuideSettings& s) { s.substep = 0; }).find("substep"), std::string::npos);
  EXPECT_NE(message([](GuideSettings& s) { s.airDrag = NAN; }).find("airDrag"), std::string::npos);
  EXPECT_NE(message([](GuideSettings& s) { s.gravity.x = NAN; }).find("gravity"),
            std::string::npos);
  Groom groom = oneStrand({0, 1, 0}, 0.1f, 4);
  groom.guidePoints[2] = groom.guidePoints[1];
  EXPECT_THROW(GuideStrands(groom, {}), Error);
}

}  // namespace
}  // namespace hair
