#pragma once

#include <glm/glm.hpp>

namespace hair::draw {

/// Looks at a point from a direction given by two angles; never rolls. Metres and radians, +Y up.
/// Yaw 0, pitch 0 stands on the +Z side and looks along -Z: straight at a face.
struct Camera {
  glm::vec3 target{0, 1.6f, 0};  ///< what stays in the middle of the picture
  float distance = 0.9f;         ///< from the target to the eye, > 0
  float yaw = 0;                 ///< about +Y, towards +X
  float pitch = 0;               ///< upwards, clamped to just under a right angle
  float fieldOfView = 0.55f;     ///< full angle from bottom to top, (0, pi)

  glm::vec3 eye() const;
  glm::mat4 viewFromWorld() const;
  /// OpenGL clip space. The near and far planes follow the distance (1/50 to 50 times).
  glm::mat4 clipFromView(float aspect) const;

  /// What the mouse does: turn by angles, step nearer (factor < 1) or away, slide the target in the
  /// picture plane by a share of the picture's height.
  void orbit(float yawBy, float pitchBy);
  void zoom(float factor);
  void pan(glm::vec2 by);
};

}  // namespace hair::draw
