// Frames under several lights, and under lights at points.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/parallel.h>
#include <libhair/shade/appearance.h>
#include <libhair/simulation/frame.h>
#include <tests/guides/sphere_groom.h>

#include "scene.h"

namespace hair {
namespace {

/// Every guide of a ball is drawn, and stands for many hairs.
Groom furryBall() {
  Groom groom = test::drawnSphereGroom(1500, 9, 0.06f);
  groom.fibre.hairsPerStrand = 40;
  return groom;
}

/// Hair on a ball as it was groomed, lit.
struct Ball {
  Groom groom = furryBall();
  Hair hair;
  FrameProfile profile{};

  explicit Ball(const FrameSettings& settings, glm::vec3 place = glm::vec3(0))
      : hair(groom, settings, {{{1, 0, 0, 0}, place}, {}}) {
    light(settings, hair, profile);
  }
  std::span<const float> transmittance(std::size_t l) const {
    const std::size_t n = hair.wisps.points.size();
    return std::span(hair.transmittance).subspan(l * n, n);
  }
};

FrameSettings litBy(std::vector<Light> lights) {
  FrameSettings settings;
  settings.selfCollision = false;
  settings.lights = std::move(lights);
  settings.map.cells = 96;
  settings.map.cellSize = 5e-3f;
  return settings;
}

const Light kRed = Light::parallel({1, 0, 0}, {1, 0, 0});         // from -x
const Light kBlue = Light::parallel({-1, 0, 0}, {0, 0, 1});       // from +x
const Light kLamp = Light::point({0.1f, 0.5f, 0.4f}, {0, 1, 0});  // near by

int byte(std::uint32_t colour, int channel) {
  return static_cast<int>(colour >> (8 * channel) & 255u);
}

TEST(FrameLights, EachShinesOnItsSide) {
  FrameSettings settings = litBy({kRed, kBlue});
  // Highlights belong to the eye's side too: without them only the light's side counts.
  KajiyaKaySettings look = KajiyaKaySettings::plain();
  look.rootColour = look.tipColour = glm::vec3(0.4f);
  look.ambient = look.specular = 0;
  settings.appearance = look;
  const Ball ball(settings);
  std::size_t left = 0, right = 0;
  for (std::size_t p = 0; p < ball.hair.colours.size(); ++p) {
    const glm::vec3 at = ball.hair.wisps.points[p];
    // Not by the silhouette, nor at the equator, under which the ball is bald: there light gets
    // past the ball from the other side. Nor at the roots: nothing but hair stops light, so that
    // either light has gone through the fur once when it gets there.
    if (std::abs(at.x) < 0.7f * glm::length(at) || at.y < 0.02f || glm::length(at) < 0.125f)
      continue;
    const int red = byte(ball.hair.colours[p], 0), blue = byte(ball.hair.colours[p], 2);
    if (at.x < 0) {
      ++left;
      EXPECT_GT(ball.transmittance(0)[p], ball.transmittance(1)[p]);
      EXPECT_GT(red, blue);
    } else {
      ++right;
      EXPECT_LT(ball.transmittance(0)[p], ball.transmittance(1)[p]);
      EXPECT_GT(blue, red);
    }
  }
  EXPECT_GT(left, 200u);
  EXPECT_GT(right, 200u);
}

TEST(FrameLights, EachHasTheShadowsThatItHasAlone) {
  const std::vector<Light> lights = {kRed, kLamp, kBlue};
  const Ball all(litBy(lights));
  ASSERT_EQ(all.hair.maps.size(), lights.size());
  for (std::size_t l = 0; l < lights.size(); ++l) {
    const Ball alone(litBy({lights[l]}));
    EXPECT_TRUE(std::ranges::equal(all.transmittance(l), alone.transmittance(0))) << l;
    EXPECT_LT(std::ranges::min(alone.transmittance(0)), 0.2f) << "no shadow, nothing compared";
  }
}

TEST(FrameLights, FarAwayAtAPointAreParallel) {
  // Both maps have their cells at the same places when the pivot is the world's origin.
  const glm::vec3 way = glm::normalize(glm::vec3(0.5f, -0.8f, 0.35f));
  const Ball parallel(litBy({Light::parallel(way)}));
  const auto difference = [&](float distance) {
    const Ball ball(litBy({Light::point(-distance * way)}));
    float most = 0;
    for (std::size_t p = 0; p < parallel.hair.colours.size(); ++p) {
      most = std::max(most, std::abs(parallel.hair.transmittance[p] - ball.hair.transmittance[p]));
      if (distance < 1e4f) continue;
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(byte(parallel.hair.colours[p], c), byte(ball.hair.colours[p], c), 1);
    }
    return most;
  };
  const float far = difference(1e4f);
  EXPECT_LE(far, 1e-3f);
  // What is left is the rays' own angle: it goes with the distance.
  EXPECT_LE(difference(1e5f), 0.2f * far);
  EXPECT_GT(difference(0.4f), 0.1f) << "and near by they are not";
}

TEST(FrameLights, AtAPointGoWithTheHeadTheyAreTurnedTo) {
  // Head and lamp moved together: the same picture but for the rounding of larger numbers.
  const glm::vec3 there(0.5f, 1.5f, -0.25f);
  Light moved = kLamp;
  moved.position += there;
  const Ball here(litBy({kLamp})), away(litBy({moved}), there);
  EXPECT_EQ(away.hair.pivot(), there);
  for (std::size_t p = 0; p < here.hair.transmittance.size(); ++p)
    ASSERT_NEAR(here.hair.transmittance[p], away.hair.transmittance[p], 1e-3f);
}

TEST(FrameLights, ThatAreSwitchedOffLeaveNoMap) {
  FrameSettings settings = litBy({kRed, kLamp});
  Ball ball(settings);
  EXPECT_EQ(ball.hair.maps.size(), 2u);
  const std::vector<std::uint32_t> both = ball.hair.colours;
  settings.lights.pop_back();
  light(settings, ball.hair, ball.profile);
  ASSERT_EQ(ball.hair.maps.size(), 1u);
  EXPECT_EQ(ball.hair.transmittance.size(), ball.hair.wisps.points.size());
  EXPECT_EQ(ball.hair.colours, Ball(settings).hair.colours);
  settings.lights.push_back(kLamp);
  light(settings, ball.hair, ball.profile);
  EXPECT_EQ(ball.hair.colours, both);
  settings.lights.clear();
  light(settings, ball.hair, ball.profile);
  EXPECT_TRUE(ball.hair.maps.empty());
  std::vector<std::uint32_t> ambient(ball.hair.colours.size());
  shade(ball.hair.strands(), {}, settings.appearance, {}, ambient);
  EXPECT_EQ(ball.hair.colours, ambient);
  // No shadows, no maps.
  settings.lights = {kRed, kLamp};
  settings.shadow = false;
  light(settings, ball.hair, ball.profile);
  EXPECT_TRUE(ball.hair.maps.empty());
  EXPECT_TRUE(ball.hair.transmittance.empty());
}

TEST(FrameLights, MakeRadianceAndBytesEachWhereItIsAskedFor) {
  FrameSettings settings = litBy({kRed, kLamp});
  Ball ball(settings);
  EXPECT_TRUE(ball.hair.radiance.empty());
  EXPECT_EQ(ball.hair.radiance.capacity(), 0u) << "what is not asked for costs no memory";
  const std::vector<std::uint32_t> colours = ball.hair.colours;
  settings.radiance = true;
  light(settings, ball.hair, ball.profile);
  EXPECT_EQ(ball.hair.colours, colours);
  std::vector<std::uint32_t> encoded(colours.size());
  encodeSrgb(ball.hair.radiance, encoded);
  EXPECT_EQ(encoded, colours);
  const std::vector<glm::vec3> radiance = ball.hair.radiance;
  settings.encode = false;
  light(settings, ball.hair, ball.profile);
  EXPECT_TRUE(ball.hair.colours.empty());
  EXPECT_EQ(ball.hair.radiance, radiance);
  settings.shade = false;
  light(settings, ball.hair, ball.profile);
  EXPECT_TRUE(ball.hair.radiance.empty());
}

TEST(FrameLights, CountAsWorkOfTheSameStages) {
  const Ball one(litBy({kRed})), three(litBy({kRed, kLamp, kBlue}));
  for (Stage stage : {Stage::Deposit, Stage::Transmittance, Stage::Filter}) {
    const auto s = static_cast<std::size_t>(stage);
    EXPECT_GT(one.profile[s].items, 0);
    // Each light's map has bricks of its own.
    if (stage == Stage::Transmittance)
      EXPECT_GT(three.profile[s].items, 2 * one.profile[s].items);
    else
      EXPECT_EQ(three.profile[s].items, 3 * one.profile[s].items);
  }
}

TEST(FrameLights, TheBodyOnlyTakesLightAwayAndOnlyWhereItIsInTheWay) {
  FrameSettings settings;
  settings.lights = {Light{}, kLamp};
  test::Scene without(test::small(Style::Long), Motion::dance(), settings);
  settings.bodyShadow = true;
  test::Scene with(test::small(Style::Long), Motion::dance(), settings);
  for (int f = 0; f < 5; ++f) without.step(), with.step();
  EXPECT_EQ(with.hash(), without.hash());
  int shadowed = 0, asBefore = 0;
  for (std::size_t i = 0; i < with.hair.transmittance.size(); ++i) {
    const float t = with.hair.transmittance[i], before = without.hair.transmittance[i];
    ASSERT_LE(t, before + 1e-6f);
    shadowed += t < 0.1f && before > 0.3f ? 1 : 0;
    asBefore += t == before ? 1 : 0;
  }
  EXPECT_GT(shadowed, 10);
  EXPECT_GT(asBefore, static_cast<int>(with.hair.transmittance.size() / 3));
  for (const DensityMap& map : with.hair.maps) EXPECT_FALSE(map.aliased());
}

TEST(FrameLights, HaveTheSameBitsForAnyThreadCountAndDoNotMoveTheHair) {
  std::vector<std::uint64_t> hashes;
  std::vector<std::vector<std::uint32_t>> colours;
  FrameSettings settings;
  settings.lights = {kRed, kLamp, kBlue};
  for (int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    test::Scene scene(test::small(Style::Curly), Motion::dance(), settings);
    for (int f = 0; f < 20; ++f) scene.step();
    hashes.push_back(scene.hash());
    colours.push_back(scene.hair.colours);
    EXPECT_EQ(scene.hair.pivot(), scene.pose.worldFromHead.translation);
  }
  test::Scene unlit(test::small(Style::Curly), Motion::dance());
  for (int f = 0; f < 20; ++f) unlit.step();
  for (std::uint64_t hash : hashes) EXPECT_EQ(hash, unlit.hash());
  EXPECT_EQ(colours[0], colours[1]);
  EXPECT_EQ(colours[0], colours[2]);
}

}  // namespace
}  // namespace hair
