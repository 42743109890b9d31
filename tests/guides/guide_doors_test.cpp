// What a step refuses, and the smallest hair that it takes.

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/state_hash.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/guides/rest_shape.h>
#include <libhair/guides/substep_memory.h>

#include "sphere_groom.h"

namespace hair {
namespace {

using test::oneStrand;

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

TEST(GuideDoors, WhatIsNoNumberIsRefusedAndLeavesTheHairAsItWas) {
  const GuideSettings settings;
  GuideStrands guides(oneStrand({0, -1, 0}, 0.3f, 15), settings);
  GuideWorkspace workspace;
  StateHash fresh;
  guides.addTo(fresh);
  const Capsule good{{1, 0, 0}, {1, 0, 0}, 0.1f};
  const auto message = [&](const auto& change, float seconds = 1.0f / 60) {
    std::vector<Capsule> capsules = {good};
    std::vector<LaneVec3> push(guides.position.size());
    GuideMotion motion;
    change(motion, capsules, push);
    motion.capsules = capsules, motion.capsulesBefore = {&good, 1}, motion.push = push;
    return refusal([&] { stepGuides(motion, settings, seconds, workspace, guides); });
  };
  using Capsules = std::vector<Capsule>;
  using Push = std::vector<LaneVec3>;
  for (const float bad : {NAN, INFINITY, -INFINITY, 3e38f}) {
    const auto contains = [&](const std::string& text, const char* word) {
      EXPECT_NE(text.find(word), std::string::npos) << text << " for " << bad;
    };
    contains(
        message([&](GuideMotion& m, Capsules&, Push&) { m.worldFromHead.translation.y = bad; }),
        "head: position");
    contains(message([&](GuideMotion& m, Capsules&, Push&) { m.worldFromHead.rotation.x = bad; }),
             "head: rotation");
    contains(message([&](GuideMotion&, Capsules& c, Push&) { c[0].b.z = bad; }), "capsule 0");
    contains(message([&](GuideMotion&, Capsules& c, Push&) { c[0].radius = bad; }), "capsule 0");
    contains(message([&](GuideMotion&, Capsules&, Push& p) { p[3].y[0] = bad; }), "push");
    contains(message([&](GuideMotion& m, Capsules&, Push&) { m.wind.gustLength = bad; }), "wind");
    contains(message([&](GuideMotion&, Capsules&, Push&) {}, bad), "frame");
  }
  // Gusts shorter than any number can tell apart, and frames shorter than a position can change.
  EXPECT_NE(message([&](GuideMotion& m, Capsules&, Push&) { m.wind.gustLength = 1e-20f; }),
            "accepted");
  EXPECT_NE(message([&](GuideMotion&, Capsules&, Push&) {}, 1e-42f), "accepted");
  StateHash after;
  guides.addTo(after);
  EXPECT_EQ(after.value(), fresh.value());
  EXPECT_EQ(message([&](GuideMotion&, Capsules&, Push&) {}), "accepted");
}

TEST(GuideDoors, AGroomOfOnePointOrOfTooManyIsRefused) {
  for (const std::uint32_t links : {0u, 64u, 1000u})
    EXPECT_NE(refusal([&] {
                GuideStrands(oneStrand({0, -1, 0}, 0.3f, links), {});
              }).find("points a guide is not in 2 to 64"),
              std::string::npos)
        << links;
  Groom none;
  none.pointsPerGuide = 0;
  EXPECT_EQ(refusal([&] { GuideStrands(none, {}); }), "groom: no guides");
}

TEST(GuideDoors, AHeadFarFromTheOriginIsRefusedWhereRoundingWouldStretchItsLinks) {
  GuideSettings settings;
  GuideWorkspace workspace;
  GuideStrands guides(oneStrand({0, -1, 0}, 0.3f, 15), settings);
  const auto at = [&](float x) {
    return refusal([&] {
      guides.reset({{1, 0, 0, 0}, {x, x, -x}});
      for (int f = 0; f < 30; ++f) {
        const RigidTransform head{glm::angleAxis(0.1f * static_cast<float>(f), glm::vec3(0, 0, 1)),
                                  {x, x, -x}};
        stepGuides({head}, settings, 1.0f / 60, workspace, guides);
        EXPECT_LT(measureGuides(guides, settings, {}, nullptr).stretchMax, 1e-2f) << x;
      }
    });
  };
  // Floats of 0.5 to 1 km are 0.06 mm apart.
  EXPECT_EQ(at(0), "accepted");
  EXPECT_EQ(at(100), "accepted");
  EXPECT_EQ(at(1000), "accepted");
  EXPECT_NE(at(1100).find("bring the origin nearer"), std::string::npos);
  EXPECT_NE(at(1e7f).find("bring the origin nearer"), std::string::npos);
}

// Strands of one groom: links of these lengths, one below the other.
Groom hanging(const std::vector<float>& links) {
  Groom groom;
  groom.pointsPerGuide = static_cast<std::uint32_t>(links.size()) + 1;
  glm::vec3 p(0);
  groom.guidePoints.push_back(p);
  for (const float l : links) groom.guidePoints.push_back(p -= glm::vec3(0, l, 0));
  return groom;
}

TEST(GuideDoors, JointsTooStiffForFloatsTakeShorterSubstepsOrAreRefused) {
  const GuideSettings settings;
  const auto longest = [&](float link) {
    return GuideStrands(hanging(std::vector<float>(15, link)), settings).longestSubstep({});
  };
  EXPECT_GT(longest(0.02f), 1.0f);
  EXPECT_GT(longest(2e-4f), settings.substep);
  EXPECT_LT(longest(5e-5f), settings.substep);
  const std::string text = refusal([&] { longest(1e-5f); });
  for (const char* word : {"guide 0 link 0", "stiffness", "longer or more even links"})
    EXPECT_NE(text.find(word), std::string::npos) << text;

  GuideStrands guides(hanging(std::vector<float>(15, 5e-5f)), settings);
  GuideWorkspace workspace;
  for (int f = 0; f < 6; ++f) {
    stepGuides({}, settings, 1.0f / 60, workspace, guides);
    EXPECT_LE(workspace.memory().bending.substep, guides.longestSubstep({}));
  }
}

TEST(GuideDoors, ARootThatLeavesItsWayTakesShorterSubstepsAndOneThatKeepsItDoesNot) {
  const GuideSettings settings;
  GuideStrands guides(hanging(std::vector<float>(15, 0.02f)), settings);
  GuideWorkspace workspace;
  GuideMotion motion;
  const auto substepOf = [&](float way) {
    motion.worldFromHead.translation.x += way;
    stepGuides(motion, settings, 1.0f / 60, workspace, guides);
    return workspace.memory().bending.substep;
  };
  const float ordinary = substepOf(0);
  EXPECT_NEAR(ordinary, settings.substep, 1e-6f);
  // From rest to 30 m/s half of a link takes 1/3000 s; what then keeps its speed asks for nothing.
  EXPECT_LE(substepOf(0.5f), 1.0f / 3000 + 1e-7f);
  EXPECT_EQ(substepOf(0.5f), ordinary);
  // A jump: as short as may be.
  EXPECT_NEAR(substepOf(50), kShortestSubstep, 1e-6f);
}

TEST(GuideDoors, UnevenLinksTakeShorterSubstepsForMoreWeight) {
  GuideSettings settings;
  settings.bendingStiffness = 0;
  const GuideStrands guides(hanging({1e-3f, 1e-5f, 1e-3f}), settings);
  EXPECT_LT(guides.longestSubstep({}, 50), 0.5f * guides.longestSubstep({}));
  EXPECT_GE(guides.longestSubstep({}, 1e6f), kShortestSubstep);
  const GuideStrands even(hanging({1e-3f, 1e-3f, 1e-3f}), settings);
  EXPECT_EQ(even.longestSubstep({}, 50), even.longestSubstep({}));
}

TEST(GuideDoors, AShortLinkThatCarriesLongOnesRestsAndSwingsBack) {
  // A mass of 2 cm on 0.02 mm: tension turns it 50 times faster than a substep could follow.
  GuideSettings settings;
  settings.bendingStiffness = 0;
  const std::vector<float> links = {0.02f, 2e-5f, 0.02f};
  GuideStrands guides(hanging(links), settings);
  GuideWorkspace workspace;
  const auto run = [&](int frames) {
    float away = 0;
    for (int f = 0; f < frames; ++f) {
      stepGuides({}, settings, 1.0f / 60, workspace, guides);
      away = glm::length(glm::vec2(guides.point(0, 3).x, guides.point(0, 3).z));
    }
    return away;
  };
  EXPECT_EQ(run(60), 0);
  for (LaneVec3& v : guides.velocity) v.x = lanes(0.5f);
  EXPECT_GT(run(3), 5e-3f);
  EXPECT_LT(run(120), 4e-4f);
}

TEST(GuideDoors, OneLinkSwingsAsAPendulum) {
  const float l = 0.2f;
  GuideSettings settings;
  settings.bendingStiffness = 0;
  settings.airDrag = settings.bendDamping = 0;
  settings.substep = 1e-3f;
  GuideStrands guides(oneStrand({0, -1, 0}, l, 1), settings);
  guides.position[1].x = lanes(-2e-3f);
  GuideWorkspace workspace;
  std::vector<double> crossings;
  double before = guides.point(0, 1).x;
  for (int i = 1; i < 10000 && crossings.size() < 4; ++i) {
    stepGuides({}, settings, 1e-3f, workspace, guides);
    const double x = guides.point(0, 1).x;
    if (before < 0 && x >= 0) crossings.push_back((i - x / (x - before)) * 1e-3);
    before = x;
  }
  ASSERT_EQ(crossings.size(), 4u);
  EXPECT_NEAR((crossings[3] - crossings[0]) / 3, 2 * std::numbers::pi * std::sqrt(l / 9.81), 2e-3);
}

TEST(GuideDoors, HairWithoutStiffnessIsAStringThatHangs) {
  GuideSettings settings;
  settings.bendingStiffness = 0;
  for (const std::uint32_t links : {1u, 2u, 15u}) {
    GuideStrands guides(oneStrand(glm::normalize(glm::vec3(1, 0.2f, 0)), 0.3f, links), settings);
    GuideWorkspace workspace;
    for (int f = 0; f < 240; ++f) {
      stepGuides({}, settings, 1.0f / 60, workspace, guides);
      ASSERT_LT(measureGuides(guides, settings, {}, nullptr).stretchMax, 1e-3f);
    }
    EXPECT_NEAR(guides.point(0, links).y, -0.3f, 1e-4f) << links;
    EXPECT_NEAR(guides.point(0, links).x, 0, 3e-3f) << links;
  }
}

}  // namespace
}  // namespace hair
