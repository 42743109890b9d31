#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <libhair/model/head.h>
#include <libhair/model/styles.h>
#include <libhair/motion/motion.h>
#include <libhair/simulation/frame.h>
#include <libhair/simulation/simulation.h>

namespace hair::test {

/// Of the built-in head, made once a program.
inline const MeshSdf& headCollider() {
  static const MeshSdf collider(builtinHead().mesh);
  return collider;
}

/// The built-in head with a style on it, moved by a motion: what the programs run, without files.
struct Scene {
  const MeshSdf& collider = headCollider();
  Groom groom;
  Motion motion;
  FrameSettings settings;
  BodyPose pose;  // before the hair, which starts on it
  Simulation simulation;
  Hair& hair;
  FrameProfile profile{};
  double time = 0;

  Scene(StyleSettings style, Motion motion_, FrameSettings settings_ = simulationOnly())
      : groom(makeGroom(style, collider)),
        motion(std::move(motion_)),
        settings(settings_),
        simulation(borrowed(groom), settings, bodyAt(0), borrowed(collider)),
        hair(simulation.hair()) {}

  static FrameSettings simulationOnly() {
    FrameSettings settings;
    settings.shadow = settings.shade = false;
    return settings;
  }
  BodyState bodyAt(double t) {
    motion.pose(t, pose);
    return {pose.worldFromHead, pose.capsules};
  }
  void step(float seconds = 1.0f / 60) {
    time += seconds;
    simulation.setSettings(settings);
    profile = simulation.step(bodyAt(time), seconds);
  }
  GuideStats stats() const { return simulation.stats(); }
  std::uint64_t hash() const { return simulation.stateHash(); }
};

/// Fewer guides and strands, so that a test can afford many frames.
inline StyleSettings small(Style style) {
  StyleSettings settings = styleSettings(style);
  settings.wisps = 40;
  settings.strands = 240;
  return settings;
}

/// Every bit that a frame hands to the next.
inline std::string stateOf(const Hair& hair) {
  std::ostringstream out;
  saveState(hair, out);
  return out.str();
}

/// Where the guides end, metres.
inline std::vector<glm::vec3> tipsOf(const Hair& hair) {
  std::vector<glm::vec3> tips;
  for (std::size_t g = 0; g < hair.guides.guideCount(); ++g)
    tips.push_back(hair.guides.point(g, hair.guides.pointsPerGuide() - 1));
  return tips;
}

/// Root of the mean squared distance.
inline double rmsDistance(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::dvec3 d(a[i] - b[i]);
    sum += glm::dot(d, d);
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace hair::test
