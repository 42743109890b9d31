#pragma once

#include <memory>

#include <libhair/shadow/density_map.h>

namespace hair {

class ShadowMethod;

/// The light-oriented density map behind the interface that all methods share. Its build throws
/// Error where the hair is larger than the map. Throws Error for settings out of range, and for
/// Quantity::Length, which holds no shadow.
std::unique_ptr<ShadowMethod> makeDensityMapMethod(const DensityMapSettings& settings);

}  // namespace hair
