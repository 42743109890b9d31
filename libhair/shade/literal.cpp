#include <libhair/shade/literal.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hair::literal {

namespace {

double angleBetween(glm::dvec3 a, glm::dvec3 b) {
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0 ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0))
                     : std::numbers::pi / 2;
}

// Unoccluded light at a point.
struct Arriving {
  glm::dvec3 towardsLight;
  glm::dvec3 colour;  // E
};

Arriving arrivingAt(const Light& light, glm::dvec3 here, glm::dvec3 pivot) {
  if (light.kind == Light::Kind::Parallel) return {-glm::dvec3(light.direction), light.colour};
  const glm::dvec3 lamp(light.position);
  const double ratio = glm::distance(lamp, pivot) / std::max(glm::distance(lamp, here), 0.01);
  return {lamp - here, ratio * ratio * glm::dvec3(light.colour)};
}

}  // namespace

void shade(StrandView strands, const Illumination& illumination, const KajiyaKaySettings& settings,
           std::span<glm::vec3> radiance) {
  const std::size_t pointCount = strands.pointCount();
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const auto points = strands.strand(s);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::size_t p = strands.first[s] + k, last = points.size() - 1;
      const glm::dvec3 here(points[k]);
      const glm::dvec3 tangent(points[std::min(k + 1, last)] - points[k > 0 ? k - 1 : 0]);
      const double b = angleBetween(tangent, glm::dvec3(illumination.eye) - here);
      glm::dvec3 own(settings.ambient), white(0);
      for (std::size_t l = 0; l < illumination.lights.size() && glm::length(tangent) > 0; ++l) {
        const auto share = [&](std::span<const float> of) {
          return of.empty() ? 1.0 : static_cast<double>(of[l * pointCount + p]);
        };
        const double T = share(illumination.transmittance), V = share(illumination.visibility);
        const auto [towardsLight, E] =
            arrivingAt(illumination.lights[l], here, glm::dvec3(illumination.pivot));
        const double a = angleBetween(tangent, towardsLight);
        // A fibre reflects light into the cone about its tangent that contains the mirrored ray,
        // where a + b = pi; a highlight shifted by s peaks at a + b = pi + s.
        const auto specular = [&](double strength, double exponent, double shift) {
          const double cosine = std::cos(a + b - std::numbers::pi - shift);
          return strength * std::pow(std::max(cosine, 0.0), exponent);
        };
        own += T * V * E *
               (settings.diffuse * std::sin(a) +
                specular(settings.secondSpecular, settings.secondExponent, settings.secondShift));
        white += T * V * E * specular(settings.specular, settings.exponent, settings.firstShift);
      }
      const double along = last > 0 ? static_cast<double>(k) / static_cast<double>(last) : 0;
      const glm::dvec3 colour =
          static_cast<double>(settings.lightnessOf(static_cast<std::uint32_t>(s))) *
          glm::mix(glm::dvec3(settings.rootColour), glm::dvec3(settings.tipColour), along);
      radiance[p] = glm::vec3(colour * own + white);
    }
  }
}

}  // namespace hair::literal
