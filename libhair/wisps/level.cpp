#include <libhair/wisps/wisps.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/model/fewer_points.h>
#include <libhair/model/fill_wisps.h>
#include <libhair/wisps/bind.h>

namespace hair {

namespace {

constexpr std::uint32_t kMoment = 0x10d;  // random stream of LevelOfDetail::segmentsOf

std::uint32_t pointsAt(const LevelOfDetail& level, const Groom& groom, std::size_t s) {
  const std::uint32_t segments = groom.first[s + 1] - groom.first[s] - 1;
  return level.segmentsOf(segments, uniform(static_cast<std::uint32_t>(s), kMoment)) + 1;
}

void check(const Groom& groom, const GroomDetail& detail, const LevelOfDetail& level) {
  validate(level);
  require(detail.strandCount() == groom.strandCount(), "level of detail: of a groom of ",
          detail.strandCount(), " strands, but this one has ", groom.strandCount(),
          "; make a GroomDetail of each groom");
}

}  // namespace

void setLevel(const GroomDetail& detail, const LevelOfDetail& level, Wisps& wisps) {
  const Groom& groom = *wisps.groom;
  check(groom, detail, level);
  DrawnPart& drawn = wisps.drawn;
  drawn.level = level;
  if (level.drawsAll()) {
    drawn.first.clear(), drawn.weights.clear();
    drawn.wider = drawn.solid = 1;
    wisps.points.resize(groom.pointCount());
    return;
  }
  const std::size_t strands = groom.strandCount();
  drawn.first.resize(strands + 1);
  drawn.weights.resize(strands);
  // Count what each strand keeps, and the lengths of all, weighted by width, and drawn.
  double all = 0, weighted = 0, seen = 0;
  std::uint32_t points = 0;
  for (std::size_t s = 0; s < strands; ++s) {
    const float weight = level.weightOf(detail.rank[s]);
    const auto length = static_cast<double>(detail.length[s]);
    all += length;
    weighted += static_cast<double>(weight) * length;
    seen += weight > 0 ? length : 0;
    drawn.weights[s] = weight;
    drawn.first[s] = points;
    points += weight > 0 ? pointsAt(level, groom, s) : 0;
  }
  drawn.first[strands] = points;
  // Widen strands so that they cover as much as before, shortened as they are by fewer points.
  drawn.wider =
      weighted > 0 ? static_cast<float>(all / weighted) / detail.lengthKept(level.points) : 1.0f;
  drawn.solid = seen > 0 ? static_cast<float>(weighted / seen) : 1.0f;
  wisps.points.resize(points);
}

void drawEvery(std::uint32_t stride, const Wisps& wisps, StrandSet& out) {
  require(stride > 0, "drawEvery: a stride of 0 strands");
  const Groom& groom = *wisps.groom;
  const std::size_t strands = groom.strandCount();
  out.first.resize(strands + 1);
  std::uint32_t points = 0;
  for (std::size_t s = 0; s < strands; ++s) {
    out.first[s] = points;
    points += s % stride == 0 ? groom.first[s + 1] - groom.first[s] : 0;
  }
  out.first[strands] = points;
  out.points.resize(points);
  parallelFor((strands + stride - 1) / stride, 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) drawWhole(i * stride, wisps, out.strand(i * stride));
  });
}

Groom groomAt(const Groom& groom, const GroomDetail& detail, const LevelOfDetail& level) {
  check(groom, detail, level);
  if (level.drawsAll()) return groom;
  Groom few;
  few.pointsPerGuide = groom.pointsPerGuide;
  few.guidePoints = groom.guidePoints;
  few.tied = groom.tied;
  few.fibre = groom.fibre;
  StrandSet strands;
  std::vector<glm::vec3> whole, kept;
  double all = 0, left = 0;
  for (std::size_t s = 0; s < groom.strandCount(); ++s) {
    all += static_cast<double>(detail.length[s]);
    if (level.weightOf(detail.rank[s]) < 0.5f) continue;
    whole.resize(groom.first[s + 1] - groom.first[s]);
    kept.resize(pointsAt(level, groom, s));
    drawAtRest(groom, s, whole);
    takePoints(whole, kept);
    left += static_cast<double>(arcLength(kept));
    strands.append(kept);
    few.parents.push_back(groom.parents[s]);
    few.weights.push_back(groom.weights[s]);
  }
  few.first = strands.first;
  few.fibre.hairsPerStrand *= left > 0 ? static_cast<float>(all / left) : 1.0f;
  keepShape(strands, few);
  return few;
}

}  // namespace hair
