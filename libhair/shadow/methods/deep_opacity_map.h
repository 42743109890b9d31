#pragma once

#include <memory>

#include <libhair/shadow/methods/light_image.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeDeepOpacityMap(const DeepOpacityMapSettings& settings);

}  // namespace hair
