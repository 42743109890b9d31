#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light.h>
#include <libhair/shade/kajiya_kay.h>

namespace HAIR_API hair {

/// Lights, shadows and camera: input of every reflectance model. Refers to the caller's arrays.
struct Illumination {
  std::span<const Light> lights;  ///< empty: ambient light only
  glm::vec3 pivot{0};      ///< reference point of the colours of point lights (Light), metres
  glm::vec3 eye{0, 0, 1};  ///< camera position, metres
  /// [lights · pointCount] transmittance T, [0, 1], light by light; or empty: T = 1.
  std::span<const float> transmittance;
  /// [lights · pointCount] visibility V, [0, 1], past opaque objects (head, body); or empty: V = 1.
  std::span<const float> visibility;
};

/// Throws Error for arrays that do not match lights and points, for an eye that is not finite, and
/// as lightSpaceOf does.
void validate(const Illumination& illumination, std::size_t pointCount);

/// Settings of a reflectance model. Each model is a file of this folder with `validate` and
/// `shadeStrands` (shaded_points.h) for its settings. Add a new one here; the rest of the pipeline
/// does not name models.
using Appearance = std::variant<KajiyaKaySettings>;

/// Throws Error for a setting out of its range, by name.
void validate(const Appearance& appearance);

/// Computes the radiance of all points towards the eye.
/// `radiance`: [pointCount] linear RGB, >= 0, unbounded; or empty: not stored.
/// `colours`: [pointCount] sRGB bytes, bit-identical to encodeSrgb; or empty: not computed.
/// Both at once, or bytes alone, cost less than a separate encoding pass.
/// Radiance is linear in the lights: results under single lights add up, except that each includes
/// the ambient term.
/// Same bits on every instruction set, for any number of threads, and for strands alone. Throws
/// Error where arrays do not fit, and as `validate` of both arguments does.
void shade(StrandView strands, const Illumination& illumination, const Appearance& appearance,
           std::span<glm::vec3> radiance, std::span<std::uint32_t> colours = {});

/// Only strands begin to end - 1, on the calling thread; arrays as above, [pointCount].
void shade(StrandView strands, std::size_t begin, std::size_t end, const Illumination& illumination,
           const Appearance& appearance, std::span<glm::vec3> radiance,
           std::span<std::uint32_t> colours = {});

/// Encodes linear radiance as sRGB (IEC 61966-2-1), by SrgbTable. `shade` does the same where it is
/// given `colours`.
/// `radiance`: [pointCount] linear RGB; below 0 and NaN become 0, above 1 becomes 255.
/// `colours`: [pointCount] sRGB, bytes in memory R, G, B, A with A = 255.
/// Same bits on every instruction set and for any number of threads. Throws Error for arrays of
/// different sizes.
void encodeSrgb(std::span<const glm::vec3> radiance, std::span<std::uint32_t> colours);

/// The same, followed by fadeColours.
void encodeSrgb(std::span<const glm::vec3> radiance, std::span<const std::uint32_t> first,
                std::span<const float> weights, std::span<std::uint32_t> colours);

/// Fades out the strands that a level of detail removes: multiplies the opacity (highest byte) of
/// their colours by their weight.
/// `first`: [strandCount + 1] as in StrandView. `weights`: [strandCount] in [0, 1], as in
/// DrawnHair; empty: all are 1. `colours`: [pointCount]. Throws Error where arrays do not fit.
void fadeColours(std::span<const std::uint32_t> first, std::span<const float> weights,
                 std::span<std::uint32_t> colours);

}  // namespace hair
