#include <apps/draw/camera.h>

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace hair::draw {
namespace {

constexpr float kSteepest = 1.55f;  // just under a right angle: beyond it "up" would flip

glm::vec3 backwards(const Camera& c) {
  const float pitch = std::clamp(c.pitch, -kSteepest, kSteepest);
  return {std::cos(pitch) * std::sin(c.yaw), std::sin(pitch), std::cos(pitch) * std::cos(c.yaw)};
}

}  // namespace

glm::vec3 Camera::eye() const {
  return target + distance * backwards(*this);
}

glm::mat4 Camera::viewFromWorld() const {
  return glm::lookAt(eye(), target, glm::vec3(0, 1, 0));
}

glm::mat4 Camera::clipFromView(float aspect) const {
  return glm::perspective(fieldOfView, aspect, distance / 50, distance * 50);
}

void Camera::orbit(float yawBy, float pitchBy) {
  yaw = std::remainder(yaw + yawBy, 6.2831853f);
  pitch = std::clamp(pitch + pitchBy, -kSteepest, kSteepest);
}

void Camera::zoom(float factor) {
  distance = std::clamp(distance * factor, 0.02f, 100.0f);
}

void Camera::pan(glm::vec2 by) {
  const glm::vec3 back = backwards(*this);
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
  const glm::vec3 up = glm::cross(back, right);
  const float height = 2 * distance * std::tan(0.5f * fieldOfView);
  target += height * (by.x * right + by.y * up);
}

}  // namespace hair::draw
