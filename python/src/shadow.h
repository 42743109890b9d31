#pragma once

#include <optional>

#include <libhair/core/strands.h>
#include <libhair/light/light.h>

#include "strands.h"

namespace hair::python {

/// Where a light at a point looks: what was given, else the middle of the hair.
LightSpace lightSpaceFor(const Light& light, const std::optional<glm::vec3>& pivot,
                         StrandView strands);

/// What a strand stands for: what was given, else its share of the hairs on a head.
Fibre fibreFor(const std::optional<Fibre>& fibre, StrandView strands);

}  // namespace hair::python
