#include <apps/draw/light_view.h>

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include <libhair/core/transform.h>

namespace hair::draw {
namespace {

Bounds turned(const glm::mat3& lightFromWorld, const Bounds& box) {
  Bounds seen;
  for (int i = 0; i < 8; ++i) {
    seen.extend(lightFromWorld * glm::vec3(i & 1 ? box.upper.x : box.lower.x,
                                           i & 2 ? box.upper.y : box.lower.y,
                                           i & 4 ? box.upper.z : box.lower.z));
  }
  return seen;
}

constexpr float kMargin = 0.05f;  // metres

LightView viewFromPoint(glm::vec3 position, glm::vec3 middle, const Bounds& receivers,
                        const Bounds& casters, int size) {
  constexpr float kWidest = 3.75f;   // tangent of the angle to one side
  constexpr float kNearest = 0.01f;  // metres
  const glm::vec3 back = position - middle;
  const glm::vec3 z = glm::length(back) > 1e-6f ? glm::normalize(back) : glm::vec3(0, 1, 0);
  const glm::vec3 x = anyNormal(z), y = glm::cross(z, x);
  const glm::mat3 turn = glm::transpose(glm::mat3(x, y, z));
  glm::mat4 lightFromWorld(turn);
  lightFromWorld[3] = glm::vec4(-(turn * position), 1);

  float tangent = 1e-4f, nearest = 1e9f, farthest = 0;
  for (const Bounds* box : {&receivers, &casters}) {
    for (int i = 0; i < 8; ++i) {
      const glm::vec3 p =
          glm::vec3(lightFromWorld * glm::vec4(i & 1 ? box->upper.x : box->lower.x,
                                               i & 2 ? box->upper.y : box->lower.y,
                                               i & 4 ? box->upper.z : box->lower.z, 1));
      nearest = std::min(nearest, -p.z), farthest = std::max(farthest, -p.z);
      if (box != &receivers) continue;
      const float aside = std::max(std::abs(p.x), std::abs(p.y));
      tangent = std::max(tangent, -p.z > aside / kWidest ? aside / -p.z : kWidest);
    }
  }
  // In steps, as the side of a parallel light's square; finer for a narrower view.
  const float step = 0.25f * std::exp2(std::floor(std::log2(tangent)));
  tangent = std::min(step * std::ceil(tangent / step), kWidest);
  const float front = std::max(kNearest, nearest - kMargin);
  const float side = front * tangent;
  return {glm::frustum(-side, side, -side, side, front, std::max(farthest, front) + kMargin) *
              lightFromWorld,
          2 * tangent / float(size)};
}

}  // namespace

LightView lightView(const Light& light, glm::vec3 middle, const Bounds& receivers,
                    const Bounds& casters, int size) {
  if (light.kind == Light::Kind::Point)
    return viewFromPoint(light.position, middle, receivers, casters, size);
  constexpr float kStep = 0.25f;  // metres
  const glm::vec3 z = -glm::normalize(light.direction), x = anyNormal(z), y = glm::cross(z, x);
  const glm::mat3 lightFromWorld = glm::transpose(glm::mat3(x, y, z));
  const Bounds across = turned(lightFromWorld, receivers);
  Bounds along = turned(lightFromWorld, casters);
  along.extend(across.lower), along.extend(across.upper);

  const float wanted = std::max(across.size().x, across.size().y) + 0.02f;
  const float side = kStep * std::ceil(wanted / kStep), texel = side / float(size);
  const glm::vec2 corner =
      texel * glm::floor((glm::vec2(across.centre()) - 0.5f * side) / texel + 0.5f);
  const glm::mat4 clipFromLight = glm::ortho(corner.x, corner.x + side, corner.y, corner.y + side,
                                             -along.upper.z - kMargin, -along.lower.z + kMargin);
  return {clipFromLight * glm::mat4(lightFromWorld), texel};
}

}  // namespace hair::draw
