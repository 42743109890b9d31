#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <libhair/core/random.h>
#include <libhair/geometry/colliders.h>
#include <libhair/model/comb.h>
#include <libhair/model/scalp_roots.h>

namespace hair {
namespace {

constexpr float kStep = 0.002f;  // metres that a guide grows at a time
constexpr float kPi = std::numbers::pi_v<float>;

enum Use : std::uint16_t { Length = 0x200, WavePhase, WaveLength, Lie, Cut, Part, PartingSide };

// Colliders below the head: neck, shoulders, chest and back of a standing body with hanging arms,
// as fitted by fitCapsules; one side, to be mirrored.
constexpr std::array<Capsule, 12> kBust = {
    {{{0, -0.115f, -0.015f}, {0, -0.009f, -0.002f}, 0.052f},
     {{0.03f, -0.091f, -0.015f}, {0.096f, -0.122f, -0.013f}, 0.047f},
     {{0.096f, -0.122f, -0.013f}, {0.162f, -0.157f, -0.01f}, 0.052f},
     {{0.05f, -0.183f, 0.011f}, {0.14f, -0.174f, -0.006f}, 0.064f},
     {{0.162f, -0.157f, -0.01f}, {0.2f, -0.277f, -0.014f}, 0.05f},
     {{0, -0.15f, 0}, {0.051f, -0.15f, 0}, 0.066f},
     {{0, -0.2f, 0.002f}, {0.055f, -0.2f, 0.002f}, 0.082f},
     {{0, -0.26f, 0.005f}, {0.051f, -0.26f, 0.005f}, 0.088f},
     {{0.072f, -0.249f, 0.066f}, {0.072f, -0.249f, 0.066f}, 0.062f},
     {{0, -0.326f, 0.008f}, {0.044f, -0.326f, 0.008f}, 0.087f},
     {{0, -0.392f, 0.011f}, {0.04f, -0.392f, 0.011f}, 0.084f},
     {{0, -0.464f, 0.014f}, {0.042f, -0.464f, 0.014f}, 0.086f}}};

// Distance and outward direction of the nearest of head and bust.
glm::vec4 bodyDistance(const MeshSdf& headSdf, glm::vec3 p) {
  glm::vec4 nearest = headSdf.distanceAndGradient(p);
  const glm::vec3 mirrored(std::abs(p.x), p.y, p.z);
  for (const Capsule& c : kBust) {
    const glm::vec3 ab = c.b - c.a;
    const float t =
        std::clamp(glm::dot(mirrored - c.a, ab) / std::max(glm::dot(ab, ab), 1e-12f), 0.0f, 1.0f);
    glm::vec3 away = mirrored - c.a - t * ab;
    const float length = glm::length(away);
    if (p.x < 0) away.x = -away.x;
    if (length - c.radius < nearest.w && length > 1e-6f)
      nearest = glm::vec4(away / length, length - c.radius);
  }
  return nearest;
}

float azimuth(glm::vec3 p) {
  return std::atan2(std::abs(p.x), p.z);
}

// The face: azimuths below this, at height y. It narrows to nothing at the front hairline.
float faceEdge(float y) {
  const float share = 1 - glm::smoothstep(0.115f, 0.168f, y);
  return share * 62 * kPi / 180;
}

struct Growth {
  std::vector<glm::vec3> points;
  float length;
};

// Direction of combed hair at p, with the head's outward normal n: away from the parting on top,
// back from the face, down everywhere.
glm::vec3 combDirection(const Parting& parting, glm::vec3 p, glm::vec3 n, float distance) {
  const float top = glm::smoothstep(0.0f, 0.9f, n.y);
  const float beside = glm::smoothstep(-0.03f, 0.05f, p.z) * glm::smoothstep(0.06f, 0.15f, p.y);
  glm::vec3 d(0, -1, 0);
  d += (0.35f + 1.2f * top) * (p.y > 0.1f ? 1.0f : 0.0f) * awayFromParting(parting, p) *
       glm::smoothstep(0.08f, 0.14f, p.y);
  d += glm::vec3(0, 0, -0.75f * beside);
  // Steer away before it reaches the face.
  const float edge = faceEdge(p.y) - azimuth(p);
  const float closeness = glm::smoothstep(-0.35f, 0.1f, edge);
  const glm::vec3 outwards(p.x >= parting.x ? p.z : -p.z, 0, -std::abs(p.x));
  d += 0.8f * closeness * glm::normalize(outwards + glm::vec3(1e-6f, 0, 0));
  // Along the head where there is head below, straight down where there is not.
  const float lying =
      glm::smoothstep(-0.45f, 0.05f, n.y) * (1 - glm::smoothstep(0.02f, 0.05f, distance));
  d -= lying * glm::dot(d, n) * n;
  return glm::normalize(d + glm::vec3(0, -1e-3f, 0));
}

Growth grow(const StyleSettings& settings, const MeshSdf& headSdf, glm::vec3 root, glm::vec3 centre,
            std::uint32_t wisp, float knownLength) {
  const auto random = [&](Use use) { return 2 * uniform(wisp, use, settings.seed) - 1; };
  const float lie = 1 + 0.15f * random(Lie);
  // The side of the parting may be chosen at random for each wisp.
  Parting parting = settings.parting;
  parting.x += settings.partingJitter * random(PartingSide);
  if (settings.partingJitter > 0)
    parting.x = centre.x > parting.x ? std::min(parting.x, centre.x - 0.02f)
                                     : std::max(parting.x, centre.x + 0.02f);
  const bool toFront = azimuth(centre) < 1.7f + 0.15f * random(Part);
  const float phase = kPi * random(WavePhase), wave = 0.16f * (1 + 0.3f * random(WaveLength));
  const float vary = 1 + settings.lengthVariation * random(Length);
  const bool turnsIn = std::isfinite(knownLength);
  const float limit = turnsIn ? knownLength : settings.maxLength * vary;

  const glm::vec3 rootNormal = glm::vec3(headSdf.distanceAndGradient(root));
  glm::vec3 p = root;
  glm::vec3 direction =
      glm::normalize(combDirection(parting, root, rootNormal, 0) + settings.rootLift * rootNormal);
  Growth growth{{root}, 0};
  const int steps = static_cast<int>(limit / kStep);
  for (int step = 1; step <= steps; ++step) {
    const float s = kStep * static_cast<float>(step);
    const glm::vec4 here = bodyDistance(headSdf, p);
    const glm::vec3 n(here);
    const float clearance =
        std::min(0.0035f, 0.5f * s) + settings.volume * lie * (1 - std::exp(-s / 0.09f));
    glm::vec3 wanted = combDirection(parting, p, n, here.w);
    // Pull it to the head where the head is below it, as gravity and the hair above do.
    const float held = glm::smoothstep(0.0f, 0.3f, n.y);
    wanted -= std::clamp((here.w - clearance) / 0.02f, -1.0f, 1.0f) * held * n;
    const glm::vec3 side = glm::cross(direction, n);
    wanted += settings.waviness * std::sin(2 * kPi * s / wave + phase) *
              glm::smoothstep(0.03f, 0.12f, s) * side;
    // Gather it around the neck below the jaw.
    const glm::vec3 inwards(-p.x, 0, -0.03f - p.z);
    const float gather =
        (1 - glm::smoothstep(0.0f, 0.09f, p.y)) * glm::smoothstep(-0.16f, -0.08f, p.y);
    wanted += 1.7f * (1 - settings.partAtShoulders) * gather *
              glm::smoothstep(0.0f, 0.05f, here.w - clearance) * inwards;
    // Lead it in front of the shoulders or behind them.
    const float low = 1 - glm::smoothstep(-0.22f, -0.13f, p.y);
    const float parts = settings.partAtShoulders * (1 - glm::smoothstep(-0.06f, 0.04f, p.y));
    const float toGo =
        toFront ? 0.05f + 0.01f * random(Lie) + 0.035f * low - p.z : p.z + 0.09f + 0.03f * low;
    wanted.z += (toFront ? 1.0f : -1.0f) * parts * glm::smoothstep(0.0f, 0.04f, toGo);
    if (toFront)
      wanted.x -= std::copysign(
          parts * glm::smoothstep(0.085f + 0.025f * random(Part), 0.14f, std::abs(p.x)), p.x);
    if (turnsIn) {
      const float tip = glm::smoothstep(0.7f * limit, limit, s);
      wanted += settings.turnIn * 1.6f * tip * glm::normalize(inwards + glm::vec3(0, 0, 1e-6f));
    }
    direction = glm::normalize(glm::mix(direction, glm::normalize(wanted), kStep / 0.012f));
    p += kStep * direction;
    // Keep it outside, by a clearance that grows with each step, so that it has no kink.
    for (int repeat = 0; repeat < 2; ++repeat) {
      const glm::vec4 now = bodyDistance(headSdf, p);
      if (now.w < clearance) {
        const float least = std::min(kGuideClearance + 0.0006f, 0.3f * s);
        const float push = std::max(std::min(clearance - now.w, 0.35f * kStep), least - now.w);
        p += push * glm::vec3(now);
      }
    }
    growth.points.push_back(p);
    growth.length = s;
    if (!turnsIn && s > settings.minLength * vary) {
      const float back = glm::smoothstep(1.8f, 2.7f, azimuth(p));
      const float cut = glm::mix(settings.cutHeightFront, settings.cutHeightBack, back);
      if (p.y < cut + 0.006f * random(Cut)) break;
    }
  }
  return growth;
}

}  // namespace

glm::vec3 outOfFace(glm::vec3 p) {
  if (p.y < -0.08f) return p;
  const float edge = faceEdge(p.y) * glm::smoothstep(-0.08f, -0.02f, p.y), at = azimuth(p);
  if (at >= edge) return p;
  const float radius = std::sqrt(p.x * p.x + p.z * p.z);
  return {std::copysign(radius * std::sin(edge), p.x), p.y, radius * std::cos(edge)};
}

void equalLinks(std::span<const glm::vec3> dense, std::span<glm::vec3> points) {
  // Walk with chords of length `link`; true if the polyline is long enough for all of them.
  const auto walk = [&](double link) {
    glm::dvec3 at = dense[0];
    points[0] = dense[0];
    std::size_t segment = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      while (segment + 1 < dense.size() && glm::distance(at, glm::dvec3(dense[segment + 1])) < link)
        ++segment;
      if (segment + 1 >= dense.size()) return false;
      // |a + t e - at| = link, on the segment that leaves the sphere around `at`.
      const glm::dvec3 a = dense[segment], e = glm::dvec3(dense[segment + 1]) - a, d = a - at;
      const double ee = glm::dot(e, e), de = glm::dot(d, e);
      const double root = std::sqrt(std::max(de * de - ee * (glm::dot(d, d) - link * link), 0.0));
      at = a + std::clamp((root - de) / ee, 0.0, 1.0) * e;
      points[i] = at;
    }
    return true;
  };
  double total = 0;
  for (std::size_t i = 1; i < dense.size(); ++i)
    total += glm::distance(glm::dvec3(dense[i - 1]), glm::dvec3(dense[i]));
  double low = 0, high = total / static_cast<double>(points.size() - 1);
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (walk(middle) ? low : high) = middle;
  }
  walk(low);
}

void combGuide(const StyleSettings& settings, const MeshSdf& headSdf, glm::vec3 root,
               glm::vec3 centre, std::uint32_t wisp, std::span<glm::vec3> guide) {
  // Grow it once for its length, and once more with its tip turned in.
  const float length = grow(settings, headSdf, root, centre, wisp, INFINITY).length;
  equalLinks(grow(settings, headSdf, root, centre, wisp, length).points, guide);
}

}  // namespace hair
