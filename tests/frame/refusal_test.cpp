// A call of Simulation that throws for its arguments changes nothing, whichever of its stages would
// have found the fault.

#include <functional>
#include <limits>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <libhair/core/error.h>

#include "scene.h"

namespace hair {
namespace {

using test::headCollider;
using test::Scene;
using test::small;

constexpr float kHuge = std::numeric_limits<float>::max();

/// A scene in motion, and all of it that a caller sees.
struct Refusals {
  Scene scene{small(Style::Smooth), Motion::dance(), {}};
  Simulation& simulation = scene.simulation;

  Refusals() { scene.step(); }

  RigidTransform at(float x) const {
    RigidTransform head = scene.pose.worldFromHead;
    head.translation.x += x;
    return head;
  }
  std::string seen() const {
    const Hair& hair = scene.hair;
    const BodyState body = simulation.body();
    const FrameSettings& settings = simulation.settings();
    std::ostringstream out;
    out << test::stateOf(hair) << ' ' << pictureHash(hair) << ' ' << hair.radiance.size() << ' '
        << simulation.groom() << ' ' << hair.groom << ' ' << simulation.knownDetail() << ' '
        << hair.level.strands << ' ' << hair.wisps.drawn.level.strands << ' ' << hair.maps.size()
        << ' ' << hair.visibility.size() << ' ' << settings.lights.size() << ' '
        << settings.lights[0].position.x << ' ' << settings.bodyShadow << ' '
        << body.worldFromHead.translation.x << ' ' << body.capsules.size() << ' '
        << body.scenery.planes.size() << ' ' << body.scenery.meshes.size() << ' '
        << simulation.profile()[0].items;
    return out.str();
  }
  /// `words`: some of what is said.
  void refused(const std::string& words, const std::function<void()>& call) {
    const std::string before = seen();
    std::string said;
    try {
      call();
    } catch (const Error& error) {
      said = error.what();
    }
    EXPECT_NE(said.find(words), std::string::npos) << "it said '" << said << "'";
    EXPECT_TRUE(seen() == before) << "refused, but changed: " << words;
  }
  /// Of what is wrong now whatever the call is told.
  void refusedByAllThatLight(const std::string& words) {
    const std::string state = test::stateOf(scene.hair);
    const BodyState body = simulation.body();
    refused(words, [&] { simulation.relight(); });
    refused(words, [&] { simulation.step(body, 1.0f / 60); });
    refused(words, [&] { simulation.restart(body); });
    refused(words, [&] { simulation.teleport(at(1)); });
    refused(words, [&] {
      std::istringstream in(state);
      simulation.restore(in);
    });
  }
  void goesOn() { EXPECT_NO_THROW(simulation.step(simulation.body(), 1.0f / 60)); }
};

TEST(Refusal, OfALampWhereTheHeadWouldBe) {
  Refusals r;
  Scene there(small(Style::Smooth), Motion::dance(), {});
  there.step();
  there.simulation.teleport(r.at(3));
  std::istringstream saved(test::stateOf(there.hair));
  r.scene.settings.lights = {Light{}, Light::point(r.at(3).translation)};
  r.simulation.setSettings(r.scene.settings);
  const BodyState body{r.at(3), r.scene.pose.capsules};
  const std::string words = "m from the hair's middle; move it";
  r.refused(words, [&] { r.simulation.restore(saved); });
  r.refused(words, [&] { r.simulation.teleport(body.worldFromHead); });
  r.refused(words, [&] { r.simulation.restart(body); });
  r.refused(words, [&] { r.simulation.step(body, 1.0f / 60); });
  r.goesOn();
}

TEST(Refusal, OfALampWhereTheHeadIs) {
  Refusals r;
  FrameSettings lamp = r.scene.settings;
  lamp.lights = {Light::point(r.at(0).translation)};
  const std::string words = "m from the hair's middle; move it";
  r.refused(words, [&] { r.simulation.setSettings(lamp); });
  // An origin that moves leaves the lamp alone, and here the head comes to it.
  lamp.lights[0].position.x += 1;
  r.simulation.setSettings(lamp);
  r.simulation.moveOrigin({-1, 0, 0});
  r.refused(words, [&] { r.simulation.relight(); });
  r.refused(words, [&] { r.simulation.step(r.simulation.body(), 1.0f / 60); });
  r.refused(words, [&] { r.simulation.restart(r.simulation.body()); });
  r.refused(words, [&] { r.simulation.setGroom(std::make_shared<Groom>(r.scene.groom)); });
}

TEST(Refusal, OfVisibilityThatDoesNotFit) {
  Refusals r;
  r.scene.hair.visibility.assign(3, 1.0f);
  r.refusedByAllThatLight("visibility: 3 values");
}

TEST(Refusal, OfALevelWithoutItsDetail) {
  Refusals r;
  r.scene.hair.level.strands = 0.5f;
  r.refusedByAllThatLight("Hair::detail is null");
  LevelOfDetail wrong;
  wrong.strands = NAN;
  r.refused("", [&] { r.simulation.setLevel(wrong); });
}

TEST(Refusal, OfAHeadThatIsNowhereOrTooFarAway) {
  Refusals r;
  for (const float x : {NAN, INFINITY, 1e7f, 1e9f}) {
    r.refused("", [&] { r.simulation.teleport(r.at(x)); });
    r.refused("", [&] { r.simulation.restart({r.at(x), {}}); });
    r.refused("", [&] { r.simulation.step({r.at(x), {}}, 1.0f / 60); });
    r.refused("", [&] { r.simulation.moveOrigin({x, 0, 0}); });
  }
  for (const float settle : {-1.0f, NAN, 1e9f})
    r.refused("settle", [&] { r.simulation.restart(r.simulation.body(), settle); });
  r.goesOn();
}

TEST(Refusal, OfCollidersThatCannotBe) {
  Refusals r;
  const glm::vec3 hair = r.scene.hair.guides.point(0, r.scene.hair.guides.pointsPerGuide() - 1);
  const Capsule inTheWay{hair, hair + glm::vec3(0, 0.1f, 0), 0.05f};
  const std::vector<Capsule> many(kMaxCapsules + 1, inTheWay);
  const auto refused = [&](const std::string& words, std::span<const Capsule> capsules,
                           Scenery scenery) {
    const BodyState body{r.at(0), capsules, scenery};
    r.refused(words, [&] { r.simulation.changeColliders(body); });
    r.refused(words, [&] { r.simulation.restart(body, 0.1f); });
    r.refused(words, [&] { r.simulation.step(body, 1.0f / 60); });
  };
  refused("capsules; ", many, {});
  const Capsule nowhere{hair, glm::vec3(NAN), 0.05f};
  refused("capsule 0", {&nowhere, 1}, {});
  for (const float far : {NAN, INFINITY, kHuge}) {
    const Plane plane{glm::vec3(far), glm::normalize(glm::vec3(1))};
    refused("plane 0", {&inTheWay, 1}, {{&plane, 1}, {}});
    MeshCollider mesh{&headCollider()};
    mesh.worldFromMesh.translation = glm::vec3(far, 0, 0);
    refused("mesh collider 0", {&inTheWay, 1}, {{}, {&mesh, 1}});
  }
  for (const float scale : {NAN, 0.0f, -1.0f, 1e-44f, 1e-20f, 1e4f}) {
    const MeshCollider mesh{&headCollider(), r.at(0), scale};
    refused("scale", {&inTheWay, 1}, {{}, {&mesh, 1}});
  }
  // What can be, however small or far.
  Plane plane{glm::vec3(0.5e15f), glm::normalize(glm::vec3(-1))};
  MeshCollider mesh{&headCollider(), r.at(0), 1e-6f};
  r.simulation.changeColliders({r.at(0), {&inTheWay, 1}, {{&plane, 1}, {&mesh, 1}}});
  r.simulation.restart(r.simulation.body(), 0.1f);
  r.goesOn();
}

TEST(Refusal, OfAGroomOrSettingsThatDoNotFitEachOther) {
  Refusals r;
  FrameSettings points = r.scene.settings;
  points.map.deposit = Deposit::Points;
  points.bodyShadow = true;
  auto clear = std::make_shared<Groom>(r.scene.groom);
  clear->fibre.opacity = 0;
  const std::string words = "take Deposit::Columns, or fibres of some width and opacity";
  {
    r.simulation.setSettings(points);
    r.refused(words, [&] { r.simulation.setGroom(clear); });
    r.goesOn();
  }
  r.simulation.setSettings(r.scene.settings);
  r.simulation.setGroom(clear);
  r.refused(words, [&] { r.simulation.setSettings(points); });
  points.map.pointExtinction = 1;
  r.simulation.setSettings(points);
  r.goesOn();
  r.refused("no groom", [&] { r.simulation.setGroom(nullptr); });
  auto dots = std::make_shared<Groom>(r.scene.groom);
  dots->guidePoints[1] = dots->guidePoints[0];
  r.refused("guide 0 link 0", [&] { r.simulation.setGroom(dots); });
}

}  // namespace
}  // namespace hair
