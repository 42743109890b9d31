#pragma once

// Inside hair_draw only: how a shadow map looks at the scene.

#include <glm/glm.hpp>

#include <libhair/core/strands.h>

namespace hair::draw {

struct LightView {
  glm::mat4 clipFromWorld;
  float texel;  ///< metres on a side
};

/// A square across the light around `receivers`, as deep as they and `casters` together. Its side
/// grows in steps and its middle moves by whole pixels, so that shadow edges do not swim while the
/// subject moves.
LightView lightView(glm::vec3 towardsLight, const Bounds& receivers, const Bounds& casters,
                    int size);

}  // namespace hair::draw
