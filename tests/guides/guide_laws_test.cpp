// Guides against mechanics: equilibrium, known frequencies, energy, friction.

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/guides/measure.h>
#include <libhair/guides/step.h>

#include "sphere_groom.h"

namespace hair {
namespace {

using test::oneStrand;

// Seconds between upward zero crossings of the tip's x, by linear interpolation; mean over
// `periods`.
double periodOf(GuideStrands& guides, const GuideSettings& settings, float frame, int periods) {
  GuideWorkspace workspace;
  std::vector<double> crossings;
  double before = guides.point(0, guides.pointsPerGuide() - 1).x;
  for (int i = 1; i < 2'000'000 && static_cast<int>(crossings.size()) <= periods; ++i) {
    stepGuides({guides.worldFromHead, {}, {}}, settings, frame, workspace, guides);
    const double x = guides.point(0, guides.pointsPerGuide() - 1).x;
    if (before < 0 && x >= 0) crossings.push_back((i - x / (x - before)) * frame);
    before = x;
  }
  EXPECT_GT(static_cast<int>(crossings.size()), periods);
  return (crossings.back() - crossings.front()) / periods;
}

GuideSettings bare() {
  GuideSettings settings;
  settings.bendingStiffness = 1e-14f;
  settings.airDrag = 0;
  settings.bendDamping = 0;
  settings.substep = 1e-3f;
  return settings;
}

// Displaces a strand that hangs from the origin by a small sideways shape(s), s in [0, 1] from
// root.
template <class Shape>
void displace(GuideStrands& guides, Shape shape) {
  const std::uint32_t n = guides.pointsPerGuide();
  for (std::uint32_t i = 0; i < n; ++i)
    guides.position[i].x = lanes(static_cast<float>(shape(static_cast<double>(i) / (n - 1))));
}

TEST(Guides, HangingChainSwingsAtTheZerosOfBesselJ0) {
  // Small oscillations of a hanging chain: omega = (j / 2) sqrt(g / L), shape J0(j sqrt(1 - s)).
  const float length = 0.3f;
  const GuideSettings settings = bare();
  for (const double j : {2.404825557695773, 5.520078110286311}) {
    GuideStrands guides(oneStrand({0, -1, 0}, length, 60), settings);
    displace(guides, [&](double s) {
      return -1e-3 * (std::cyl_bessel_j(0, j * std::sqrt(1 - s)) - std::cyl_bessel_j(0, j));
    });
    const double omega = 0.5 * j * std::sqrt(9.81 / length);
    const double period = periodOf(guides, settings, 1e-3f, 2);
    EXPECT_NEAR(period * omega / (2 * std::numbers::pi), 1, 0.01) << "mode of zero " << j;
  }
}

TEST(Guides, TwoShortLinksUnderALongOneSwingAsAPendulum) {
  // Nearly a point mass on one link: the tip mass of equal links cannot be had with one link, so
  // compare with the exact double pendulum of equal links (masses l/2 at the tip, l in the middle).
  // Lower mode of (K - omega² M): links a, b of length l, masses m1 = l, m2 = l / 2.
  const float l = 0.1f;
  const GuideSettings settings = bare();
  GuideStrands guides(oneStrand({0, -1, 0}, 2 * l, 2), settings);
  const double g = 9.81, m1 = 1, m2 = 0.5, mu = 1 + m1 / m2;
  const double omega2 = g / l * (mu - std::sqrt(mu)) / (mu - 1);
  // Its shape: angle of the lower link over that of the upper one.
  const double ratio = std::sqrt(mu);
  displace(guides, [&](double s) { return s == 0 ? 0 : s < 0.75 ? -1e-3 : -1e-3 * (1 + ratio); });
  EXPECT_NEAR(periodOf(guides, settings, 1e-3f, 3), 2 * std::numbers::pi / std::sqrt(omega2), 2e-3);
}

TEST(Guides, AClampedStrandSagsAsACantilever) {
  // A weightless groom, then gravity: the tip of a clamped beam under its own weight sinks by
  // q L^4 / (8 E I), for small deflections.
  GuideSettings settings;
  settings.gravity = glm::vec3(0);
  settings.tipStiffness = 1;
  settings.bendingStiffness = 1e-6f;
  const float length = 0.1f;
  GuideStrands guides(oneStrand({1, 0, 0}, length, 40), settings);
  settings.gravity = {0, -9.81f, 0};
  settings.airDrag = 50;
  GuideWorkspace workspace;
  for (int i = 0; i < 600; ++i) stepGuides({{}, {}, {}}, settings, 1.0f / 60, workspace, guides);
  const double sag =
      settings.linearDensity * 9.81 * std::pow(length, 4) / (8 * settings.bendingStiffness);
  EXPECT_NEAR(-guides.point(0, 40).y / sag, 1, 0.02);
}

TEST(Guides, AnyGroomIsInEquilibriumWhereItIs) {
  // Curved, slanted, upright, hanging: none moves when gravity acts from the first step on.
  Groom groom;
  groom.pointsPerGuide = 16;
  for (int s = 0; s < 9; ++s) {
    glm::vec3 p(0.05f * static_cast<float>(s), 0, 0);
    const float turn = 0.08f * static_cast<float>(s - 4);
    for (int i = 0; i < 16; ++i) {
      groom.guidePoints.push_back(p);
      const float a = 1.2f - 0.12f * static_cast<float>(i) + turn;
      p += 0.012f * glm::normalize(glm::vec3(std::cos(a), std::sin(a), 0.3f * std::sin(3 * a)));
    }
  }
  const GuideSettings settings;
  GuideStrands guides(groom, settings);
  GuideWorkspace workspace;
  double worst = 0;
  for (int frame = 0; frame < 600; ++frame)
    stepGuides({{}, {}, {}}, settings, 1.0f / 60, workspace, guides);
  for (std::size_t g = 0; g < guides.guideCount(); ++g)
    worst = std::max(worst,
                     static_cast<double>(glm::distance(guides.point(g, 15), groom.guide(g)[15])));
  EXPECT_LT(worst, 1e-4);
}

TEST(Guides, EnergyNeverGrowsWithoutForcing) {
  const GuideSettings settings = [] {
    GuideSettings s;
    s.airDrag = 0;
    return s;
  }();
  GuideStrands guides(oneStrand(glm::normalize(glm::vec3(1, -1, 0)), 0.3f, 15), settings);
  // Let go of the groom: straight rest shape without the torque that held it up.
  for (LaneVec3& c : guides.curvature) c = LaneVec3{};
  GuideWorkspace workspace;
  const auto energy = [&] {
    double e = 0;
    const std::uint32_t n = guides.pointsPerGuide();
    for (std::uint32_t i = 0; i < n; ++i) {
      const glm::dvec3 v(guides.velocity[i].x[0], guides.velocity[i].y[0], guides.velocity[i].z[0]);
      e += guides.pointMass[i][0] * (0.5 * glm::dot(v, v) + 9.81 * guides.point(0, i).y);
    }
    glm::vec3 before(guides.rootTangent[0].x[0], guides.rootTangent[0].y[0],
                     guides.rootTangent[0].z[0]);
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      const glm::vec3 d = (guides.point(0, i + 1) - guides.point(0, i)) / guides.linkLength[i][0];
      e += 0.5 * guides.jointStiffness[i][0] * glm::dot(d - before, d - before);
      before = d;
    }
    return e;
  };
  double highest = energy();
  const double fall = 9.81 * 0.5 * 0.3 * 0.3 * (1 - std::sqrt(0.5));
  const double start = highest;
  for (int frame = 0; frame < 600; ++frame) {
    stepGuides({{}, {}, {}}, settings, 1.0f / 60, workspace, guides);
    // First-order steps exchange kinetic and potential energy a little late: allow a hundredth of
    // what falling to the hanging position sets free.
    ASSERT_LT(energy(), highest + 0.01 * fall) << "frame " << frame;
    highest = std::min(highest, energy());
  }
  EXPECT_LT(highest, start);
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
