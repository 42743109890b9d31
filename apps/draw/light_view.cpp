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

}  // namespace

LightView lightView(glm::vec3 towardsLight, const Bounds& receivers, const Bounds& casters,
                    int size) {
  constexpr float kStep = 0.25f, kMargin = 0.05f;  // metres
  const glm::vec3 z = towardsLight, x = anyNormal(z), y = glm::cross(z, x);
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
