#include <apps/draw/scene.h>

#include <cmath>

#include <libhair/core/transform.h>

namespace hair::draw {

std::uint32_t packColour(glm::vec4 srgb) {
  const glm::uvec4 b(glm::clamp(srgb, 0.0f, 1.0f) * 255.0f + 0.5f);
  return b.r | b.g << 8 | b.b << 16 | b.a << 24;
}

void DebugLayer::line(glm::vec3 a, glm::vec3 b, std::uint32_t colour) {
  lines.push_back({a, colour});
  lines.push_back({b, colour});
}

}  // namespace hair::draw
