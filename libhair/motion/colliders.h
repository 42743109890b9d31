#pragma once

#include <glm/glm.hpp>

namespace hair {

/// A sphere swept from a to b; a sphere where a == b. Metres, world space.
struct Capsule {
  glm::vec3 a, b;
  float radius;
};

}  // namespace hair
