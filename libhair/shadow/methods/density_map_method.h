#pragma once

#include <libhair/shadow/methods/shadow_method.h>
#include <memory>

namespace hair {

/// The light-oriented density map as a ShadowMethod. Its build throws Error if the hair is larger
/// than the map. Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeDensityMapMethod(const DensityMapSettings& settings);

}  // namespace hair
