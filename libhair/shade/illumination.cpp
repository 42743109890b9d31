#include <libhair/shade/appearance.h>

#include <libhair/core/error.h>
#include <libhair/light/light.h>

namespace hair {

void validate(const Illumination& illumination, std::size_t pointCount) {
  const glm::vec3 eye = illumination.eye;
  require(glm::dot(eye, eye) < 1e30f, "eye: (", eye.x, ", ", eye.y, ", ", eye.z,
          ") is not finite, or beyond 1e15 m");
  const std::size_t lights = illumination.lights.size();
  const auto fits = [&](std::span<const float> values, const char* what) {
    require(values.empty() || values.size() == lights * pointCount, "shade: ", pointCount,
            " points and ", lights, " lights but ", values.size(), ' ', what);
  };
  fits(illumination.transmittance, "transmittances");
  fits(illumination.visibility, "visibilities");
  for (const Light& light : illumination.lights) lightSpaceOf(light, illumination.pivot);
}

}  // namespace hair
