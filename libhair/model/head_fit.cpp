#include <algorithm>
#include <array>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/strands.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/model/head.h>

namespace hair {
namespace {

constexpr std::size_t kFewestRoots = 16;

// Solves the n by n system (n <= 6) by Gaussian elimination with pivots; false if singular.
template <std::size_t n>
bool solve(std::array<std::array<double, n + 1>, n>& m, std::array<double, n>& x) {
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
    if (!(std::abs(m[pivot][c]) > 1e-30)) return false;
    std::swap(m[c], m[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      const double f = m[r][c] / m[c][c];
      for (std::size_t k = c; k <= n; ++k) m[r][k] -= f * m[c][k];
    }
  }
  for (std::size_t c = 0; c < n; ++c) x[c] = m[c][n] / m[c][c];
  return true;
}

struct Sphere {
  glm::vec3 centre;
  float radius;
};

// Sphere through points, linear least squares: |p|^2 = 2 c.p + k, about their mean.
Sphere fitSphere(std::span<const glm::vec3> points) {
  glm::dvec3 mean(0);
  for (glm::vec3 p : points) mean += glm::dvec3(p);
  mean /= static_cast<double>(points.size());
  std::array<std::array<double, 5>, 4> m{};
  for (glm::vec3 point : points) {
    const glm::dvec3 p = glm::dvec3(point) - mean;
    const std::array<double, 5> row = {p.x, p.y, p.z, 1, glm::dot(p, p)};
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t c = 0; c < 5; ++c) m[r][c] += row[r] * row[c];
  }
  std::array<double, 4> x{};
  require(solve<4>(m, x), "head: hair roots lie in a plane, which says nothing of the skull");
  const glm::dvec3 centre = 0.5 * glm::dvec3(x[0], x[1], x[2]);
  return {glm::vec3(mean + centre),
          static_cast<float>(std::sqrt(std::max(x[3] + glm::dot(centre, centre), 0.0)))};
}

// fitSphere of the built-in head's scalp.
Sphere builtinScalp(const Head& head) {
  std::vector<glm::vec3> scalp;
  for (glm::vec3 p : head.mesh.positions)
    if (scalpMask(p) > 0.5f) scalp.push_back(p);
  return fitSphere(scalp);
}

}  // namespace

RigidTransform placeHead(const TriangleMesh& mesh, std::span<const glm::vec3> hairRoots) {
  require(!mesh.positions.empty(), "head: the mesh has no vertices");
  const Head head = builtinHead();
  if (hairRoots.size() >= kFewestRoots)
    return {{1, 0, 0, 0}, builtinScalp(head).centre - fitSphere(hairRoots).centre};
  // The middle of the crown's box, on both heads.
  const auto crown = [](std::span<const glm::vec3> points) {
    const float top = bounds(points).upper.y;
    Bounds box;
    for (glm::vec3 p : points)
      if (p.y > top - 0.08f) box.extend(p);
    return glm::vec3(box.centre().x, top, box.centre().z);
  };
  return {{1, 0, 0, 0}, crown(head.mesh.positions) - crown(mesh.positions)};
}

void requireHeadSized(std::span<const glm::vec3> hairRoots) {
  if (hairRoots.size() < kFewestRoots) return;
  constexpr float kScalp = 0.3f;  // from end to end
  const float spread = glm::length(bounds(hairRoots).size());
  if (spread > 0.02f && spread < 1.2f) return;
  float best = 1;
  for (const float factor : {0.001f, 0.01f, 0.0254f, 0.1f, 10.0f, 100.0f, 1000.0f})
    if (std::abs(std::log(factor * spread / kScalp)) < std::abs(std::log(best * spread / kScalp)))
      best = factor;
  throw Error(text(
      "head: hair roots spread over ", spread, " m, which is no head's; check --scale",
      best == 1 ? "" : text(": ", best, " times what it is makes that ", best * spread, " m")));
}

HeadFit fitHeadToRoots(std::span<const glm::vec3> hairRoots) {
  require(hairRoots.size() >= kFewestRoots, "head: ", hairRoots.size(),
          " hair roots are too few to fit a head to; bring a head");
  requireHeadSized(hairRoots);
  HeadFit fit;
  fit.head = builtinHead();
  const MeshSdf sdf(fit.head.mesh, 0.005f, 0.05f);
  const Sphere scalp = builtinScalp(fit.head), roots = fitSphere(hairRoots);

  // Minimise the distances d of the scaled and shifted roots to the head,
  //   q = scale * (p - roots.centre) + scalp.centre + shift,
  // by Levenberg-Marquardt steps in the six unknowns, starting from the two spheres. Outliers (a
  // stray, a beard) get less weight: cost sum c^2 log(1 + (d / c)^2), weights 1 / (1 + (d / c)^2).
  // A weak regularisation towards the spheres fixes unknowns that the roots do not determine.
  struct Unknowns {
    glm::dvec3 scale, shift;
  };
  constexpr double c = 0.02, pull = 0.01 * 0.1 * 0.1, least = 1 / 1.7, most = 1 / 0.6;
  const double ratio =
      std::clamp(static_cast<double>(scalp.radius / std::max(roots.radius, 1e-4f)), least, most);
  const std::size_t stride = std::max<std::size_t>(1, hairRoots.size() / 2048);
  const auto onHead = [&](const Unknowns& u, glm::vec3 p) {
    return glm::vec3(u.scale * glm::dvec3(p - roots.centre) + glm::dvec3(scalp.centre) + u.shift);
  };
  const auto cost = [&](const Unknowns& u) {
    double sum = 0;
    for (std::size_t i = 0; i < hairRoots.size(); i += stride) {
      const double d = sdf.distance(onHead(u, hairRoots[i]));
      const glm::dvec3 off = u.scale - ratio;
      sum += c * c * std::log1p(d * d / (c * c)) + pull * glm::dot(off, off);
    }
    return sum;
  };
  Unknowns now{glm::dvec3(ratio), glm::dvec3(0)};
  double lowest = cost(now), damping = 1e-3;
  for (int iteration = 0; iteration < 40 && damping < 1e6; ++iteration) {
    std::array<std::array<double, 7>, 6> m{};
    for (std::size_t i = 0; i < hairRoots.size(); i += stride) {
      const glm::vec4 d = sdf.distanceAndGradient(onHead(now, hairRoots[i]));
      const glm::dvec3 n(d), arm = n * glm::dvec3(hairRoots[i] - roots.centre);
      const double weight = 1 / (1 + d.w * d.w / (c * c));
      const std::array<double, 7> row = {n.x, n.y, n.z, arm.x, arm.y, arm.z, -d.w};
      for (std::size_t r = 0; r < 6; ++r)
        for (std::size_t k = 0; k < 7; ++k) m[r][k] += weight * row[r] * row[k];
      for (int axis = 0; axis < 3; ++axis) {
        const auto r = 3 + static_cast<std::size_t>(axis);
        m[r][r] += pull;
        m[r][6] -= pull * (now.scale[axis] - ratio);
      }
    }
    for (std::size_t r = 0; r < 6; ++r) m[r][r] *= 1 + damping;
    std::array<double, 6> x{};
    if (!solve<6>(m, x)) break;
    const Unknowns next{glm::clamp(now.scale + glm::dvec3(x[3], x[4], x[5]), least, most),
                        now.shift + glm::dvec3(x[0], x[1], x[2])};
    const double nextCost = cost(next);
    if (nextCost < lowest) {
      now = next;
      lowest = nextCost;
      damping *= 0.3;
    } else {
      damping *= 4;
    }
  }

  // The hair keeps its size: scale the head instead, about its origin.
  const glm::vec3 bigger(1.0 / now.scale);
  for (std::size_t v = 0; v < fit.head.mesh.positions.size(); ++v) {
    fit.head.mesh.positions[v] *= bigger;
    fit.head.mesh.normals[v] = glm::normalize(fit.head.mesh.normals[v] / bigger);
  }
  fit.headFromHair.translation = bigger * (scalp.centre + glm::vec3(now.shift)) - roots.centre;
  double sum = 0;
  for (glm::vec3 p : hairRoots) sum += std::abs(sdf.distance(onHead(now, p)));
  fit.residual = static_cast<float>(sum / static_cast<double>(hairRoots.size())) *
                 (bigger.x + bigger.y + bigger.z) / 3;
  require(fit.residual < 0.03f, "head: hair roots are ", 1e3f * fit.residual,
          " mm from any head on average; check the unit and the axes (--scale, --up)");
  return fit;
}

}  // namespace hair
