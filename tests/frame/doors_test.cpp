// What the doors of a frame refuse, and what they let pass.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/simulation/frame.h>
#include <tests/guides/sphere_groom.h>

#include "scene.h"

namespace hair {
namespace {

/// Every guide of a ball is drawn.
Groom ball() {
  Groom groom = test::drawnSphereGroom(20, 9, 0.1f);
  groom.offsets.resize(groom.pointCount());
  return groom;
}

struct Frame {
  Groom groom = ball();
  FrameSettings settings;
  WispSettings wisps;

  [[gnu::noinline]] Frame() {}

  /// What is said of it, in the first frame at the latest.
  std::string refusal() {
    try {
      Hair hair(groom, settings, {}, nullptr, wisps);
      FrameProfile profile{};
      frame({}, settings, 1.0f / 60, hair, profile);
    } catch (const Error& e) {
      return e.what();
    }
    return "accepted";
  }
};

TEST(FrameDoors, WhatIsNoNumberIsRefusedByName) {
  EXPECT_EQ(Frame().refusal(), "accepted");
  const auto named = [](const char* name, float& (*field)(Frame&)) {
    for (const float bad : {NAN, INFINITY, -INFINITY, -3e38f}) {
      Frame frame;
      field(frame) = bad;
      const std::string text = frame.refusal();
      EXPECT_NE(text.find(name), std::string::npos) << text << " for " << bad;
    }
  };
  using F = Frame;
  named("offset of point 7", [](F& f) -> float& { return f.groom.offsets[7].y; });
  named("weights of strand 2", [](F& f) -> float& { return f.groom.weights[2].z; });
  named("guide 0 link 0", [](F& f) -> float& { return f.groom.guidePoints[0].x; });
  named("fibre width", [](F& f) -> float& { return f.groom.fibre.width; });
  named("clearance", [](F& f) -> float& { return f.wisps.clearance; });
  named("density map: cellSize", [](F& f) -> float& { return f.settings.map.cellSize; });
  named("repulsion settings: cellSize",
        [](F& f) -> float& { return f.settings.repulsion.cellSize; });
  named("limit", [](F& f) -> float& { return f.settings.repulsion.limit; });
  named("tolerance", [](F& f) -> float& { return f.settings.repulsion.tolerance; });
  static constexpr auto look = [](F& f) -> KajiyaKaySettings& {
    return std::get<KajiyaKaySettings>(f.settings.appearance);
  };
  named("rootColour", [](F& f) -> float& { return look(f).rootColour.g; });
  named("exponent", [](F& f) -> float& { return look(f).exponent; });
  named("eye", [](F& f) -> float& { return f.settings.eye.z; });
  named("light direction", [](F& f) -> float& { return f.settings.lights[0].direction.x; });
}

TEST(FrameDoors, CellsTooSmallForFloatsAreRefused) {
  for (const float size : {0.0f, 1e-42f, 1e-20f, 1e20f}) {
    Frame frame;
    frame.settings.map.cellSize = size;
    EXPECT_NE(frame.refusal().find("cellSize"), std::string::npos) << size;
  }
}

TEST(Frame, AnOriginThatMovesLeavesTheHairWhereItIs) {
  // Flies off a kilometre, and the same where the origin always is.
  const FrameSettings settings = test::Scene::simulationOnly();
  const Groom groom = ball();
  Hair there(groom, settings, {}), here(groom, settings, {});
  FrameProfile profile{};
  glm::vec3 origin(0);
  const auto way = [](int f) { return static_cast<float>(f * f) / 256; };
  for (int f = 1; f <= 500; ++f) {
    const glm::vec3 at(way(f), 0, 0);
    const glm::quat turn = glm::angleAxis(0.02f * static_cast<float>(f), glm::vec3(0, 1, 0));
    if (at.x - origin.x > 32) {
      const glm::vec3 by(32, 0, 0);
      moveOrigin(by, there);
      origin += by;
    }
    moveOrigin({way(f) - way(f - 1), 0, 0}, here);
    frame({{turn, at - origin}, {}}, settings, 1.0f / 60, there, profile);
    frame({{turn, glm::vec3(0)}, {}}, settings, 1.0f / 60, here, profile);
  }
  for (std::size_t p = 0; p < here.wisps.points.size(); ++p) {
    const glm::vec3 a = there.wisps.points[p] + origin, b = here.wisps.points[p];
    ASSERT_LT(glm::distance(a - glm::vec3(way(500), 0, 0), b), 2e-3f) << p;
  }
  EXPECT_THROW(moveOrigin({NAN, 0, 0}, here), Error);
}

}  // namespace
}  // namespace hair
