#pragma once

#include <libhair/frame.h>
#include <libhair/guides/measure.h>
#include <libhair/model/head.h>
#include <libhair/model/styles.h>
#include <libhair/motion/motion.h>

namespace hair::test {

/// The built-in head with a style on it, moved by a motion: what the programs run, without files.
struct Scene {
  Head head = builtinHead();
  MeshSdf collider{head.mesh, 0.004f, 0.03f};
  Groom groom;
  Motion motion;
  FrameSettings settings;
  BodyPose pose;  // before the hair, which starts on it
  Hair hair;
  FrameProfile profile{};
  double time = 0;

  Scene(StyleSettings style, Motion motion_, FrameSettings settings_ = simulationOnly())
      : groom(makeGroom(style, collider)),
        motion(std::move(motion_)),
        settings(settings_),
        hair(groom, settings, bodyAt(0), &collider) {}

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
    frame(bodyAt(time), settings, seconds, hair, profile);
  }
  GuideStats stats() const {
    return measureGuides(hair.guides, settings.guides, pose.capsules, &collider);
  }
  std::uint64_t hash() const {
    StateHash hash;
    hair.guides.addTo(hash);
    hash.add(std::span<const glm::vec3>(hair.wisps.points));
    return hash.value();
  }
};

/// Fewer guides and strands, so that a test can afford many frames.
inline StyleSettings small(Style style) {
  StyleSettings settings = styleSettings(style);
  settings.wisps = 40;
  settings.strands = 240;
  return settings;
}

}  // namespace hair::test
