#pragma once

#include <optional>

#include <libhair/light/light.h>

#include "strands.h"

namespace hair::python {

/// Where a light at a point looks: what was given, else the middle of the hair.
LightSpace lightSpaceFor(const Light& light, const std::optional<glm::vec3>& pivot,
                         StrandView strands);

}  // namespace hair::python
