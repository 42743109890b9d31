// What may happen between two frames: docs/guarantees.md.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/simulation/frame.h>

#include "scene.h"

namespace hair {
namespace {

using test::rmsDistance;
using test::Scene;
using test::small;
using test::stateOf;
using test::tipsOf;

RigidTransform about(float yaw, glm::vec3 translation) {
  return {glm::angleAxis(yaw, glm::vec3(0, 1, 0)), translation};
}

// A body that is elsewhere.
struct Moved {
  std::vector<Capsule> capsules;
  BodyState body;

  Moved(const RigidTransform& there, const BodyState& here)
      : capsules(here.capsules.begin(), here.capsules.end()),
        body{there * here.worldFromHead, capsules} {
    for (Capsule& c : capsules) c.a = there.point(c.a), c.b = there.point(c.b);
  }
};

TEST(Teleport, MovesEverythingWithTheHead) {
  Scene scene(small(Style::Curly), Motion::dance());
  for (int f = 0; f < 40; ++f) scene.step();
  const GuideStrands old = scene.hair.guides;
  const std::vector<LaneVec3> push = scene.hair.repulsion.push;
  const std::vector<glm::vec3> drawn = scene.hair.wisps.points;
  const std::vector<Capsule> capsules = scene.hair.capsules;
  const RigidTransform there = about(2, {3, 0.5f, -7});
  teleport(there * old.worldFromHead, scene.hair);
  const auto nearTo = [](glm::vec3 a, glm::vec3 b) {
    return glm::distance(a, b) <= 1e-6f * (1 + glm::length(b));
  };
  const GuideStrands& now = scene.hair.guides;
  for (std::size_t k = 0; k < old.position.size(); ++k)
    for (std::size_t l = 0; l < kLanes; ++l) {
      ASSERT_TRUE(nearTo(lane(now.position[k], l), there.point(lane(old.position[k], l))));
      ASSERT_TRUE(nearTo(lane(now.velocity[k], l), there.vector(lane(old.velocity[k], l))));
      ASSERT_TRUE(nearTo(lane(scene.hair.repulsion.push[k], l), there.vector(lane(push[k], l))));
    }
  for (std::size_t p = 0; p < drawn.size(); ++p)
    ASSERT_TRUE(nearTo(scene.hair.wisps.points[p], there.point(drawn[p])));
  for (std::size_t c = 0; c < capsules.size(); ++c)
    ASSERT_TRUE(nearTo(scene.hair.capsules[c].b, there.point(capsules[c].b)));
  EXPECT_TRUE(nearTo(scene.hair.pivot(), there.point(old.worldFromHead.translation)));
  EXPECT_LT(measureGuides(now, scene.settings.guides, {}, nullptr).stretchMax, 1e-4f);
}

// Two runs over `frames`, one of which is teleported after the first 30 and danced on over there;
// root of the mean squared distance of its tips from where the other's would be. `twin`: the other
// run is not teleported but begins 0.01 mm/s faster.
double apart(const RigidTransform& there, bool selfCollision, bool twin = false) {
  FrameSettings settings = Scene::simulationOnly();
  settings.selfCollision = selfCollision;
  settings.repulsion.strandStride = 1;  // of the few there are
  Scene stays(small(Style::Smooth), Motion::dance(), settings);
  Scene goes(small(Style::Smooth), Motion::dance(), settings);
  for (int f = 0; f < 30; ++f) stays.step(), goes.step();
  if (twin)
    for (LaneVec3& v : goes.hair.guides.velocity) v.x = v.x + 1e-5f;
  else
    teleport(there * goes.hair.worldFromHead, goes.hair);
  const RigidTransform back = twin ? RigidTransform{} : inverse(there);
  double most = 0;
  for (int f = 0; f < 60; ++f) {
    stays.step();
    goes.time += 1.0f / 60;
    const Moved moved(twin ? RigidTransform{} : there, goes.bodyAt(goes.time));
    frame(moved.body, settings, 1.0f / 60, goes.hair, goes.profile);
    std::vector<glm::vec3> tips = tipsOf(goes.hair);
    for (glm::vec3& tip : tips) tip = back.point(tip);
    most = std::max(most, rmsDistance(tips, tipsOf(stays.hair)));
  }
  return most;
}

TEST(Teleport, HairMovesAsItWouldHaveWithout) {
  // 0.06 mm is what rounding comes to; a twin's is 0.02 mm.
  EXPECT_LT(apart(about(2, {3, 0.5f, -7}), false), 1.2e-4);
  EXPECT_LT(apart({}, false, true), 5e-5);
}

TEST(Teleport, SelfCollisionGoesAlongByWholeCells) {
  // Density is counted in the world's cells of 2 cm: elsewhere, and turned, they cut hair
  // otherwise.
  EXPECT_LT(apart(about(0, {3, 0.5f, -7}), true), 2.5e-4);
  EXPECT_LT(apart(about(2, {3, 0.5f, -7}), true), 6e-3);
}

TEST(Teleport, IsNoMovement) {
  // A metre in a frame is 60 m/s; teleported there, hair at rest stays at rest.
  for (const bool jump : {false, true}) {
    Scene scene(small(Style::Smooth), Motion::still());
    scene.step();
    const Moved there(about(0.5f, {1, 0, 0}), scene.bodyAt(0));
    if (jump) teleport(there.body.worldFromHead, scene.hair);
    frame(there.body, scene.settings, 1.0f / 60, scene.hair, scene.profile);
    if (jump)
      EXPECT_LT(scene.stats().speedMax, 0.2f);
    else
      EXPECT_GT(scene.stats().speedMax, 20);
  }
}

/// Long hair on someone who stands, and a ball about the tip that is farthest behind.
struct Pierced {
  Scene scene{small(Style::Long), Motion::still()};
  std::vector<Capsule> more;
  Pierced() {
    for (int f = 0; f < 10; ++f) scene.step();
    const std::vector<glm::vec3> tips = tipsOf(scene.hair);
    const glm::vec3 middle = *std::ranges::min_element(tips, {}, &glm::vec3::z);
    const BodyState body = scene.bodyAt(0);
    more.assign(body.capsules.begin(), body.capsules.end());
    more.push_back({middle, middle, 0.06f});
  }
  BodyState body() const { return {scene.pose.worldFromHead, more}; }
  GuideStats stats() const {
    return measureGuides(scene.hair.guides, scene.settings.guides, more, &scene.collider);
  }
};

TEST(ChangedColliders, BringOutWhatTheyCatchAndNothingElse) {
  Pierced p;
  EXPECT_GT(p.stats().penetrationMax, 0.03f);
  const GuideStrands before = p.scene.hair.guides;
  changeColliders(p.body(), p.scene.settings, p.scene.hair);
  const GuideStrands& now = p.scene.hair.guides;
  EXPECT_LT(p.stats().penetrationMax, 1e-3f);
  EXPECT_LT(p.stats().stretchMax, 1e-3f);
  std::size_t moved = 0, stayed = 0;
  for (std::size_t g = 0; g < now.guideCount(); ++g) {
    bool same = true, clear = true;
    for (std::uint32_t i = 0; i < now.pointsPerGuide(); ++i) {
      same &= now.point(g, i) == before.point(g, i);
      for (const Capsule& c : p.more)
        clear &= distanceAndGradient(c, before.point(g, i)).w > p.scene.settings.guides.skin;
    }
    EXPECT_TRUE(same || !clear) << g;
    ++(same ? stayed : moved);
  }
  EXPECT_GT(moved, 5u);
  EXPECT_GT(stayed, 5u);
  for (std::size_t k = 0; k < now.velocity.size(); ++k)
    for (std::size_t l = 0; l < kLanes; ++l)
      ASSERT_EQ(lane(now.velocity[k], l), lane(before.velocity[k], l));
}

TEST(ChangedColliders, ThrowNothingWhetherMoreOrFewer) {
  Pierced p;
  Scene& scene = p.scene;
  float fastest = 0, deepest = 0;
  const auto run = [&](const BodyState& body, int frames) {
    for (int f = 0; f < frames; ++f) {
      frame(body, scene.settings, 1.0f / 60, scene.hair, scene.profile);
      const GuideStats s =
          measureGuides(scene.hair.guides, scene.settings.guides, body.capsules, &scene.collider);
      fastest = std::max(fastest, s.speedMax);
      deepest = std::max(deepest, s.penetrationMax);
    }
  };
  run(p.body(), 60);
  run(scene.bodyAt(0), 60);
  EXPECT_EQ(scene.hair.capsules.size(), p.more.size() - 1);
  // Hair that loses its support falls; nothing is faster than a fall of 0.2 m.
  EXPECT_LT(fastest, 2);
  EXPECT_LT(deepest, 1e-3f);
}

TEST(ChangedColliders, MoreThanThereMayBeAreRefused) {
  Pierced p;
  const std::string before = stateOf(p.scene.hair);
  p.more.resize(kMaxCapsules + 1, p.more.back());
  EXPECT_THROW(frame(p.body(), p.scene.settings, 1.0f / 60, p.scene.hair, p.scene.profile), Error);
  EXPECT_TRUE(stateOf(p.scene.hair) == before);
}

// The same guides, cut to a share of their length.
Groom trimmed(Groom groom, float share) {
  for (std::size_t g = 0; g < groom.guideCount(); ++g) {
    const glm::vec3 root = groom.guide(g)[0];
    for (std::uint32_t i = 0; i < groom.pointsPerGuide; ++i) {
      glm::vec3& p = groom.guidePoints[g * groom.pointsPerGuide + i];
      p = root + share * (p - root);
    }
  }
  return groom;
}

TEST(ChangedGroom, OfAsManyGuidesGoesOnMoving) {
  Scene scene(small(Style::Long), Motion::dance()), as(small(Style::Long), Motion::dance());
  for (int f = 0; f < 90; ++f) scene.step(), as.step();
  const GuideStrands before = scene.hair.guides;
  const Groom cut = trimmed(scene.groom, 0.95f);
  EXPECT_TRUE(changeGroom(cut, scene.settings, scene.hair));
  const GuideStrands& now = scene.hair.guides;
  EXPECT_EQ(scene.hair.time, as.hair.time);
  std::size_t kept = 0;
  for (std::size_t g = 0; g < now.guideCount(); ++g) {
    float off = 0;
    for (std::uint32_t i = 0; i + 1 < now.pointsPerGuide(); ++i) {
      const glm::vec3 a = before.point(g, i + 1) - before.point(g, i),
                      b = now.point(g, i + 1) - now.point(g, i);
      ASSERT_NEAR(glm::length(b), 0.95f * glm::length(a), 1e-5f);
      off = std::max(off, glm::distance(glm::normalize(a), glm::normalize(b)));
    }
    kept += off < 1e-4f ? 1 : 0;
  }
  float fastest = 0, fastestBefore = 0;
  for (int f = 0; f < 60; ++f) {
    scene.step(), as.step();
    fastest = std::max(fastest, scene.stats().speedMax);
    fastestBefore = std::max(fastestBefore, as.stats().speedMax);
  }
  EXPECT_GT(kept, now.guideCount() / 2) << "nothing is in the way of most";
  EXPECT_LT(fastest, 1.5f * fastestBefore);
  EXPECT_LT(scene.stats().penetrationMax, 1e-3f);
}

TEST(ChangedGroom, IntoItselfIsNoChangeOfTheMotion) {
  Scene scene(small(Style::Curly), Motion::dance());
  for (int f = 0; f < 30; ++f) scene.step();
  const std::vector<glm::vec3> before = tipsOf(scene.hair);
  EXPECT_TRUE(changeGroom(scene.groom, scene.settings, scene.hair));
  EXPECT_LT(rmsDistance(tipsOf(scene.hair), before), 1e-6);
}

TEST(ChangedGroom, OfOtherGuidesIsAtRestWhereTheHeadIs) {
  Scene scene(small(Style::Smooth), Motion::dance(), {});
  for (int f = 0; f < 60; ++f) scene.step();
  const Groom curly = makeGroom(styleSettings(Style::Curly), scene.collider);
  ASSERT_NE(curly.guideCount(), scene.groom.guideCount());
  EXPECT_FALSE(changeGroom(curly, scene.settings, scene.hair));
  EXPECT_EQ(scene.stats().speedMax, 0);
  EXPECT_LT(scene.stats().penetrationMax, 1e-3f);
  EXPECT_EQ(scene.hair.wisps.points.size(), curly.pointCount());
  scene.step();
  EXPECT_LT(scene.stats().speedMax, 3) << "no shock";
  EXPECT_EQ(scene.hair.colours.size(), curly.pointCount());
}

TEST(ChangedGroom, ThatIsBadIsRefusedAndChangesNothing) {
  Scene scene(small(Style::Smooth), Motion::dance());
  scene.step();
  const std::string before = stateOf(scene.hair);
  Groom bad = scene.groom;
  bad.weights[3] = glm::vec3(0.1f);
  EXPECT_THROW(changeGroom(bad, scene.settings, scene.hair), Error);
  EXPECT_TRUE(stateOf(scene.hair) == before);
  EXPECT_EQ(scene.hair.groom, &scene.groom);
}

TEST(BetweenFrames, WhatIsNotFiniteIsRefusedAndLeavesTheHairAsItWas) {
  Scene scene(small(Style::Smooth), Motion::still());
  scene.step();
  const std::string before = stateOf(scene.hair);
  BodyState body = scene.bodyAt(0);
  std::vector<Capsule> capsules(body.capsules.begin(), body.capsules.end());
  capsules.push_back({{NAN, 0, 0}, {0, 1, 0}, 0.1f});
  body.capsules = capsules;
  EXPECT_THROW(changeColliders(body, scene.settings, scene.hair), Error);
  EXPECT_THROW(frame(body, scene.settings, 1.0f / 60, scene.hair, scene.profile), Error);
  EXPECT_THROW(teleport({{1, 0, 0, 0}, {0, INFINITY, 0}}, scene.hair), Error);
  EXPECT_TRUE(stateOf(scene.hair) == before);
  scene.step();
}

}  // namespace
}  // namespace hair
