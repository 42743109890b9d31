#include <libhair/hair_mesh/mesh_groom.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/model/comb.h>
#include <libhair/model/fill_wisps.h>

namespace hair {
namespace {

constexpr std::uint32_t kDense = 4;  // points traced for one of a guide: equal links cut corners

std::uint32_t nearestCurve(const HairMeshRoots& curves, std::uint32_t bundle, glm::vec3 p) {
  std::uint32_t begin = curves.firstRoot[bundle], end = curves.firstRoot[bundle + 1];
  if (begin == end) begin = 0, end = static_cast<std::uint32_t>(curves.rootCount());
  return static_cast<std::uint32_t>(
      std::min_element(curves.positions.begin() + begin, curves.positions.begin() + end,
                       [&](glm::vec3 a, glm::vec3 b) {
                         return glm::dot(a - p, a - p) < glm::dot(b - p, b - p);
                       }) -
      curves.positions.begin());
}

}  // namespace

Groom wispGroom(const HairMesh& mesh, const WispCurveSettings& settings,
                const ScalpDensity& density) {
  const StyleSettings& fill = settings.fill;
  require(settings.curves.points >= 3, "wisps: a curve needs at least 3 points, not ",
          settings.curves.points);
  require(fill.points >= 2, "wisps: a strand needs at least 2 points, not ", fill.points);

  StrandGroup dense = settings.curves;
  dense.points = kDense * (settings.curves.points - 1) + 1;
  const GrownHair curves = growHair(mesh, std::span(&dense, 1), density);
  const HairMeshRoots roots =
      placeRoots(mesh, {.strands = fill.strands, .seed = fill.seed}, density);
  require(curves.strands.strandCount() > 0 && roots.rootCount() > 0, "wisps: ", roots.rootCount(),
          " strands of ", curves.strands.strandCount(), " curves; take one or more of both");

  Groom groom;
  groom.pointsPerGuide = settings.curves.points;
  groom.guidePoints.resize(curves.strands.strandCount() * groom.pointsPerGuide);
  parallelFor(curves.strands.strandCount(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t w = begin; w < end; ++w)
      equalLinks(
          curves.strands.strand(w),
          std::span(groom.guidePoints).subspan(w * groom.pointsPerGuide, groom.pointsPerGuide));
  });
  std::vector<std::uint32_t> wisps(roots.rootCount());
  parallelFor(wisps.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r)
      wisps[r] = nearestCurve(curves.roots[0], roots.bundle[r], roots.positions[r]);
  });
  fillWisps(fill, nullptr, 1, roots.positions, wisps, groom);
  groom.fibre.hairsPerStrand = std::max(1.0f, fill.hairs / static_cast<float>(roots.rootCount()));
  return groom;
}

}  // namespace hair
