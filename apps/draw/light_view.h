#pragma once

// Inside hair_draw only: how a shadow map looks at the scene.

#include <glm/glm.hpp>

#include <libhair/core/strands.h>
#include <libhair/light/light.h>

namespace hair::draw {

struct LightView {
  glm::mat4 clipFromWorld;
  float texel;  ///< metres on a side; of a light at a point, a metre away from it
};

/// A square across the light around `receivers`, as deep as they and `casters` together. Its side
/// grows in steps and its middle moves by whole pixels, so that shadow edges do not swim while the
/// subject moves.
///
/// A light at a point looks towards `middle`, as wide as `receivers` need but at most 75 degrees to
/// each side: what is beyond is not in the map. (Its texels do swim when `middle` moves.)
LightView lightView(const Light& light, glm::vec3 middle, const Bounds& receivers,
                    const Bounds& casters, int size);

}  // namespace hair::draw
