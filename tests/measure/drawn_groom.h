#pragma once

#include <libhair/measure/motion/scene.h>
#include <libhair/wisps/bind.h>
#include <tests/guides/sphere_groom.h>

namespace hair::test {

/// Straight strands on a sphere, bound to a few of them as guides.
inline Groom boundSphere(std::uint32_t strands, std::uint32_t guides) {
  const Groom all = sphereGroom(strands, 11);
  std::vector<std::uint32_t> first = {0};
  for (std::uint32_t s = 1; s <= strands; ++s) first.push_back(s * all.pointsPerGuide);
  return bindGroom({all.guidePoints, first}, {guides, all.pointsPerGuide, 0.5f});
}

/// On a head that shakes about `place`: turns by half a radian, goes up and down by 3 cm. Nothing
/// is in the way.
inline MeasuredScene shakenScene(Groom groom, glm::vec3 place = glm::vec3(0)) {
  MeasuredScene scene;
  scene.groom = std::make_shared<Groom>(std::move(groom));
  scene.settle = 0;
  scene.pose = [place](double t, BodyPose& out) {
    const auto w = static_cast<float>(6.2831853 * t);
    out.worldFromHead = {glm::angleAxis(0.5f * std::sin(w), glm::vec3(0, 0, 1)),
                         place + glm::vec3(0, 0.03f * std::sin(2 * w), 0)};
  };
  return scene;
}

}  // namespace hair::test
