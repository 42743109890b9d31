#include <libhair/model/groom.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>

namespace hair {

void validateGuides(const Groom& groom) {
  const std::uint32_t n = groom.pointsPerGuide;
  require(!groom.guidePoints.empty(), "groom: no guides");
  require(n >= 2 && n <= kMaxGuidePoints, "groom: ", n, " points a guide is not in 2 to ",
          kMaxGuidePoints, "; sample guides at fewer points (BindSettings::pointsPerGuide)");
  require(groom.guideCount() > 0 && groom.guidePoints.size() % n == 0,
          "groom: ", groom.guidePoints.size(), " guide points are no whole number of guides of ", n,
          " points");
  require(groom.tied.empty() || groom.tied.size() == groom.guideCount(), "groom: ties of ",
          groom.tied.size(), " guides, but there are ", groom.guideCount());
  for (std::size_t g = 0; g < groom.guideCount(); ++g) {
    const auto points = groom.guide(g);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const float length = glm::distance(points[i], points[i + 1]);
      require(length > 1e-6f && length < 1e5f, "groom: guide ", g, " link ", i, " has length ",
              length, " m, not in 1e-6 to 1e5; drop degenerate strands or check the scale");
    }
    require(glm::dot(points[0], points[0]) < 1e16f, "groom: guide ", g,
            ": its root is not finite, or beyond 1e8 m");
  }
}

void validateStrands(const Groom& groom) {
  const std::size_t strands = groom.strandCount();
  require(groom.first.size() == strands + 1 && groom.weights.size() == strands, "groom: ", strands,
          " strands, but ", groom.first.size(), " offsets and ", groom.weights.size(), " weights");
  require(groom.first.front() == 0, "groom: strands start at point ", groom.first.front(),
          ", not 0");
  for (std::size_t s = 0; s < strands; ++s) {
    require(groom.first[s] <= groom.first[s + 1] && groom.first[s + 1] - groom.first[s] >= 2,
            "groom: strand ", s, " has fewer than 2 points");
    for (int j = 0; j < 3; ++j)
      require(groom.parents[s][j] < groom.guideCount(), "groom: strand ", s, " follows guide ",
              groom.parents[s][j], " of ", groom.guideCount());
    const glm::vec3 w = groom.weights[s];
    require(std::abs(w.x + w.y + w.z - 1) < 1e-3f && glm::dot(w, w) < 1e6f,
            "groom: weights of strand ", s, " are (", w.x, ", ", w.y, ", ", w.z,
            "); they must sum to 1, and none may be beyond 1000");
  }
  require(groom.offsets.empty() || groom.offsets.size() == groom.pointCount(),
          "groom: ", groom.pointCount(), " points, but ", groom.offsets.size(), " offsets");
  for (std::size_t p = 0; p < groom.offsets.size(); ++p)
    require(glm::dot(groom.offsets[p], groom.offsets[p]) < 1e10f, "groom: offset of point ", p,
            " is (", groom.offsets[p].x, ", ", groom.offsets[p].y, ", ", groom.offsets[p].z,
            ") m: not finite, or beyond 1e5 m");
}

void validate(const Groom& groom) {
  const Fibre& f = groom.fibre;
  require(f.width >= 0 && f.opacity >= 0 && f.hairsPerStrand >= 0 &&
              std::isfinite(f.width * f.opacity * f.hairsPerStrand),
          "groom: fibre width ", f.width, " m, opacity ", f.opacity, " or ", f.hairsPerStrand,
          " hairs a strand is negative or not finite");
  validateGuides(groom);
  validateStrands(groom);
}

float longestGuide(const Groom& groom) {
  float longest = 0;
  for (std::size_t g = 0; g < groom.guideCount(); ++g)
    longest = std::max(longest, arcLength(groom.guide(g)));
  return longest;
}

}  // namespace hair
