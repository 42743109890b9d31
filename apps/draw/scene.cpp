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

void DebugLayer::strands(StrandView view, std::uint32_t colour) {
  for (std::size_t s = 0; s < view.strandCount(); ++s) {
    const auto points_ = view.strand(s);
    for (std::size_t i = 1; i < points_.size(); ++i) line(points_[i - 1], points_[i], colour);
  }
}

void DebugLayer::capsule(const Capsule& c, std::uint32_t colour) {
  constexpr int kSides = 24;
  const glm::vec3 along = c.b - c.a;
  const float length = glm::length(along);
  const glm::vec3 axis = length > 0 ? along / length : glm::vec3(0, 1, 0);
  const glm::vec3 u = anyNormal(axis), v = glm::cross(axis, u);

  // A ring at either end, four lines between them, two half circles over either cap.
  glm::vec3 before = u;
  float sineBefore = 0, cosineBefore = 1;
  for (int i = 1; i <= kSides; ++i) {
    const float angle = 6.2831853f * float(i) / kSides;
    const float cosine = std::cos(angle), sine = std::sin(angle);
    const glm::vec3 now = cosine * u + sine * v;
    line(c.a + c.radius * before, c.a + c.radius * now, colour);
    if (length > 0) line(c.b + c.radius * before, c.b + c.radius * now, colour);
    if (i % (kSides / 4) == 0) line(c.a + c.radius * now, c.b + c.radius * now, colour);
    const glm::vec3& end = sine + sineBefore > 0 ? c.b : c.a;
    for (const glm::vec3& side : {u, v}) {
      line(end + c.radius * (cosineBefore * side + sineBefore * axis),
           end + c.radius * (cosine * side + sine * axis), colour);
    }
    before = now, sineBefore = sine, cosineBefore = cosine;
  }
}

void DebugLayer::box(glm::vec3 centre, glm::vec3 size, std::uint32_t colour) {
  const auto corner = [&](int i) {
    return centre + 0.5f * size * glm::vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  };
  for (int i = 0; i < 8; ++i) {
    for (int bit : {1, 2, 4}) {
      if (!(i & bit)) line(corner(i), corner(i | bit), colour);
    }
  }
}

}  // namespace hair::draw
