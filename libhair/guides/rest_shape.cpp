#include <libhair/guides/rest_shape.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/transform.h>

namespace hair {

namespace {

// Whether the rest shape is stable against buckling: small sideways movements must cost more energy
// in bending (times `factor`) than compressed links release. With u_k the sideways movement of
// point k,
//     2 E = factor · sum kappa_i ((u_(i+1) - u_i) / l_i - (u_i - u_(i-1)) / l_(i-1))²
//           + kMargin · sum T_i (u_(i+1) - u_i)² / l_i
// is positive if every pivot of its pentadiagonal matrix is.
bool stands(const RestShape& rest, std::size_t links, double factor) {
  // Form the matrix, as factorBending does.
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
  // Factor it, and stop at the first pivot that is not positive.
  for (std::size_t i = 1; i <= links; ++i) {
    const double l2 = i > 2 ? below2[i] / d[i - 2] : 0;
    l1[i] = i > 1 ? (below1[i] - (i > 2 ? l2 * d[i - 2] * l1[i - 1] : 0)) / d[i - 1] : 0;
    d[i] = diagonal[i] - (i > 1 ? l1[i] * l1[i] * d[i - 1] : 0) - (i > 2 ? l2 * l2 * d[i - 2] : 0);
    if (!(d[i] > 0)) return false;
  }
  return true;
}

// The least factor of the stiffness with which the rest shape is stable, by bisection.
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
// Link i must carry F_i, the weight (per linear density) of all points after it:
//     F_i = (g_i - g_(i+1)) / l_i + T_i d_i,    g_i = kappa_i (d_i - d_(i-1) - c_i).
// From tip to root, the part of g_(i+1) + l_i F_i across the link is g_i, the torque of joint i,
// and the rest, along the link, is its tension. Then c_i = d_i - d_(i-1) - g_i / kappa_i.
void holdAgainstGravity(std::span<const glm::vec3> points, glm::vec3 rootNormal, glm::vec3 gravity,
                        RestShape& rest) {
  const std::size_t links = points.size() - 1;
  std::array<glm::vec3, kMaxGuidePoints> d, g;
  for (std::size_t i = 0; i < links; ++i) d[i] = glm::normalize(points[i + 1] - points[i]);
  // Find torques and tensions from tip to root.
  glm::vec3 weight(0), torque(0);
  for (std::size_t i = links; i-- > 0;) {
    weight += rest.mass[i + 1] * gravity;
    const glm::vec3 full = torque + rest.linkLength[i] * weight;
    g[i] = full - glm::dot(full, d[i]) * d[i];
    rest.tension[i] = glm::dot(d[i], weight - (g[i] - torque) / rest.linkLength[i]);
    // Take the larger torque of its two joints: both push on the ends of link i.
    const float mass = i > 0 ? std::min(rest.mass[i], rest.mass[i + 1]) : rest.mass[i + 1];
    const float most = std::max(glm::length(g[i]), glm::length(torque));
    rest.torqueLimit[i] =
        mass * rest.linkLength[i] * rest.linkLength[i] * rest.linkLength[i] / most;
    torque = g[i];
  }
  // Stiffen the strand if it would buckle, and find the curvatures in the transported frames.
  const auto factor = static_cast<float>(stiffnessToStand(rest, links));
  glm::vec3 tangent = d[0], normal = rootNormal;
  for (std::size_t i = 0; i < links; ++i) {
    rest.stiffness[i] *= factor;
    // A strand without stiffness holds nothing up: keep its curvature as groomed.
    const glm::vec3 held = rest.stiffness[i] > 0 ? g[i] / rest.stiffness[i] : glm::vec3(0);
    const glm::vec3 c = d[i] - tangent - held;
    rest.curvature[i] = {glm::dot(c, normal), glm::dot(c, glm::cross(tangent, normal)),
                         glm::dot(c, tangent)};
    normal = transport(normal, tangent, d[i]);
    tangent = d[i];
  }
}

// Explicit steps of h² <= m l / T are stable under tension T, with the lateral stiffness 4 T / l of
// a chain. The bending system holds the rest tension of short links for any h (BendingFactors), but
// nothing holds tension beyond that, or compression where the strand has turned against gravity:
// strands of uneven links take steps of a tenth of this h².
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

// The bending system has entries m / h² of mass and kappa / l² of stiffness; soft entries lose
// digits beside stiff ones. With kappa of a joint, s and b the shorter and the longer link at it
// and m the mass of its point, the stiff kappa / s² is beside the soft m / h² + kappa / b²:
//     C = (kappa / s²) / (m / h² + kappa / b²)
// is 1 at most where links are even, and (b / s)² where they are not. Floats have 7 digits.
// Measured on a link of 0.02 mm between two of 2 cm: strands rest where C is 6e4, and shake where
// it is 2e5. Even links are bent by rounding alone where kappa h² / (m l²) is 1e10 (measured).
float longestSubstep(const RestShape& rest, std::size_t links, std::size_t guide) {
  constexpr float kMostUneven = 3e4f, kMostEven = 1e9f;
  float longest = INFINITY;
  for (std::size_t i = 0; i < links; ++i) {
    const float next = rest.linkLength[i], before = i > 0 ? rest.linkLength[i - 1] : next;
    const float s = std::min(before, next), b = std::max(before, next);
    // Solve both limits for m / h².
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
    // Take half of both links as the length that bends at a joint; at the clamped root, half of
    // one.
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
