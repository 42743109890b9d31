// Hair on a skeleton of one's own: an engine has its joints' matrices, and the library wants no
// more of them than where the head is and where flesh is that hair must not enter.
//
//   example_follow_my_skeleton
//
// Look at: two joints drive a head and five capsules; the head is turned to its left, then to its
// right, and the tips of the long hair come behind. No motion file, no skeleton of the library.
#include <cmath>
#include <cstdio>
#include <vector>

#include <libhair/hair.h>

namespace {

// Somebody's rig, in metres: chest and head, each with a turn about the vertical.
struct Rig {
  glm::quat chest, head;  // world from joint
  glm::vec3 chestAt{0, 1.25f, 0}, headAt{0, 1.45f, 0};
};

Rig pose(float seconds) {
  const glm::vec3 turn(0, 1.1f * std::sin(6.0f * seconds), 0);
  return {glm::quat(0.3f * turn), glm::quat(turn)};
}

// What hair needs to know of it. The head has its own distance field; here are two shoulders, two
// upper arms and the trunk, the same count and order at any time. Head space is +Y up, +Z where the
// face looks, origin at the joint: a rig with other axes multiplies a constant turn from the right.
hair::BodyState body(const Rig& rig, std::vector<hair::Capsule>& capsules) {
  const auto at = [&](float x, float y, float z) {
    return rig.chestAt + rig.chest * glm::vec3(x, y, z);
  };
  capsules = {{at(0, 0.13f, -0.02f), at(0.16f, 0.1f, 0), 0.05f},
              {at(0, 0.13f, -0.02f), at(-0.16f, 0.1f, 0), 0.05f},
              {at(0.18f, 0.08f, 0), at(0.24f, -0.2f, 0), 0.045f},
              {at(-0.18f, 0.08f, 0), at(-0.24f, -0.2f, 0), 0.045f},
              {at(0, 0.02f, 0), at(0, -0.25f, 0), 0.1f}};
  return {{rig.head, rig.headAt}, capsules};
}

// Which way the middle of all tips is from the head's axis, degrees.
float tipsTurned(const hair::GuideStrands& guides) {
  glm::vec3 sum(0);
  for (std::size_t g = 0; g < guides.guideCount(); ++g)
    sum += guides.point(g, guides.pointsPerGuide() - 1);
  return glm::degrees(std::atan2(-sum.x, -sum.z));  // 0: straight behind
}

}  // namespace

int main() {
  const auto head = std::make_shared<hair::MeshSdf>(hair::builtinHead().mesh);
  hair::FrameSettings settings;
  settings.shadow = settings.shade = false;

  std::vector<hair::Capsule> capsules;
  hair::Simulation simulation(hair::makeGroom(hair::styleSettings(hair::Style::Long), *head),
                              settings, body(pose(0), capsules), head);
  simulation.restart(simulation.body(), 0.5f);  // it finds its way off the arms
  float deepest = 0, lag = 0;
  std::puts(" time   head turned   tips turned");
  for (int frame = 1; frame <= 120; ++frame) {
    const Rig rig = pose(static_cast<float>(frame) / 60);
    simulation.step(body(rig, capsules), 1.0f / 60);
    deepest = std::max(deepest, simulation.stats().penetrationMax);
    const glm::vec3 face = rig.head * glm::vec3(0, 0, 1);
    const float turned = glm::degrees(std::atan2(face.x, face.z)),
                tips = tipsTurned(simulation.hair().guides);
    lag = std::max(lag, std::abs(turned - tips));
    if (frame % 10 == 0) std::printf("%.2f s  %8.0f°  %12.0f°\n", simulation.time(), turned, tips);
  }
  std::printf("deepest guide point in head or flesh: %.2f mm\n", 1e3f * deepest);
  const bool good = lag > 20 && deepest < 2e-3f;
  std::puts(good ? "the hair follows" : "the hair does NOT follow");
  return good ? 0 : 1;
}
