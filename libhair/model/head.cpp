#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <libhair/model/head.h>
#include <libhair/model/surface_nets.h>

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
  float d = ellipsoid(p, {0, 58, 44}, {56, 66, 46});
  d = join(d, limb(p, {46, 34, 6}, {12, -2, 68}, 15, 15), 26);  // jaw
  d = join(d, ellipsoid(p, {0, 18, 44}, {42, 34, 42}), 20);
  d = join(d, ellipsoid(p, {0, -6, 76}, {17, 14, 15}), 18);   // chin
  d = join(d, ellipsoid(p, {41, 66, 58}, {19, 15, 22}), 24);  // cheekbone
  d = join(d, limb(p, {9, 95, 89}, {40, 97, 70}, 6, 6), 18);  // brow
  return d;
}

float carvedFaceDistance(vec3 p, float d) {
  d = carve(d, ellipsoid(p, {29, 82, 101}, {17, 11, 17}), 14);          // eye socket
  d = join(d, ellipsoid(p, {30, 81, 73}, {13.5f, 12, 12.5f}), 4);       // closed eye
  d = carve(d, limb(p, {19, 77.5f, 87.5f}, {41, 78.5f, 82}, 1, 1), 3);  // lid line
  float nose = limb(p, {0, 90, 90}, {0, 61, 107}, 6, 7.5f);
  nose = join(nose, ellipsoid(p, {0, 58, 107}, {9, 7.5f, 9}), 6);
  nose = join(nose, ellipsoid(p, {9, 56, 100}, {6.5f, 6, 8}), 6);
  d = join(d, nose, 10);
  d = carve(d, ellipsoid(p, {5.5f, 49, 104}, {3, 3, 4}), 4);  // nostril
  float mouth = ellipsoid(p, {0, 30, 84}, {24, 17, 13});
  mouth = join(mouth, ellipsoid(p, {6, 35.5f, 92}, {15, 4.2f, 7}), 4);
  mouth = join(mouth, ellipsoid(p, {0, 26.5f, 92}, {16, 5, 7.5f}), 4);
  mouth = carve(mouth, limb(p, {0, 31, 100}, {22, 31.5f, 93}, 1, 1), 4);
  d = join(d, mouth, 9);
  d = carve(d, limb(p, {0, 16, 98}, {9, 16, 96}, 4, 3), 10);  // below the lower lip
  return d;
}

float distanceMillimetres(vec3 p) {
  p.x = std::abs(p.x);
  float d = join(skullDistance(p), faceDistance(p), 26);
  d = carvedFaceDistance(p, d);
  const float neck = limb(p, {0, -125, -24}, {0, 50, -20}, 52, 48);
  d = join(d, neck, 22);
  d = join(d, earDistance(p), 6);
  return std::max(d, kNeckCut - p.y);
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
  const Bounds box{{-0.1f, -0.12f, -0.125f}, {0.1f, 0.22f, 0.135f}};
  return {surfaceNets(headField, box, 0.0042f)};
}

}  // namespace hair
