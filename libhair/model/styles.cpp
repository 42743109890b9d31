#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/core/transform.h>
#include <libhair/model/comb.h>
#include <libhair/model/fill_wisps.h>
#include <libhair/model/scalp_roots.h>
#include <libhair/model/styles.h>

namespace hair {
namespace {

constexpr std::uint32_t kTriangleTurn = 0x300;  // use of a random number

// Three roots around a wisp's centre: as far apart as its cell is wide, on the scalp, on the
// centre's side of the parting.
void placeGuideRoots(const StyleSettings& settings, const MeshSdf& headSdf, glm::vec3 centre,
                     float cellRadius, std::uint32_t wisp, std::span<glm::vec3, 3> roots) {
  const glm::vec3 n(headSdf.distanceAndGradient(centre));
  const glm::vec3 u = anyNormal(n), v = glm::cross(n, u);
  const float turn = 2 * std::numbers::pi_v<float> * uniform(wisp, kTriangleTurn, settings.seed);
  const glm::vec3 away = awayFromParting(settings.parting, centre);
  for (std::size_t k = 0; k < 3; ++k) {
    const float angle = turn + 2 * std::numbers::pi_v<float> * static_cast<float>(k) / 3;
    float radius = 0.85f * cellRadius;
    do {
      roots[k] = onScalp(headSdf, centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
      radius *= 0.8f;
    } while (radius > 0.1f * cellRadius &&
             (scalpMask(roots[k]) < 0.5f ||
              glm::dot(awayFromParting(settings.parting, roots[k]), away) < 0.2f));
  }
}

}  // namespace

StyleSettings styleSettings(Style style) {
  StyleSettings s;
  if (style == Style::Curly) {
    s.points = 61;
    s.cutHeightFront = -0.045f, s.cutHeightBack = -0.1f;
    s.minLength = 0.13f, s.maxLength = 0.33f, s.lengthVariation = 0.1f;
    s.volume = 0.034f, s.rootLift = 0.4f, s.waviness = 0.2f, s.turnIn = 0;
    s.clump = 0.85f, s.clumpBy = 0.5f, s.spread = 0.3f;
    s.partingJitter = 0.02f, s.partAtShoulders = 0;
    s.curlRadius = 0.009f, s.curlPitch = 0.035f;
  } else if (style == Style::Long) {
    s.pointsPerGuide = 28;
    s.points = 41;
    s.cutHeightFront = -0.36f, s.cutHeightBack = -0.42f;
    s.minLength = 0.4f, s.maxLength = 0.7f;
    s.volume = 0.018f, s.waviness = 0.14f, s.turnIn = 0.15f;
  }
  return s;
}

Groom makeGroom(const StyleSettings& settings, const MeshSdf& headSdf) {
  validateFields(settings, "style");
  require(settings.strands >= settings.wisps, "style: ", settings.strands, " strands cannot fill ",
          settings.wisps, " wisps; draw more strands or take fewer wisps");
  require(settings.maxLength >= settings.minLength, "style: lengths from ", settings.minLength,
          " m to ", settings.maxLength, " m; take minLength <= maxLength");

  // Roots, and which wisp each belongs to.
  const auto roots = scalpRoots(headSdf, settings.strands, settings.seed);
  const WispCells cells =
      wispCells(headSdf, roots, settings.wisps, settings.parting, settings.seed);
  std::vector<float> cellRadius(settings.wisps, 0.004f);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    float& radius = cellRadius[cells.wisp[i]];
    radius = std::max(radius, glm::distance(roots[i], cells.centres[cells.wisp[i]]));
  }

  // Guides.
  Groom groom;
  groom.pointsPerGuide = settings.pointsPerGuide;
  groom.guidePoints.resize(std::size_t{settings.wisps} * 3 * settings.pointsPerGuide);
  parallelFor(settings.wisps, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t w = begin; w < end; ++w) {
      const auto wisp = static_cast<std::uint32_t>(w);
      std::array<glm::vec3, 3> guideRoots;
      placeGuideRoots(settings, headSdf, cells.centres[w], cellRadius[w], wisp, guideRoots);
      for (std::size_t k = 0; k < 3; ++k)
        combGuide(settings, headSdf, guideRoots[k], cells.centres[w], wisp,
                  std::span(groom.guidePoints)
                      .subspan((3 * w + k) * settings.pointsPerGuide, settings.pointsPerGuide));
    }
  });

  fillWisps(settings, &headSdf, 3, roots, cells.wisp, groom);
  groom.fibre.hairsPerStrand =
      std::max(1.0f, settings.hairs / static_cast<float>(settings.strands));
  return groom;
}

}  // namespace hair
