#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <libhair/geometry/surface_nets.h>
#include <libhair/model/head.h>

namespace hair {
namespace {

// Everything below is in millimetres and for the side x >= 0; the other side is its mirror image.
using glm::vec3;

constexpr float kNeckCut = -110;

// Distance to an ellipsoid, first order in the distance (Quilez, "Ellipsoid - distance
// estimation").
float ellipsoid(vec3 p, vec3 centre, vec3 radii) {
  const vec3 d = p - centre;
  const float k0 = glm::length(d / radii), k1 = glm::length(d / (radii * radii));
  return k1 > 1e-9f ? k0 * (k0 - 1) / k1 : -std::min({radii.x, radii.y, radii.z});
}

// Distance to a cone with round ends.
float limb(vec3 p, vec3 a, vec3 b, float ra, float rb) {
  const vec3 ab = b - a;
  const float t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0f, 1.0f);
  return glm::length(p - a - t * ab) - glm::mix(ra, rb, t);
}

// Union that rounds the joint over a distance k (polynomial smooth minimum, Quilez).
float join(float a, float b, float k) {
  const float h = std::max(k - std::abs(a - b), 0.0f) / k;
  return std::min(a, b) - h * h * k * 0.25f;
}

float carve(float a, float b, float k) {
  return -join(-a, b, k);
}

vec3 turnedX(vec3 p, vec3 about, float radians) {
  const vec3 d = p - about;
  const float c = std::cos(radians), s = std::sin(radians);
  return about + vec3(d.x, c * d.y - s * d.z, s * d.y + c * d.z);
}

vec3 turnedY(vec3 p, vec3 about, float radians) {
  const vec3 d = p - about;
  const float c = std::cos(radians), s = std::sin(radians);
  return about + vec3(c * d.x + s * d.z, d.y, -s * d.x + c * d.z);
}

float earDistance(vec3 p) {
  const vec3 centre(75, 74, -6);
  const vec3 q = turnedX(turnedY(p, centre, 0.38f), centre, 0.18f);
  float ear = ellipsoid(q, centre, {6.5f, 31, 18});
  ear = join(ear, ellipsoid(q, centre + vec3(-1, -24, 5), {6, 11, 9}), 8);  // lobe
  return carve(ear, ellipsoid(q, centre + vec3(7, 4, 3), {7, 19, 10}), 5);
}

float skullDistance(vec3 p) {
  float d = ellipsoid(p, {0, 117, -3}, {75, 89, 94});
  d = join(d, ellipsoid(p, {0, 112, 32}, {63, 72, 64}), 30);  // forehead
  d = join(d, ellipsoid(p, {0, 70, -48}, {54, 50, 42}), 30);  // occiput
  return d;
}

float faceDistance(vec3 p) {
  float d = ellipsoid(p, {0, 60, 43}, {56, 64, 46});
  d = join(d, limb(p, {44, 36, 6}, {11, 0, 66}, 14, 13), 26);  // jaw
  d = join(d, ellipsoid(p, {0, 18, 44}, {40, 34, 42}), 20);
  d = join(d, ellipsoid(p, {0, -3, 76}, {13, 13, 14}), 20);   // chin
  d = join(d, ellipsoid(p, {38, 64, 58}, {19, 16, 22}), 24);  // cheekbone
  d = join(d, ellipsoid(p, {26, 36, 56}, {20, 26, 26}), 24);  // cheek
  d = join(d, limb(p, {0, 93, 90}, {38, 97, 71}, 4, 5), 20);  // brow
  return d;
}

float carvedFaceDistance(vec3 p, float d) {
  d = carve(d, ellipsoid(p, {28, 81, 102}, {16, 10, 17}), 14);                // eye socket
  d = join(d, ellipsoid(p, {30, 80.5f, 73.5f}, {14, 12, 12.5f}), 4);          // closed eye
  d = carve(d, limb(p, {19, 76.5f, 87}, {40, 77.5f, 81.5f}, 0.9f, 0.9f), 3);  // lid line
  float nose = limb(p, {0, 90, 92}, {0, 64, 107}, 4.5f, 6.2f);
  nose = join(nose, ellipsoid(p, {0, 60.5f, 106.5f}, {7, 6, 7.5f}), 8);
  nose = join(nose, ellipsoid(p, {8, 56.5f, 99}, {5.5f, 5, 8}), 7);
  d = join(d, nose, 12);
  d = join(d, ellipsoid(p, {0, 31, 77}, {29, 25, 15.5f}), 16);  // around the mouth
  float lips = ellipsoid(p, {0, 35, 90.5f}, {17, 4.6f, 5.5f});
  lips = join(lips, ellipsoid(p, {0, 27.6f, 90}, {15, 5.6f, 6.3f}), 2);
  d = join(d, lips, 6);
  return carve(d, limb(p, {0, 31.6f, 97.6f}, {19, 32.6f, 92}, 0.8f, 0.4f), 7);
}

float distanceMillimetres(vec3 p) {
  p.x = std::abs(p.x);
  float d = join(skullDistance(p), faceDistance(p), 26);
  d = carvedFaceDistance(p, d);
  const float neck = limb(p, {0, -130, -12}, {0, 45, -17}, 53, 43);
  d = join(d, neck, 22);
  d = join(d, earDistance(p), 6);
  return carve(d, p.y - kNeckCut, 14);
}

// Height of the hairline (millimetres) over the azimuth: 0 at the face, 180 degrees at the back.
float hairlineHeight(float degrees) {
  constexpr std::array<std::array<float, 2>, 12> line = {{{0, 169},
                                                          {20, 167},
                                                          {38, 156},
                                                          {52, 140},
                                                          {66, 112},
                                                          {78, 92},
                                                          {86, 104},
                                                          {98, 108},
                                                          {110, 92},
                                                          {122, 46},
                                                          {145, 20},
                                                          {180, 14}}};
  std::size_t i = 0;
  while (i + 2 < line.size() && line[i + 1][0] < degrees) ++i;
  float t = (degrees - line[i][0]) / (line[i + 1][0] - line[i][0]);
  t = std::clamp(t, 0.0f, 1.0f);
  return glm::mix(line[i][1], line[i + 1][1], t * t * (3 - 2 * t));
}

}  // namespace

float headField(vec3 p) {
  return 1e-3f * distanceMillimetres(1e3f * p);
}

float scalpMask(vec3 point) {
  vec3 p = 1e3f * point;
  p.x = std::abs(p.x);
  const float degrees = std::atan2(p.x, p.z) * 180 / std::numbers::pi_v<float>;
  const float aboveLine = p.y - hairlineHeight(degrees);
  const float offEar = earDistance(p) - 4;
  return glm::smoothstep(-3.0f, 3.0f, std::min(aboveLine, offEar));
}

Head builtinHead() {
  // Cells are finer at the face: the grid is regular in a space that `bent` maps to the head.
  const Bounds grid{{-0.1f, -0.175f, -0.13f}, {0.1f, 0.165f, 0.13f}};
  const auto bent = [](vec3 q) {
    const auto about = [](float v, float reach) {
      const float r = v / reach;
      return v * (0.76f + 0.24f * r * r);
    };
    const float t = (q.z + 0.13f) / 0.26f;
    return vec3(about(q.x, 0.1f), 0.055f + about(q.y, 0.16f), q.z + 0.26f * 0.38f * t * (1 - t));
  };
  Head head{surfaceNets([&](vec3 q) { return headField(bent(q)); }, grid, 0.0045f)};
  for (std::size_t v = 0; v < head.mesh.positions.size(); ++v) {
    vec3& p = head.mesh.positions[v];
    p = bent(p);
    constexpr float h = 2e-4f;
    vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      vec3 step(0);
      step[axis] = h;
      gradient[axis] = headField(p + step) - headField(p - step);
    }
    head.mesh.normals[v] = glm::normalize(gradient);
  }
  return head;
}

}  // namespace hair
