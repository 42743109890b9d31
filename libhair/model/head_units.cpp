#include <libhair/model/head_units.h>

#include <algorithm>
#include <array>

#include <libhair/geometry/triangle_distance.h>

namespace hair {

std::vector<glm::vec3> someOf(std::span<const glm::vec3> roots, std::size_t most) {
  std::vector<glm::vec3> some;
  const std::size_t stride = std::max<std::size_t>(1, (roots.size() + most - 1) / most);
  for (std::size_t i = 0; i < roots.size(); i += stride) some.push_back(roots[i]);
  return some;
}

float rootDistance(const TriangleMesh& mesh, std::span<const glm::vec3> roots,
                   const ReadOptions& units) {
  // The roots go into the mesh's space: they are fewer.
  std::vector<glm::vec3> points = someOf(roots, 64);
  if (points.empty() || mesh.triangles.empty()) return INFINITY;
  convertUnitsBack(points, units.scale, units.up);
  std::vector<float> squared;
  for (const glm::vec3 p : points) {
    float best = INFINITY;
    for (const glm::uvec3& t : mesh.triangles) {
      const TriangleCorners corners = {mesh.positions[t.x], mesh.positions[t.y],
                                       mesh.positions[t.z]};
      if (squaredBoxDistance(p, corners) < best) best = std::min(best, squaredDistance(p, corners));
    }
    squared.push_back(best);
  }
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return units.scale * std::sqrt(*middle);
}

UnitsThatFit unitsThatFit(const TriangleMesh& mesh, std::span<const glm::vec3> roots) {
  // Metres, centimetres, millimetres, inches, feet, decimetres, Yuksel's; and head radii of 1.
  constexpr std::array kScales = {1.0f, 0.01f, 0.001f, 0.0254f, 0.3048f, 0.1f, 0.00465f, 10.0f};
  constexpr std::array kAxes = {UpAxis::Y, UpAxis::ZBack, UpAxis::Z, UpAxis::X, UpAxis::YDown};
  UnitsThatFit best{{1, UpAxis::Y}, INFINITY};
  for (const float scale : kScales)
    for (const UpAxis up : kAxes) {
      const float distance = rootDistance(mesh, roots, {scale, up});
      if (distance < best.distance) best = {{scale, up}, distance};
    }
  return best;
}

}  // namespace hair
