#pragma once

#include <array>
#include <cmath>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/error.h>
#include <libhair/core/fields.h>

namespace HAIR_API hair {

/// A Wind at one time: a steady flow, and waves of velocity.
struct WindField {
  /// A sine over space: swing · sin(2 pi (perMetre · p + phase)).
  struct Wave {
    glm::vec3 perMetre{0};  ///< turns
    float phase = 0;        ///< turns, at the origin
    glm::vec3 swing{0};     ///< m/s
  };
  glm::vec3 steady{0};          ///< m/s
  std::array<Wave, 4> waves{};  ///< gusts, and one wave across the flow

  /// Velocity of the air at p, m/s.
  glm::vec3 at(glm::vec3 p) const {
    glm::vec3 v = steady;
    for (const Wave& wave : waves)
      v += std::sin(6.28318531f * (glm::dot(wave.perMetre, p) + wave.phase)) * wave.swing;
    return v;
  }
  /// The same field for positions relative to `origin`.
  WindField seenFrom(glm::vec3 origin) const {
    WindField field = *this;
    for (Wave& wave : field.waves) {
      const double turns = glm::dot(glm::dvec3(wave.perMetre), glm::dvec3(origin));
      wave.phase += static_cast<float>(turns - std::floor(turns));
    }
    return field;
  }
};

/// Moving air: a steady flow, and gusts that travel with it.
struct Wind {
  glm::vec3 velocity{0};    ///< m/s; zero: still air
  float gust = 0.5f;        ///< amplitude of the gusts, as a fraction of the speed, [0, 1]
  float gustLength = 0.5f;  ///< length of the longest gusts over 2 pi, metres, [1e-3, 1e6)
  /// Attenuation of the wind by hair, metres, [0, 1]: behind a column density of d metres of hair
  /// per square metre across the wind, the fraction exp(-occlusion · d) of it is left. Real hair:
  /// half its width times its drag coefficient, about 1e-4; 0: none, at no cost. Uses the density
  /// of self-collision; without that there is none.
  float occlusion = 0;

  /// No wind.
  bool still() const { return velocity == glm::vec3(0); }

  /// The wind at time t, seconds: waves of incommensurate lengths that travel with the flow, one of
  /// them swinging across it. Whole turns are removed from the phases in double precision, so that
  /// large times cost no digits.
  WindField at(double t) const {
    WindField field{velocity, {}};
    const float speed = glm::length(velocity);
    if (speed == 0) return field;
    const glm::vec3 flow = velocity / speed;
    const glm::vec3 up = std::abs(flow.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 slant(0.7f, 1, 1.3f), side = slant - glm::dot(slant, flow) * flow;
    const float turnsPerMetre = 1 / (6.28318531f * gustLength);
    const double turns = t * static_cast<double>(speed * turnsPerMetre);
    const auto wave = [&](float along, float across, glm::vec3 swing) {
      const double phase = static_cast<double>(along) * turns;
      return WindField::Wave{turnsPerMetre * (along * flow + across * side),
                             static_cast<float>(std::floor(phase) - phase), gust * swing};
    };
    field.waves = {wave(1, 0, 0.5f * velocity), wave(2.71f, 1.9f, 0.3f * velocity),
                   wave(6.13f, -4.3f, 0.2f * velocity),
                   wave(1.7f, 1, 0.3f * speed * glm::cross(flow, up))};
    return field;
  }
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const Wind*) {
  using S = Wind;
  return std::tuple(Field("velocity", &S::velocity, "[0, 200) m/s"),
                    Field("gust", &S::gust, "[0, 1]"),
                    Field("gustLength", &S::gustLength, "[1e-3, 1e6) m"),
                    Field("occlusion", &S::occlusion, "[0, 1] m"));
}

/// Throws Error that names the field and its range.
inline void validate(const Wind& wind) {
  validateFields(wind, "wind");
}

}  // namespace hair
