#include <libhair/guides/rest_shape.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/transform.h>

namespace hair {

namespace {

// Whether small sideways movements of the rest shape cost energy: bending (times `factor`) against
// what compressed links give back. With u_k the sideways movement of point k,
//     2 E = factor · sum kappa_i ((u_(i+1) - u_i) / l_i - (u_i - u_(i-1)) / l_(i-1))²
//           + kMargin · sum T_i (u_(i+1) - u_i)² / l_i
// is positive if every pivot of its pentadiagonal matrix is.
bool stands(const RestShape& rest, std::size_t links, double factor) {
  constexpr double kMargin = 2;
  std::array<double, kMaxGuidePoints + 2> diagonal{}, below1{}, below2{}, d{}, l1{};
  for (std::size_t i = 0; i < links; ++i) {
    const double kappa = factor * rest.stiffness[i], next = 1.0 / rest.linkLength[i];
    const double before = i > 0 ? 1.0 / rest.linkLength[i - 1] : 0.0;
    const double tension = kMargin * rest.tension[i] * next;
    diagonal[i + 1] += kappa * next * next + tension;
    diagonal[i] += kappa * (next + before) * (next + before) + tension;
    below1[i + 1] -= kappa * next * (next + before) + tension;
    if (i == 0) continue;
    diagonal[i - 1] += kappa * before * before;
    below1[i] -= kappa * before * (next + before);
    below2[i + 1] += kappa * next * before;
  }
  for (std::size_t i = 1; i <= links; ++i) {
    const double l2 = i > 2 ? below2[i] / d[i - 2] : 0;
    l1[i] = i > 1 ? (below1[i] - (i > 2 ? l2 * d[i - 2] * l1[i - 1] : 0)) / d[i - 1] : 0;
    d[i] = diagonal[i] - (i > 1 ? l1[i] * l1[i] * d[i - 1] : 0) - (i > 2 ? l2 * l2 * d[i - 2] : 0);
    if (!(d[i] > 0)) return false;
  }
  return true;
}

double stiffnessToStand(const RestShape& rest, std::size_t links) {
  if (stands(rest, links, 1)) return 1;
  double low = 1, high = 2;
  while (!stands(rest, links, high) && high < 1e9) low = high, high *= 2;
  for (int i = 0; i < 20; ++i)
    (stands(rest, links, 0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return high;
}

// Rest curvatures that hold the groom up against gravity.
//
// F_i, the weight (per linear density) of all that hangs on link i, must be carried by the link:
//     F_i = (g_i - g_(i+1)) / l_i + T_i d_i,    g_i = kappa_i (d_i - d_(i-1) - c_i).
// From the tip on, take for g_i what is transverse in g_(i+1) + l_i F_i: the torque of joint i.
// What is left along the link is tension. Then c_i = d_i - d_(i-1) - g_i / kappa_i.
void holdAgainstGravity(std::span<const glm::vec3> points, glm::vec3 rootNormal, glm::vec3 gravity,
                        RestShape& rest) {
  const std::size_t links = points.size() - 1;
  std::array<glm::vec3, kMaxGuidePoints> d, g;
  for (std::size_t i = 0; i < links; ++i) d[i] = glm::normalize(points[i + 1] - points[i]);
  glm::vec3 weight(0), torque(0);
  for (std::size_t i = links; i-- > 0;) {
    weight += rest.mass[i + 1] * gravity;
    const glm::vec3 full = torque + rest.linkLength[i] * weight;
    g[i] = full - glm::dot(full, d[i]) * d[i];
    rest.tension[i] = glm::dot(d[i], weight - (g[i] - torque) / rest.linkLength[i]);
    // The torques of both of its joints push on the ends of link i, away from it on either side.
    const float mass = i > 0 ? std::min(rest.mass[i], rest.mass[i + 1]) : rest.mass[i + 1];
    const float most = std::max(glm::length(g[i]), glm::length(torque));
    rest.borne[i] = mass * rest.linkLength[i] * rest.linkLength[i] * rest.linkLength[i] / most;
    torque = g[i];
  }
  const auto factor = static_cast<float>(stiffnessToStand(rest, links));
  glm::vec3 tangent = d[0], normal = rootNormal;
  for (std::size_t i = 0; i < links; ++i) {
    rest.stiffness[i] *= factor;
    // Without stiffness no curvature holds anything up.
    const glm::vec3 held = rest.stiffness[i] > 0 ? g[i] / rest.stiffness[i] : glm::vec3(0);
    const glm::vec3 c = d[i] - tangent - held;
    rest.curvature[i] = {glm::dot(c, normal), glm::dot(c, glm::cross(tangent, normal)),
                         glm::dot(c, tangent)};
    normal = transport(normal, tangent, d[i]);
    tangent = d[i];
  }
}

// Tension T is stable in explicit steps of h² <= m l / T, with the lateral stiffness 4 T / l of a
// chain. The bending system holds the rest tension of short links whatever h is (BendingFactors),
// but nothing holds what is more, or what pushes where gravity has turned: strands of uneven links
// take steps in which that is a tenth.
float longestUnderTension(const RestShape& rest, std::size_t links) {
  const auto [least, most] =
      std::minmax_element(rest.linkLength.begin(), rest.linkLength.begin() + links);
  if (*most <= kEven * *least) return INFINITY;
  float h2 = INFINITY;
  for (std::size_t i = 0; i < links; ++i)
    h2 = std::min(h2, 0.1f * rest.mass[i + 1] * rest.linkLength[i] /
                          std::max(std::abs(rest.tension[i]), 1e-20f));
  return std::sqrt(h2);
}

// A bending system has entries m / h² of mass and kappa / l² of stiffness, and loses digits of what
// is soft beside what is stiff. With kappa of a joint, s and b the shorter and the longer link at
// it and m the mass of its point, the stiff kappa / s² stands beside the soft m / h² + kappa / b²:
//     C = (kappa / s²) / (m / h² + kappa / b²)
// is 1 at most where links are even, and (b / s)² where they are not. Floats have 7 digits.
// Measured on a link of 0.02 mm between two of 2 cm: strands rest where C is 6e4, and shake where
// it is 2e5. And links as even as may be are bent by rounding alone where kappa h² / (m l²) is 1e10
// (measured).
float longestSubstep(const RestShape& rest, std::size_t links, std::size_t guide) {
  constexpr float kMostUneven = 3e4f, kMostEven = 1e9f;
  float longest = INFINITY;
  for (std::size_t i = 0; i < links; ++i) {
    const float next = rest.linkLength[i], before = i > 0 ? rest.linkLength[i - 1] : next;
    const float s = std::min(before, next), b = std::max(before, next);
    const float kappa = rest.stiffness[i], joint = 0.5f * (i > 0 ? before + next : next);
    const float least =
        std::max(kappa / (s * s) / kMostUneven - kappa / (b * b), kappa / (s * s) / kMostEven);
    const float h = std::sqrt(joint / std::max(least, 1e-20f));
    require(h >= kShortestSubstep, "groom: guide ", guide, " link ", i, " of ", next,
            " m is too short for its stiffness: it would take substeps of ", h, " s, below ",
            kShortestSubstep, "; take longer or more even links, or less bendingStiffness");
    longest = std::min(longest, h);
  }
  return longest;
}

}  // namespace

RestShape makeRestShape(std::span<const glm::vec3> points, glm::vec3 rootNormal,
                        const GuideSettings& settings, std::size_t guide) {
  RestShape rest;
  const std::size_t links = points.size() - 1;
  for (std::size_t i = 0; i < links; ++i) {
    rest.linkLength[i] = glm::distance(points[i], points[i + 1]);
  }
  for (std::size_t i = 0; i < links; ++i) {
    const float s = static_cast<float>(i) / static_cast<float>(links);
    const float stiffness = settings.bendingStiffness * glm::mix(1.0f, settings.tipStiffness, s);
    // The length that bends at the joint: half a link at the clamped root.
    const float joint =
        i == 0 ? 0.5f * rest.linkLength[0] : 0.5f * (rest.linkLength[i - 1] + rest.linkLength[i]);
    rest.stiffness[i] = stiffness / settings.linearDensity / joint;
    rest.mass[i] += 0.5f * rest.linkLength[i];
    rest.mass[i + 1] += 0.5f * rest.linkLength[i];
  }
  holdAgainstGravity(points, rootNormal, settings.gravity, rest);
  rest.longestSubstep = longestSubstep(rest, links, guide);
  rest.longestUnderTension = longestUnderTension(rest, links);
  return rest;
}

}  // namespace hair
