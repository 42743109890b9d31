#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/model/comb.h>
#include <libhair/model/fill_wisps.h>
#include <libhair/model/guide_curve.h>

namespace hair {
namespace {

constexpr float kTurn = 2 * std::numbers::pi_v<float>;

enum Use : std::uint16_t {
  HasTip = 0x400,
  HasWhole,
  DeviationAngle,
  DeviationSize,
  DeviationPhase,
  CurlPhase,
  CurlSize,
  CurlPitch,
  StrandPhase,
};

// Barycentric coordinates of p's projection onto a triangle, clamped to slightly outside it:
// farther out, extrapolation would amplify small differences between guides.
glm::vec3 wispWeights(glm::vec3 p, const std::array<glm::vec3, 3>& t) {
  const glm::vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const float d00 = glm::dot(ab, ab), d01 = glm::dot(ab, ac), d11 = glm::dot(ac, ac);
  const float d20 = glm::dot(ap, ab), d21 = glm::dot(ap, ac);
  const float det = d00 * d11 - d01 * d01;
  if (det < 1e-3f * d00 * d11 || det <= 0) return glm::vec3(1.0f / 3);
  glm::vec3 w(0, (d11 * d20 - d01 * d21) / det, (d00 * d21 - d01 * d20) / det);
  w.x = 1 - w.y - w.z;
  const float least = std::min({w.x, w.y, w.z});
  constexpr float kLowest = -0.15f;
  if (least < kLowest)
    w = glm::mix(glm::vec3(1.0f / 3), w, (1.0f / 3 - kLowest) / (1.0f / 3 - least));
  return w / (w.x + w.y + w.z);
}

// Guides of a wisp on the crown may fall to either side of the head. A strand between them would go
// through it, so it follows its main guide alone.
bool guidesPart(const Groom& groom, std::uint32_t wisp) {
  constexpr float kHeadWidth = 0.15f;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto a = groom.guide(3 * wisp + i), b = groom.guide(3 * wisp + (i + 1) % 3);
    for (std::size_t k = 0; k < a.size(); ++k)
      if (glm::distance(a[k], b[k]) > kHeadWidth) return true;
  }
  return false;
}

// Offset of one strand from its wisp, in the frame of its main guide, at the fraction u of its
// length.
glm::vec3 deviation(const StyleSettings& settings, std::uint32_t strand, float u) {
  const auto random = [&](Use use) { return uniform(strand, use, settings.seed); };
  const float angle = kTurn * random(DeviationAngle);
  const glm::vec3 side(std::cos(angle), std::sin(angle), 0);
  glm::vec3 d(0);
  if (random(HasTip) < settings.tipShare) {
    const float tip = std::max(u - 0.6f, 0.0f) / 0.4f;
    d += settings.tipDeviation * (0.3f + 0.7f * random(DeviationSize)) * tip * tip * side;
  }
  if (random(HasWhole) < settings.wholeShare) {
    const float wave =
        std::sin(kTurn * (random(DeviationPhase) + 1.3f * u)) * glm::smoothstep(0.1f, 0.6f, u);
    d += settings.wholeDeviation * (0.4f + 0.6f * random(DeviationSize)) *
         (wave * side + 0.8f * u * glm::vec3(-side.y, side.x, 0));
  }
  return d;
}

// A lock's helix around its guide, widening from nothing at the root.
glm::vec3 curl(const StyleSettings& settings, std::uint32_t lock, std::uint32_t strand,
               float along) {
  const auto ofLock = [&](Use use) { return 2 * uniform(lock, use, settings.seed) - 1; };
  const float pitch = settings.curlPitch * (1 + 0.2f * ofLock(CurlPitch));
  const float radius =
      settings.curlRadius * (1 + 0.3f * ofLock(CurlSize)) * glm::smoothstep(0.005f, 0.06f, along);
  const float jitter = settings.curlJitter * (2 * uniform(strand, StrandPhase, settings.seed) - 1);
  const float angle = kTurn * (along / pitch + ofLock(CurlPhase)) + jitter;
  return radius * glm::vec3(std::cos(angle), std::sin(angle), 0);
}

}  // namespace

void fillWisps(const StyleSettings& settings, const MeshSdf* headSdf, std::uint32_t guidesPerWisp,
               std::span<const glm::vec3> roots, std::span<const std::uint32_t> wisps,
               Groom& groom) {
  const std::size_t strands = roots.size(), n = settings.points;
  groom.first.resize(strands + 1);
  for (std::size_t s = 0; s <= strands; ++s) groom.first[s] = static_cast<std::uint32_t>(s * n);
  groom.parents.resize(strands);
  groom.weights.resize(strands);
  groom.offsets.resize(strands * n);

  // Precompute curves, frames and lengths of the guides, shared by all strands.
  std::vector<glm::vec3> curves(groom.guideCount() * n);
  std::vector<glm::mat3> frames(groom.guideCount() * n);
  std::vector<float> guideLength(groom.guideCount());
  for (std::size_t i = 0; i < groom.guideCount(); ++i) {
    const auto curve = std::span(curves).subspan(i * n, n);
    sampleGuide(groom.guide(i), curve);
    sampleGuideFrames(groom.guide(i), curve, std::span(frames).subspan(i * n, n));
    guideLength[i] = arcLength(groom.guide(i));
  }

  std::vector<std::uint8_t> parted(groom.guideCount() / guidesPerWisp);
  for (std::uint32_t w = 0; guidesPerWisp == 3 && w < parted.size(); ++w)
    parted[w] = guidesPart(groom, w);

  parallelFor(strands, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const auto strand = static_cast<std::uint32_t>(s);
      glm::uvec3 parents =
          guidesPerWisp == 3 ? glm::uvec3(0, 1, 2) + 3 * wisps[s] : glm::uvec3(wisps[s]);
      glm::vec3 w = wispWeights(roots[s], {groom.guide(parents.x)[0], groom.guide(parents.y)[0],
                                           groom.guide(parents.z)[0]});
      // Make the guide of most weight the main one.
      if (w.y > w.x) std::swap(w.x, w.y), std::swap(parents.x, parents.y);
      if (w.z > w.x) std::swap(w.x, w.z), std::swap(parents.x, parents.z);
      if (parted[wisps[s]]) w = glm::vec3(1, 0, 0);
      groom.parents[s] = parents;
      groom.weights[s] = w;

      const glm::vec3* main = &curves[parents.x * n];
      const glm::mat3* mainFrames = &frames[parents.x * n];
      const auto blend = [&](std::size_t k) {
        return w.x * main[k] + w.y * curves[parents.y * n + k] + w.z * curves[parents.z * n + k];
      };
      const glm::vec3 rootOffset = glm::transpose(mainFrames[0]) * (roots[s] - blend(0));
      for (std::size_t k = 0; k < n; ++k) {
        const float u = static_cast<float>(k) / static_cast<float>(n - 1);
        const float clumped = std::min(u / settings.clumpBy, 1.0f);
        const float clump = settings.clump * clumped * std::sqrt(clumped);
        const glm::mat3 frame = mainFrames[k];
        const glm::vec3 base = blend(k);
        glm::vec3 local = glm::mix(1.0f, settings.spread, clumped) * rootOffset;
        local += deviation(settings, strand, u);
        if (settings.curlRadius > 0)
          local += curl(settings, parents.x, strand, u * guideLength[parents.x]);
        glm::vec3 p = glm::mix(base, main[k], clump) + frame * local;
        if (k > 0 && headSdf) {
          const float along = u * guideLength[parents.x];
          p = outOfFace(p);
          const glm::vec4 d = headSdf->distanceAndGradient(p);
          const float clearance = std::min(0.0015f, 0.3f * along);
          if (d.w < clearance) p += (clearance - d.w) * glm::vec3(d);
        }
        groom.offsets[groom.first[s] + k] = glm::transpose(frame) * (p - base);
      }
    }
  });
}

void drawAtRest(const Groom& groom, std::size_t strand, std::span<glm::vec3> points) {
  const glm::uvec3 parents = groom.parents[strand];
  std::vector<glm::vec3> curve(points.size());
  std::vector<glm::mat3> frames(points.size());
  std::fill(points.begin(), points.end(), glm::vec3(0));
  for (int j = 2; j >= 0; --j) {
    sampleGuide(groom.guide(parents[j]), curve);
    for (std::size_t k = 0; k < points.size(); ++k)
      points[k] += groom.weights[strand][j] * curve[k];
  }
  if (groom.offsets.empty()) return;
  sampleGuideFrames(groom.guide(parents.x), curve, frames);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] += frames[k] * groom.offsets[groom.first[strand] + k];
}

}  // namespace hair
