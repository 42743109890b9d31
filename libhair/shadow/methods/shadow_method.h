#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <variant>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/fibre.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/shadow/density_map.h>
#include <libhair/shadow/methods/deep_opacity_map.h>
#include <libhair/shadow/methods/deep_shadow_map.h>
#include <libhair/shadow/methods/density_clustering.h>
#include <libhair/shadow/methods/opacity_map.h>
#include <libhair/shadow/methods/shadow_map.h>

namespace HAIR_API hair {

/// Common interface of shadow methods, for comparison by measurement. Programs that use one method
/// call its passes directly; frame() calls those of the density map.
class ShadowMethod {
 public:
  virtual ~ShadowMethod() = default;

  /// Builds the shadow of the strands under the light; replaces the previous one and reuses its
  /// memory. Multi-threaded; the result has the same bits for any number of threads.
  virtual void build(StrandView strands, const Fibre& fibre, const LightSpace& light) = 0;

  /// Transmittance at any points, [0, 1]; 1 where no hair is in front. On all threads.
  /// `out`: [points.size()].
  virtual void sample(std::span<const glm::vec3> points, std::span<float> out) const = 0;

  /// Transmittance at all points of the strands passed to build, without self-shadowing of a strand
  /// if the method supports it. `out`: [pointCount].
  virtual void sampleStrands(StrandView strands, std::span<float> out) const {
    sample(strands.points, out);
  }

  /// Memory in use between build and the last sample.
  virtual std::size_t bytes() const = 0;
};

/// A method and its settings: one row of a table that compares them.
using ShadowSettings =
    std::variant<DensityMapSettings, ShadowMapSettings, OpacityMapSettings, DeepOpacityMapSettings,
                 DensityClusteringSettings, DeepShadowMapSettings>;

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeShadowMethod(const ShadowSettings& settings);

/// The method's name in lower case: "density map", "deep opacity map" ...
std::string methodName(const ShadowSettings& settings);
/// Its settings in a few words without commas: "3 mm 7 layers linear".
std::string settingsText(const ShadowSettings& settings);

}  // namespace hair
