#include <libhair/wisps/literal.h>

#include <algorithm>
#include <cmath>
#include <span>

#include <libhair/geometry/mesh_sdf.h>

namespace hair::literal {

namespace {

// Point i + t, t in [0, 1], of the curve through p; beyond its ends it is reflected.
glm::dvec3 catmullRom(std::span<const glm::dvec3> p, std::size_t i, double t) {
  const glm::dvec3 b = p[i], c = p[i + 1];
  const glm::dvec3 a = i > 0 ? p[i - 1] : 2.0 * b - c;
  const glm::dvec3 d = i + 2 < p.size() ? p[i + 2] : 2.0 * c - b;
  return 0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t +
                (3.0 * (b - c) + d - a) * t * t * t);
}

// A guide sampled evenly in its parameter.
struct Curve {
  std::vector<glm::dvec3> point;  // [samples]
  std::vector<glm::dmat3> frame;  // [samples], columns normal, binormal, tangent

  Curve(std::span<const glm::dvec3> guide, glm::dvec3 rootTangent, glm::dvec3 rootNormal,
        std::size_t samples) {
    for (std::size_t k = 0; k < samples; ++k) {
      const double u =
          static_cast<double>(k * (guide.size() - 1)) / static_cast<double>(samples - 1);
      const std::size_t i = std::min(static_cast<std::size_t>(u), guide.size() - 2);
      point.push_back(catmullRom(guide, i, u - static_cast<double>(i)));
    }
    // Parallel transport: the shortest rotation from tangent to tangent.
    glm::dvec3 tangent = rootTangent, normal = rootNormal;
    for (std::size_t k = 0; k < samples; ++k) {
      const glm::dvec3 next =
          glm::normalize(point[std::min(k + 1, samples - 1)] - point[k > 0 ? k - 1 : 0]);
      const glm::dvec3 h = tangent + next;
      normal -= 2 * glm::dot(normal, next) / glm::dot(h, h) * h;
      tangent = next;
      frame.emplace_back(normal, glm::cross(tangent, normal), tangent);
    }
  }
};

// The strands of a groom that follow these curves.
struct Strands {
  const Groom& groom;
  std::vector<Curve> curves;  // [guideCount]

  std::size_t points(std::size_t s) const { return groom.first[s + 1] - groom.first[s]; }
  // The sample nearest to point k of a strand.
  std::size_t sampleOf(std::size_t s, std::size_t k) const {
    const auto last = static_cast<double>(curves[0].point.size() - 1);
    return static_cast<std::size_t>(
        std::floor(static_cast<double>(k) * last / static_cast<double>(points(s) - 1) + 0.5));
  }
  glm::dvec3 offset(std::size_t s, std::size_t k) const {
    return groom.offsets.empty() ? glm::dvec3(0) : glm::dvec3(groom.offsets[groom.first[s] + k]);
  }
  const Curve& curve(std::size_t s, int j) const { return curves[groom.parents[s][j]]; }

  glm::dvec3 multi(std::size_t s, std::size_t k) const {
    const std::size_t at = sampleOf(s, k);
    glm::dvec3 p = curve(s, 0).frame[at] * offset(s, k);
    for (int j = 0; j < 3; ++j)
      p += static_cast<double>(groom.weights[s][j]) * curve(s, j).point[at];
    return p;
  }
  glm::dvec3 single(std::size_t s, std::size_t k, glm::dvec3 rootOffset) const {
    const std::size_t at = sampleOf(s, k);
    return curve(s, 0).point[at] + curve(s, 0).frame[at] * (rootOffset + offset(s, k));
  }
  // r: where multi has the root, in the frame there, from the root of the main guide.
  glm::dvec3 rootOffset(std::size_t s) const {
    const glm::dvec3 fromGuide = multi(s, 0) - curve(s, 0).point[0];
    return glm::transpose(curve(s, 0).frame[0]) * fromGuide - offset(s, 0);
  }
};

// The nearest collider: unit direction away from it, and the distance beyond the clearance, metres.
glm::dvec4 nearest(const ColliderState& colliders, float clearance, float headClearance,
                   glm::dvec3 point) {
  const glm::vec3 p(point);
  glm::vec4 best(0, 1, 0, INFINITY);
  const auto consider = [&](glm::vec4 d, float keep) {
    d.w -= keep;
    if (d.w < best.w) best = d;
  };
  for (const Capsule& c : colliders.capsules) consider(distanceAndGradient(c, p), clearance);
  for (const Plane& c : colliders.scenery.planes) consider(distanceAndGradient(c, p), clearance);
  for (const MeshCollider& c : colliders.scenery.meshes)
    consider(distanceAndGradient(c, p), clearance);
  if (colliders.head) {
    const glm::vec4 d =
        colliders.head->distanceAndGradient(inverse(colliders.worldFromHead).point(p));
    consider({colliders.worldFromHead.vector(glm::vec3(d)), d.w}, headClearance);
  }
  return best;
}

}  // namespace

std::vector<glm::dvec3> interpolateWisps(const Groom& groom, const GuideStrands& guides,
                                         const ColliderState& colliders,
                                         const WispSettings& settings, const MeshSdf* headAtRest) {
  // Curves have as many samples as the longest strand has points.
  std::size_t samples = 2;
  for (std::size_t s = 0; s < groom.strandCount(); ++s)
    samples = std::max<std::size_t>(samples, groom.first[s + 1] - groom.first[s]);
  Strands rest{groom, {}}, now{groom, {}};
  for (std::size_t g = 0; g < groom.guideCount(); ++g) {
    const std::vector<glm::dvec3> atRest(groom.guide(g).begin(), groom.guide(g).end());
    std::vector<glm::dvec3> points;
    for (std::uint32_t i = 0; i < groom.pointsPerGuide; ++i)
      points.emplace_back(guides.point(g, i));
    const glm::vec3 tangent(glm::normalize(atRest[1] - atRest[0])), normal = rootNormalOf(tangent);
    rest.curves.emplace_back(atRest, tangent, normal, samples);
    now.curves.emplace_back(points, guides.worldFromHead.vector(tangent),
                            guides.worldFromHead.vector(normal), samples);
  }

  std::vector<glm::dvec3> drawn;
  for (std::size_t s = 0; s < groom.strandCount(); ++s) {
    const std::size_t n = now.points(s), blend = settings.blendPoints;
    float headClearance = settings.clearance;
    for (std::size_t k = 1; k < n && headAtRest; ++k)
      headClearance = std::min(headClearance, headAtRest->distance(glm::vec3(rest.multi(s, k))));
    const auto nearestTo = [&](glm::dvec3 p) {
      return nearest(colliders, settings.clearance, headClearance, p);
    };
    // Find the first point that is inside of a collider.
    std::size_t hit = n;
    for (std::size_t k = n - 1; k > 0 && settings.avoidColliders; --k)
      if (nearestTo(now.multi(s, k)).w < 0) hit = k;
    const std::size_t start = hit > blend ? hit - blend : 1;
    for (std::size_t k = 0; k < n; ++k) {
      glm::dvec3 p = now.multi(s, k);
      if (hit < n && k >= start) {
        const double t =
            hit > start
                ? std::min(1.0, static_cast<double>(k - start) / static_cast<double>(hit - start))
                : 1.0;
        p = glm::mix(p, now.single(s, k, rest.rootOffset(s)), t * t * (3 - 2 * t));
        for (int round = 0; round < 2; ++round)
          if (const glm::dvec4 d = nearestTo(p); d.w < 0) p -= d.w * glm::dvec3(d);
      }
      drawn.push_back(p);
    }
  }
  return drawn;
}

}  // namespace hair::literal
