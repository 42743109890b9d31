#include <libhair/hair_mesh/scalp_patch.h>
#include <libhair/model/scalp_roots.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/model/head.h>

namespace hair {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Vertex 0 is the pole, followed by the rings: vertices point(r / rings, sector) for r = 1 ...
// rings.
PolygonMesh ringsOf(const ScalpPatch& patch,
                    const std::function<glm::vec3(float share, std::uint32_t sector)>& point) {
  require(patch.rings >= 1 && patch.sectors >= 3, "scalp: ", patch.rings, " rings of ",
          patch.sectors, " sectors; needs at least 1 of 3");
  PolygonMesh mesh;
  mesh.positions.push_back(point(0, 0));
  for (std::uint32_t r = 1; r <= patch.rings; ++r)
    for (std::uint32_t s = 0; s < patch.sectors; ++s)
      mesh.positions.push_back(point(static_cast<float>(r) / static_cast<float>(patch.rings), s));
  const auto vertex = [&](std::uint32_t ring, std::uint32_t sector) {
    return ring == 0 ? 0 : 1 + (ring - 1) * patch.sectors + sector % patch.sectors;
  };
  for (std::uint32_t r = 0; r < patch.rings; ++r)
    for (std::uint32_t s = 0; s < patch.sectors; ++s) {
      mesh.corners.push_back(vertex(r, s));
      mesh.corners.push_back(vertex(r + 1, s));
      mesh.corners.push_back(vertex(r + 1, s + 1));
      if (r > 0) mesh.corners.push_back(vertex(r, s + 1));
      mesh.firstCorner.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
  return mesh;
}

// Unit vector `angle` from +Y; sector s turns from +Z over +X.
glm::vec3 fromPole(const ScalpPatch& patch, float angle, std::uint32_t s) {
  const float turn = 2 * kPi * static_cast<float>(s) / static_cast<float>(patch.sectors);
  return {std::sin(angle) * std::sin(turn), std::cos(angle), std::sin(angle) * std::cos(turn)};
}

// A curve over the built-in head from the whorl outwards, along the parting at the front.
class Meridian {
 public:
  Meridian(const ScalpPatch& patch, const Parting& parting, std::uint32_t sector)
      : patch_(patch), parting_(parting), sector_(sector) {
    const float turn = 2 * kPi * static_cast<float>(sector) / static_cast<float>(patch.sectors);
    const float front = std::max(std::cos(turn), 0.0f);
    front_ = front * front;
    tilt_ = std::atan2(parting.whorlZ - kSkullMiddle.z, 0.1f);
  }

  // `angle` from the whorl, radians.
  glm::vec3 at(float angle) const {
    glm::vec3 d = fromPole(patch_, angle, sector_);
    const float c = std::cos(tilt_), s = std::sin(tilt_);
    d = {d.x, c * d.y - s * d.z, s * d.y + c * d.z};
    glm::vec3 p = onScalp(kSkullMiddle + d);
    // Shift the whole top to the parting, but not the sides and the back.
    const float moved = 1 - glm::smoothstep(0.0f, 1.2f, angle) * (1 - front_);
    const float x = p.x + moved * parting_.x;
    // Projection along rays from the skull's middle changes x: repeat it until x is kept.
    for (int i = 0; i < 6; ++i) p = onScalp({x, p.y, p.z});
    return p;
  }

  // Angle at which the curve leaves the scalp.
  float hairline() const {
    constexpr float kStep = 0.03f;  // 3 mm: no step over an ear
    float inside = 0;
    while (inside < 2.6f && scalpMask(at(inside + kStep)) >= 0.5f) inside += kStep;
    float outside = inside + kStep;
    for (int i = 0; i < 20; ++i) {
      const float middle = 0.5f * (inside + outside);
      (scalpMask(at(middle)) >= 0.5f ? inside : outside) = middle;
    }
    return inside;
  }

 private:
  ScalpPatch patch_;
  Parting parting_;
  std::uint32_t sector_;
  float front_, tilt_;
};

}  // namespace

PolygonMesh headScalp(const ScalpPatch& patch, const Parting& parting) {
  require(std::abs(parting.x) <= 0.05f && std::abs(parting.whorlZ) <= 0.06f,
          "scalp: a parting at x = ", parting.x, " that ends at z = ", parting.whorlZ,
          " is not on top of the head (|x| <= 0.05, |z| <= 0.06)");
  std::vector<Meridian> meridians;
  meridians.reserve(patch.sectors);
  for (std::uint32_t s = 0; s < patch.sectors; ++s) meridians.emplace_back(patch, parting, s);
  std::vector<float> hairlines(patch.sectors);
  parallelFor(patch.sectors, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) hairlines[s] = meridians[s].hairline();
  });
  return ringsOf(
      patch, [&](float share, std::uint32_t s) { return meridians[s].at(share * hairlines[s]); });
}

PolygonMesh sphereScalp(const ScalpPatch& patch, float radius, float degrees) {
  require(radius > 0 && degrees > 0 && degrees < 180, "scalp: a sphere of radius ", radius,
          " down to ", degrees, " degrees");
  return ringsOf(patch, [&](float share, std::uint32_t s) {
    return radius * fromPole(patch, share * degrees * kPi / 180, s);
  });
}

}  // namespace hair
