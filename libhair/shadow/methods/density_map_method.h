#pragma once

#include <memory>

#include <libhair/core/api.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

class ShadowMethod;

/// The light-oriented density map as a ShadowMethod. Its build throws Error if the hair is larger
/// than the map. Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeDensityMapMethod(const DensityMapSettings& settings);

}  // namespace hair
