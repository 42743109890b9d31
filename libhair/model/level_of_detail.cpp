#include <libhair/model/level_of_detail.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/model/fewer_points.h>
#include <libhair/model/fill_wisps.h>

namespace hair {

namespace {

constexpr float kSharesAHalving = 8;

// Spreads ten bits to every third bit of 30.
std::uint32_t spreadBits(std::uint32_t v) {
  v = (v | v << 16) & 0x030000ffu;
  v = (v | v << 8) & 0x0300f00fu;
  v = (v | v << 4) & 0x030c30c3u;
  return (v | v << 2) & 0x09249249u;
}

// Index of a root on the Morton curve through the box (Morton 1966).
std::uint32_t placeOnCurve(glm::vec3 p, const Bounds& box) {
  const glm::vec3 size = glm::max(box.size(), glm::vec3(1e-9f));
  const glm::uvec3 q(glm::clamp((p - box.lower) / size, 0.0f, 1.0f) * 1023.0f);
  return spreadBits(q.x) | spreadBits(q.y) << 1 | spreadBits(q.z) << 2;
}

// 0, 1/2, 1/4, 3/4, 1/8 ...: every prefix of the sequence is evenly distributed.
float vanDerCorput(std::uint32_t i) {
  std::uint32_t reversed = 0;
  for (int bit = 0; bit < 32; ++bit) reversed |= (i >> bit & 1u) << (31 - bit);
  return static_cast<float>(reversed >> 8) * 0x1p-24f;
}

std::vector<float> ranksOf(std::span<const glm::vec3> roots) {
  const Bounds box = bounds(roots);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order(roots.size());
  for (std::uint32_t s = 0; s < roots.size(); ++s) order[s] = {placeOnCurve(roots[s], box), s};
  std::sort(order.begin(), order.end());
  std::vector<float> rank(roots.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i].second] = vanDerCorput(i);
  return rank;
}

glm::vec3 pointAt(std::span<const glm::vec3> points, float at) {
  const std::size_t i = std::min(static_cast<std::size_t>(at), points.size() - 2);
  return points[i] + (at - static_cast<float>(i)) * (points[i + 1] - points[i]);
}

// Error and length of a strand with fewer segments.
struct Reduced {
  double squares = 0;  // of its points' distances, summed up
  double length = 0;
};

Reduced reduce(std::span<const glm::vec3> points, std::uint32_t segments) {
  const auto all = static_cast<float>(points.size() - 1), some = static_cast<float>(segments);
  std::vector<glm::vec3> kept(segments + 1);
  takePoints(points, kept);
  Reduced r;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const glm::vec3 d = points[k] - pointAt(kept, static_cast<float>(k) * (some / all));
    r.squares += static_cast<double>(glm::dot(d, d));
  }
  r.length = static_cast<double>(arcLength(kept));
  return r;
}

bool positive(float x) {
  return x > 0 && std::isfinite(x);
}

// Position of a share of points in the table: entry and fraction.
float entryOf(float points, std::size_t entries) {
  return std::clamp(-kSharesAHalving * std::log2(std::max(points, 1e-30f)), 0.0f,
                    static_cast<float>(entries - 1));
}

float look(std::span<const float> table, float at) {
  const std::size_t i = std::min(static_cast<std::size_t>(at), table.size() - 2);
  return table[i] + (at - static_cast<float>(i)) * (table[i + 1] - table[i]);
}

}  // namespace

float LevelOfDetail::weightOf(float rank) const {
  if (strands >= 1) return 1;
  return std::clamp((1 + fade - rank / strands) / fade, 0.0f, 1.0f);
}

std::uint32_t LevelOfDetail::segmentsOf(std::uint32_t segments, float moment) const {
  if (points >= 1) return segments;
  const auto some = static_cast<std::uint32_t>(points * static_cast<float>(segments) + moment);
  return std::min(std::max(some, 2u), segments);
}

void validate(const LevelOfDetail& level) {
  validateFields(level, "level of detail");
}

GroomDetail::GroomDetail(const Groom& groom) : fibreWidth(groom.fibre.width) {
  const std::size_t strands = groom.strandCount();
  require(groom.first.size() == strands + 1 && groom.pointCount() >= 2 * strands,
          "level of detail: the groom has ", strands, " strands but ", groom.first.size(),
          " offsets, or strands of fewer than 2 points");
  std::vector<glm::vec3> roots(strands);
  length.resize(strands);
  // A sample of about 1024 strands represents all.
  const std::size_t step = strands / 1024 + 1;
  std::vector<std::array<Reduced, kShares>> some(strands / step + 1);
  parallelFor(strands, 64, [&](std::size_t begin, std::size_t end) {
    std::vector<glm::vec3> points;
    for (std::size_t s = begin; s < end; ++s) {
      points.resize(groom.first[s + 1] - groom.first[s]);
      drawAtRest(groom, s, points);
      roots[s] = points.front();
      length[s] = arcLength(points);
      if (s % step != 0) continue;
      const auto segments = static_cast<std::uint32_t>(points.size() - 1);
      for (std::size_t i = 0; i < kShares; ++i) {
        const float share = std::exp2(-static_cast<float>(i) / kSharesAHalving);
        // The mean over the moments at which strands change.
        const float exact = share * static_cast<float>(segments);
        const float part = i > 0 ? exact - std::floor(exact) : 0.0f;
        LevelOfDetail level;
        level.points = share;
        const Reduced few = reduce(points, level.segmentsOf(segments, 0)),
                      more = reduce(points, level.segmentsOf(segments, std::nextafter(1.0f, 0.0f)));
        Reduced& r = some[s / step][i];
        const auto t = static_cast<double>(part);
        r.squares = ((1 - t) * few.squares + t * more.squares) / static_cast<double>(points.size());
        r.length = (1 - t) * few.length + t * more.length;
      }
    }
  });
  rank = ranksOf(roots);
  for (auto& table : some) table[0].squares = 0;  // of rounding
  for (std::size_t i = 0; i < kShares; ++i) {
    double squares = 0, kept = 0, whole = 0;
    for (const auto& table : some) {
      squares += table[i].squares;
      kept += table[i].length;
      whole += table[0].length;
    }
    const double count = std::ceil(static_cast<double>(strands) / static_cast<double>(step));
    deviation_[i] = count > 0 ? static_cast<float>(std::sqrt(squares / count)) : 0.0f;
    lengthKept_[i] = whole > 0 ? static_cast<float>(kept / whole) : 1.0f;
    // Make the table monotonic, which look-ups need; only chance makes fewer points more accurate.
    if (i > 0) deviation_[i] = std::max(deviation_[i], deviation_[i - 1]);
  }
}

float GroomDetail::deviation(float points) const {
  return look(deviation_, entryOf(points, kShares));
}

float GroomDetail::lengthKept(float points) const {
  return look(lengthKept_, entryOf(points, kShares));
}

float GroomDetail::pointsFor(float deviation) const {
  // Ignore deviations up to half a hair's width; subtract it, so that there is no visible step.
  const float off = std::max(deviation - 0.5f * fibreWidth, 0.0f);
  const auto above = std::upper_bound(deviation_.begin(), deviation_.end(), off);
  if (above == deviation_.begin()) return 1;
  const auto i = static_cast<float>(above - deviation_.begin() - 1);
  float at = i;
  if (above != deviation_.end()) at += (off - *(above - 1)) / (*above - *(above - 1));
  return off > 0 ? std::exp2(-at / kSharesAHalving) : 1.0f;
}

float headPixels(float distance, float fieldOfView, float pictureHeight) {
  require(positive(distance), "level of detail: a head ", distance,
          " m away; the distance is positive");
  require(fieldOfView > 0 && fieldOfView < std::numbers::pi_v<float>,
          "level of detail: fieldOfView = ", fieldOfView, " is not in (0, pi) radians");
  require(positive(pictureHeight), "level of detail: a picture ", pictureHeight, " pixels high");
  return pictureHeight * kHeadHeight / (2 * distance * std::tan(0.5f * fieldOfView));
}

LevelOfDetail levelFor(const GroomDetail& detail, float pixels, float importance,
                       const DetailSettings& settings) {
  require(positive(pixels), "level of detail: a head ", pixels,
          " pixels high; a head that is not seen needs no level: do not draw it");
  require(importance > 0 && importance <= 1, "level of detail: importance = ", importance,
          " is not in (0, 1]");
  require(positive(settings.strandsPerPixel) && positive(settings.pixelsOff) &&
              settings.pixelsPerCell >= 0 && std::isfinite(settings.pixelsPerCell),
          "detail settings: ", settings.strandsPerPixel, " strands per pixel, ", settings.pixelsOff,
          " pixels off or ", settings.pixelsPerCell, " pixels per cell are not positive numbers");
  const float seen = pixels * importance;
  const float pixel = kHeadHeight / seen;
  const auto all = static_cast<float>(std::max<std::size_t>(detail.strandCount(), 1));
  LevelOfDetail level;
  // Keeps the number of strands a pixel, and so the noise of omitted strands, constant at any size.
  level.strands = std::min(std::max(settings.strandsPerPixel * seen, 1.0f) / all, 1.0f);
  level.fade = settings.fade;
  level.points = detail.pointsFor(settings.pixelsOff * pixel);
  level.cellSize = std::min(settings.pixelsPerCell * pixel, 1e6f);
  validate(level);
  return level;
}

}  // namespace hair
