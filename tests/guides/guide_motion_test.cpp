// Guides on moving heads: lengths, contact, threads.

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>
#include <libhair/core/state_hash.h>
#include <libhair/guides/guide_strands.h>

#include "sphere_groom.h"

namespace hair {
namespace {

using test::sphereGroom;

// The head of the common comparison: turns about Y (1 rad, 1 Hz), moves up and down (5 cm, 2 Hz).
RigidTransform shaken(double t, float amplitude = 1) {
  const auto w = static_cast<float>(2 * std::numbers::pi * t);
  return {glm::angleAxis(amplitude * std::sin(w), glm::vec3(0, 1, 0)),
          {0, 0.05f * amplitude * std::sin(2 * w), 0}};
}

Capsule headSphere(const RigidTransform& head) {
  return {head.translation, head.translation, 0.1f};
}

struct Worst {
  float stretch = 0, penetration = 0, speed = 0;
};

Worst shake(GuideStrands& guides, const GuideSettings& settings, int frames, float amplitude = 1) {
  GuideWorkspace workspace;
  Worst worst;
  Capsule before = headSphere(guides.worldFromHead);
  for (int frame = 1; frame <= frames; ++frame) {
    const RigidTransform head = shaken(frame / 60.0, amplitude);
    const Capsule now = headSphere(head);
    stepGuides({head, {&now, 1}, {&before, 1}}, settings, 1.0f / 60, workspace, guides);
    before = now;
    const GuideStats stats = measureGuides(guides, settings, {&now, 1}, nullptr);
    worst.stretch = std::max(worst.stretch, stats.stretchMax);
    worst.penetration = std::max(worst.penetration, stats.penetrationMax);
    worst.speed = std::max(worst.speed, stats.speedMax);
  }
  return worst;
}

TEST(Guides, StretchAndPenetrationStaySmallTogether) {
  const GuideSettings settings;
  GuideStrands guides(sphereGroom(402, 16), settings);
  const Worst worst = shake(guides, settings, 150);
  EXPECT_LT(worst.stretch, 1e-3f);
  EXPECT_LT(worst.penetration, 1e-3f);
  EXPECT_LT(worst.speed, 20.0f);
}

TEST(Guides, StayFiniteAndUnstretchedWhenShakenTwentyTimesHarder) {
  const GuideSettings settings;
  GuideStrands guides(sphereGroom(64, 16), settings);
  const Worst worst = shake(guides, settings, 120, 20);
  EXPECT_LT(worst.stretch, 1e-2f);
  EXPECT_TRUE(std::isfinite(worst.speed));
}

TEST(Guides, AColliderThatComesFromAfarWithinOneFrameStaysOut) {
  const GuideSettings settings;
  GuideStrands guides(test::oneStrand({0, -1, 0}, 0.3f, 15), settings);
  GuideWorkspace workspace;
  const Capsule before{{0.1f, -0.25f, 0}, {0.1f, -0.25f, 0}, 0.03f};
  const Capsule now{{0.01f, -0.25f, 0}, {0.01f, -0.25f, 0}, 0.03f};
  stepGuides({{}, {&now, 1}, {&before, 1}}, settings, 0.1f, workspace, guides);
  EXPECT_LT(guides.point(0, 13).x, -0.01f);
  EXPECT_LT(measureGuides(guides, settings, {&now, 1}, nullptr).penetrationMax, 1e-3f);
}

TEST(Guides, WhatIsTiedKeepsItsPlaceOnTheHeadAndTheRestSwings) {
  GuideSettings settings;
  for (const LinkSolver solver : {LinkSolver::Direct, LinkSolver::Relaxation}) {
    settings.linkSolver = solver;
    Groom groom = sphereGroom(40, 15);
    for (std::uint32_t g = 0; g < 40; ++g) groom.tied.push_back(g % 17);  // 0 and 1: the root
    GuideStrands guides(groom, settings), free(sphereGroom(40, 15), settings);
    const Worst worst = shake(guides, settings, 130);
    shake(free, settings, 130);
    for (std::uint32_t g = 0; g < 40; ++g) {
      for (std::uint32_t i = 0; i < std::max(groom.tied[g], 1u); ++i)
        EXPECT_LT(glm::distance(guides.point(g, i), guides.worldFromHead.point(groom.guide(g)[i])),
                  1e-6f)
            << g << ' ' << i;
      if (groom.tied[g] == 16) continue;
      EXPECT_GT(glm::distance(guides.point(g, 15), guides.worldFromHead.point(groom.guide(g)[15])),
                2e-5f)
          << g;
    }
    // A strand beside tied ones moves as one among free ones.
    for (const std::uint32_t g : {0u, 1u, 17u, 18u, 34u, 35u})
      EXPECT_EQ(guides.point(g, 15), free.point(g, 15)) << g;
    if (solver == LinkSolver::Direct) {
      EXPECT_LT(worst.stretch, 1e-3f);
    }
  }
}

TEST(Guides, SameBitsForAnyThreadCount) {
  const GuideSettings settings;
  std::vector<std::uint64_t> hashes;
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    GuideStrands guides(sphereGroom(201, 12), settings);
    shake(guides, settings, 60);
    StateHash hash;
    guides.addTo(hash);
    hashes.push_back(hash.value());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(Guides, SameBitsOnEveryInstructionSet) {
  GuideSettings settings;
  for (const LinkSolver solver : {LinkSolver::Direct, LinkSolver::Relaxation}) {
    settings.linkSolver = solver;
    std::vector<std::uint64_t> hashes;
    for (const std::string_view name : instructionSets()) {
      const InstructionSetLimit limit(name);
      GuideStrands guides(sphereGroom(201, 12), settings);
      shake(guides, settings, 60);
      StateHash hash;
      guides.addTo(hash);
      hashes.push_back(hash.value());
      EXPECT_EQ(hashes.back(), hashes.front()) << name;
    }
  }
}

TEST(Guides, ResetIsTheFirstFrameAgain) {
  const GuideSettings settings;
  GuideStrands guides(sphereGroom(16, 12), settings);
  const auto hashOf = [&] {
    StateHash hash;
    guides.addTo(hash);
    return hash.value();
  };
  const std::uint64_t fresh = hashOf();
  shake(guides, settings, 30);
  const std::uint64_t first = hashOf();
  guides.reset({});
  EXPECT_EQ(hashOf(), fresh);
  shake(guides, settings, 30);
  EXPECT_EQ(hashOf(), first);
}

TEST(Guides, WindBlowsTipsDownwind) {
  const GuideSettings settings;
  GuideStrands guides(test::oneStrand({0, -1, 0}, 0.3f, 15), settings);
  GuideWorkspace workspace;
  GuideMotion motion{{}, {}, {}};
  motion.wind.velocity = {3, 0, 0};
  motion.wind.gust = 0;
  for (int frame = 0; frame < 600; ++frame)
    stepGuides(motion, settings, 1.0f / 60, workspace, guides);
  // Drag balances weight and bending: the strand leans, but no more than drag over gravity allows.
  const glm::vec3 tip = guides.point(0, 15);
  EXPECT_GT(tip.x, 0.02f);
  EXPECT_LT(tip.x, 0.3f * std::sin(std::atan(settings.airDrag * 3 / 9.81f)));
  EXPECT_NEAR(tip.z, 0, 1e-4f);
}

TEST(Guides, FrictionHoldsWhatASmoothColliderLetsSlide) {
  // A strand laid over a sphere that turns under it: friction drags it along.
  const auto tipAngle = [](float friction) {
    GuideSettings settings;
    settings.friction = friction;
    settings.airDrag = 0;
    settings.bendingStiffness = 1e-12f;
    settings.gravity = glm::vec3(0);  // a groom that does not carry itself, so it presses
    Groom groom = test::oneStrand({1, 0, 0}, 0.15f, 15);
    for (glm::vec3& p : groom.guidePoints) p += glm::vec3(-0.075f, 0.103f, 0);
    GuideStrands guides(groom, settings);
    settings.gravity = {0, -9.81f, 0};
    GuideWorkspace workspace;
    Capsule before{{0, 0, 0}, {0, 0, 0}, 0.1f};
    // The collider moves sideways under the strand while the root stays.
    for (int frame = 1; frame <= 60; ++frame) {
      Capsule now = before;
      now.a.z = now.b.z = 0.0005f * static_cast<float>(frame);
      stepGuides({{}, {&now, 1}, {&before, 1}}, settings, 1.0f / 60, workspace, guides);
      before = now;
    }
    return guides.point(0, 8).z;
  };
  EXPECT_GT(tipAngle(1.0f), 2 * tipAngle(0.0f) + 1e-3f);
}

}  // namespace
}  // namespace hair
