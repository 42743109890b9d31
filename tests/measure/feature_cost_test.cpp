// What features cost: what must hold whatever the machine. No times.
#include <algorithm>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/density/grid_cells.h>
#include <libhair/measure/motion/feature_cost.h>

#include "drawn_groom.h"

namespace hair {
namespace {

MeasuredScene everything() {
  MeasuredScene scene = test::shakenScene(test::boundSphere(200, 24));
  scene.settings.wind.velocity = {1, 0, 0};
  scene.settings.map.cells = 32;
  scene.settings.map.cellSize = 0.05f;
  return scene;
}

MeasuredScene without(std::string_view name, MeasuredScene scene) {
  for (const Feature& feature : featuresOf(scene))
    if (feature.name == name) {
      feature.turnOff(scene);
      return scene;
    }
  ADD_FAILURE() << "no feature " << name;
  return scene;
}

const FeatureCost& costOf(std::string_view name, const FeaturePlan& plan) {
  const auto found =
      std::ranges::find_if(plan.features, [&](const FeatureCost& f) { return f.name == name; });
  require(found != plan.features.end(), "no cost of ", name);
  return *found;
}

constexpr FeatureCostSettings kQuick{4, 2};

TEST(Features, TurningOneOffLeavesItsArraysEmpty) {
  const auto played = [](const MeasuredScene& scene) {
    auto player = std::make_unique<ScenePlayer>(scene);
    player->step();
    return player;
  };
  const auto all = played(everything());
  EXPECT_FALSE(all->hair.repulsion.push.empty());
  EXPECT_FALSE(all->hair.transmittance.empty());
  EXPECT_FALSE(all->hair.colours.empty());
  EXPECT_EQ(all->hair.maps.size(), 1u);
  EXPECT_TRUE(all->hair.repulsion.density.cells->bricks.valid());

  const auto alone = played(without("self-collision", everything()));
  EXPECT_TRUE(alone->hair.repulsion.push.empty());
  EXPECT_TRUE(alone->hair.repulsion.allowed.empty());
  EXPECT_FALSE(alone->hair.repulsion.density.cells->bricks.valid());

  const auto bright = played(without("light's map", everything()));
  EXPECT_TRUE(bright->hair.transmittance.empty());
  EXPECT_TRUE(bright->hair.maps.empty());

  EXPECT_TRUE(played(without("shading", everything()))->hair.colours.empty());
  EXPECT_TRUE(without("offsets and curls", everything()).groom->offsets.empty());
  EXPECT_TRUE(ScenePlayer(without("contact", everything())).body().capsules.empty());

  const auto guides = played(without("wisps", everything()));
  EXPECT_EQ(guides->hair.strands().strandCount(), 24u);
  // The hairs are still as many.
  const Fibre &many = all->hair.groom->fibre, &few = guides->hair.groom->fibre;
  EXPECT_FLOAT_EQ(few.hairsPerStrand * 24, many.hairsPerStrand * 200);
}

TEST(Features, OneThatIsOffIsNotListed) {
  const MeasuredScene scene = everything();
  const std::vector<Feature> all = featuresOf(scene);
  EXPECT_GE(all.size(), 10u);
  for (const Feature& feature : all) {
    MeasuredScene less = scene;
    feature.turnOff(less);
    for (const Feature& left : featuresOf(less)) EXPECT_NE(left.name, feature.name);
  }
  MeasuredScene still = everything();
  still.settings.wind = {};
  EXPECT_EQ(featuresOf(still).size(), all.size() - 1);
}

TEST(FeatureCost, MemoryIsThatOfTheArrays) {
  const MeasuredScene scene = everything();
  const FeaturePlan plan = measureFeatures(scene, featuresOf(scene), kQuick);
  const double points = static_cast<double>(scene.groom->pointCount());
  EXPECT_EQ(costOf("shading", plan).savedBytes, 4 * points);
  // Bricks of the map, and what points got of it; no more than all cells, twice, and a table.
  const double cells = 32 * 32 * 32;
  EXPECT_GT(costOf("light's map", plan).savedBytes, 4 * points + 10 * 2048);
  EXPECT_LT(costOf("light's map", plan).savedBytes, 4 * points + 10 * cells);
  // Without maps, which hold fewer bricks of other strands.
  MeasuredScene dark = everything();
  dark.settings.shadow = dark.settings.selfCollision = false;
  const FeaturePlan unlit = measureFeatures(dark, featuresOf(dark), kQuick);
  EXPECT_EQ(costOf("offsets and curls", unlit).savedBytes, 12 * points);
  EXPECT_EQ(costOf("wind", unlit).savedBytes, 0);
  EXPECT_GT(plan.bytes, costOf("light's map", plan).savedBytes);
}

TEST(FeatureCost, WhatAFeatureChangesIsWhatItIsFor) {
  const MeasuredScene scene = everything();
  const FeaturePlan plan = measureFeatures(scene, featuresOf(scene), kQuick);
  EXPECT_EQ(plan.watch.frames, 8);
  // Shadows move nothing, but darken.
  EXPECT_EQ(costOf("light's map", plan).movedMetres, 0);
  EXPECT_GT(costOf("light's map", plan).recoloured, 1);
  EXPECT_GT(costOf("light's map", plan).relit, 0.01);
  EXPECT_LT(plan.watch.darkest, 0.99f);
  // Wind moves.
  EXPECT_GT(costOf("wind", plan).movedMetres, 1e-3);
  // What is drawn without wisps is other strands: there is nothing to compare.
  EXPECT_FALSE(costOf("wisps", plan).movedMetres);
  EXPECT_FALSE(costOf("shading", plan).recoloured);
  // Features with stages of their own have a time of their own.
  EXPECT_TRUE(costOf("light's map", plan).ownMs);
  EXPECT_FALSE(costOf("wind", plan).ownMs);
}

TEST(FeatureCost, AFeatureThatDoesNothingIsSaidTo) {
  const MeasuredScene scene = everything();
  const Feature nothing{
      "nothing", {}, [](const MeasuredScene&) { return true; }, [](MeasuredScene&) {}};
  const FeaturePlan plan = measureFeatures(scene, {&nothing, 1}, kQuick);
  const FeatureCost& cost = costOf("nothing", plan);
  EXPECT_EQ(cost.movedMetres, 0);
  EXPECT_EQ(cost.recoloured, 0);
  EXPECT_EQ(cost.relit, 0);
  EXPECT_EQ(cost.savedBytes, 0);
  EXPECT_NE(cost.advice.find("leave it out"), std::string::npos) << cost.advice;
}

TEST(FeatureCost, AdviceFollowsWhatWasSeen) {
  const auto adviceOn = [](std::string_view name, auto change) {
    MeasuredScene scene = everything();
    change(scene);
    return costOf(name, measureFeatures(scene, featuresOf(scene), kQuick)).advice;
  };
  const auto groomWith = [](MeasuredScene& scene, auto change) {
    auto groom = std::make_shared<Groom>(*scene.groom);
    change(*groom);
    scene.groom = groom;
  };
  EXPECT_EQ(
      adviceOn("self-collision", [](MeasuredScene& s) { s.settings.repulsion.threshold = 1e12f; }),
      "never pushes: leave it out");
  EXPECT_EQ(adviceOn("self-collision",
                     [](MeasuredScene& s) {
                       s.settings.repulsion.threshold = 0;
                       s.settings.repulsion.tolerance = 1;
                       s.settings.repulsion.strandStride = 1;
                     }),
            "");
  EXPECT_EQ(adviceOn("light's map",
                     [&](MeasuredScene& s) {
                       groomWith(s, [](Groom& groom) { groom.fibre.opacity = 1e-12f; });
                     }),
            "every transmittance is 1: leave it out");
  EXPECT_TRUE(adviceOn("light's map", [](MeasuredScene& s) {
                s.settings.map.cellSize = 0.002f;
              }).starts_with("the hair was larger than the map in 8 of 8 frames"));
  EXPECT_TRUE(adviceOn("light's map", [](MeasuredScene& s) {
                s.settings.map.cells = 64;
              }).starts_with("the hair spanned "));
  EXPECT_EQ(adviceOn("light's map", [](MeasuredScene& s) { s.settings.map.cellSize = 0.035f; }),
            "");
}

TEST(FeatureCost, SettingsOutOfRangeAreErrors) {
  const MeasuredScene scene = everything();
  EXPECT_THROW(measureFeatures(scene, {}, {1, 2}), Error);
  EXPECT_THROW(measureFeatures(scene, {}, {2, 1}), Error);
  const Feature stuck{"stuck", {}, nullptr, nullptr};
  EXPECT_THROW(measureFeatures(scene, {&stuck, 1}, kQuick), Error);
}

}  // namespace
}  // namespace hair
