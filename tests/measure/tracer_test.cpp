#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/measure/shadow/truth.h>

#include "hair_samples.h"

namespace hair {
namespace {

using test::crossings;
using test::randomDirection;
using test::randomPoint;

constexpr float kWidth = 1e-3f;
const Fibre kFibre{kWidth / 4, 0.5f, 4};  // four hairs a strand

/// The law again, obvious and slow: all segments of all strands, strand by strand.
std::uint32_t crossingsByHand(StrandView strands, double width, const ShadowRay& ray) {
  const glm::dvec3 d = glm::normalize(glm::dvec3(ray.toLight));
  std::uint32_t count = 0;
  for (std::uint32_t s = 0; s < strands.strandCount(); ++s) {
    if (s == ray.strand) continue;
    std::vector<glm::dvec3> points;
    for (const glm::vec3 p : strands.strand(s))
      if (points.empty() || glm::dvec3(p) != points.back()) points.emplace_back(p);
    bool before = false;
    glm::dvec3 wayBefore(0);
    double footBefore = 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      // The segment with its part along the ray taken away.
      const glm::dvec3 a = points[k] - glm::dvec3(ray.origin), b = points[k + 1] - points[k];
      const glm::dvec3 from = a - glm::dot(a, d) * d, way = b - glm::dot(b, d) * d;
      const double foot = -glm::dot(from, way) / glm::dot(way, way);
      const double t = std::min(std::max(foot, 0.0), 1.0);
      const double depth = glm::dot(a + t * b, d);
      const bool square = (k == 0 && foot < 0) || (k + 2 == points.size() && foot > 1);
      const bool met = !square && glm::length(from + t * way) < 0.5 * width && depth > 0 &&
                       depth < static_cast<double>(ray.length);
      const bool turned = glm::dot(wayBefore, way) < 0 && footBefore < 1 && foot > 0;
      if (met && (!before || turned)) ++count;
      before = met, wayBefore = way, footBefore = foot;
    }
  }
  return count;
}

TEST(GridTracer, AStraightFibreIsCrossedWhereItIsAndNotBesideIt) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{0, 1, 0}, {0.02f, 1, 0}});
  const auto tracer = makeGridTracer(strands, kFibre);
  const glm::vec3 up(0, 1, 0);
  EXPECT_EQ(crossings(*tracer, {0.01f, 0, 0}, up), 1u);
  for (float side : {-1.0f, 1.0f}) {
    EXPECT_EQ(crossings(*tracer, {0.01f, 0, side * 0.49f * kWidth}, up), 1u);
    EXPECT_EQ(crossings(*tracer, {0.01f, 0, side * 0.51f * kWidth}, up), 0u);
  }
  // Its ends are square.
  EXPECT_EQ(crossings(*tracer, {1e-6f, 0, 0.49f * kWidth}, up), 1u);
  EXPECT_EQ(crossings(*tracer, {-1e-6f, 0, 0}, up), 0u);
  EXPECT_EQ(crossings(*tracer, {0.02f - 1e-6f, 0, 0.49f * kWidth}, up), 1u);
  EXPECT_EQ(crossings(*tracer, {0.02f + 1e-6f, 0, 0}, up), 0u);
  // It faces the ray: as wide from everywhere.
  for (float angle = 0; angle < 3; angle += 0.1f) {
    const glm::vec3 way(0, std::cos(angle), std::sin(angle)), side(0, way.z, -way.y);
    const glm::vec3 middle(0.01f, 1, 0);
    EXPECT_EQ(crossings(*tracer, middle - 0.3f * way + 0.49f * kWidth * side, way), 1u);
    EXPECT_EQ(crossings(*tracer, middle - 0.3f * way + 0.51f * kWidth * side, way), 0u);
  }
}

TEST(GridTracer, HairBehindTheOriginOrTheLightDoesNotCount) {
  StrandSet strands;
  for (float y : {1.0f, 2.0f, 3.0f})
    strands.append(std::vector<glm::vec3>{{-0.01f, y, 0}, {0, y, 0}, {0.01f, y, 0}});
  const auto tracer = makeGridTracer(strands, kFibre);
  const glm::vec3 up(0, 1, 0);
  const float before[] = {0, 0.999f, 1.001f, 2.001f, 3.001f};
  const std::uint32_t expected[] = {3, 3, 2, 1, 0};
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(crossings(*tracer, {0.001f, before[k], 0}, up), expected[k]) << k;
    EXPECT_EQ(crossings(*tracer, {0.001f, 4 - before[k], 0}, -up), expected[k]) << k;
  }
  EXPECT_EQ(crossings(*tracer, {0, 0, 0}, up, kNoStrand, 2.999f), 2u);
  EXPECT_EQ(crossings(*tracer, {0, 0, 0}, up, kNoStrand, 3.001f), 3u);
  EXPECT_EQ(crossings(*tracer, {0, 1.5f, 0}, up, kNoStrand, 1.0f), 1u);
  // A fibre through the origin is not between it and the light.
  EXPECT_EQ(crossings(*tracer, {0, 1, 0}, up), 2u);
}

TEST(GridTracer, OwnStrandIsExcluded) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{-0.01f, 1, 0}, {0.01f, 1, 0}});
  strands.append(std::vector<glm::vec3>{{5, 5, 5}});  // no segment, but a number
  strands.append(std::vector<glm::vec3>{{0, 2, -0.01f}, {0, 2, 0.01f}, {0, 2.1f, 0.01f}});
  const auto tracer = makeGridTracer(strands, kFibre);
  const glm::vec3 up(0, 1, 0);
  EXPECT_EQ(crossings(*tracer, {0, 0, 0}, up), 2u);
  EXPECT_EQ(crossings(*tracer, {0, 0, 0}, up, 0), 1u);
  EXPECT_EQ(crossings(*tracer, {0, 0, 0}, up, 1), 2u);
  EXPECT_EQ(crossings(*tracer, {0, 0, 0}, up, 2), 1u);
  EXPECT_EQ(crossings(*tracer, {0, 1.5f, 0}, up, 2), 0u);
}

// Bends of every angle up to a right angle, links longer and shorter than the fibre is wide.
TEST(GridTracer, ABentStrandIsCrossedExactlyOnceEverywhereAlongIt) {
  for (float link : {10.0f, 2.0f, 0.6f, 0.2f}) {
    for (int zigzag = 0; zigzag < 2; ++zigzag) {
      // Level, seen from below: bends grow from joint to joint. One turns to and fro, the other
      // winds up as a spiral that never comes near its own beginning.
      std::vector<glm::vec3> points{{0, 1, 0}};
      float heading = 0;
      for (int k = 0; k < 30; ++k) {
        const float bend = zigzag ? 1.5f * static_cast<float>(k) / 30.0f : 0.05f;
        heading += zigzag && k % 2 ? -bend : bend;
        points.push_back(points.back() +
                         link * kWidth * glm::vec3(std::cos(heading), 0, std::sin(heading)));
      }
      StrandSet strands;
      strands.append(points);
      const auto tracer = makeGridTracer(strands, kFibre);
      std::vector<ShadowRay> rays;
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const glm::vec3 way = glm::normalize(points[k + 1] - points[k]);
        const glm::vec3 side(-way.z, 0, way.x);
        for (int along = 0; along <= 40; ++along)
          for (float off : {0.0f, 0.2f, -0.2f, 0.45f, -0.45f}) {
            // Both ends are cut: stay inside of them.
            if ((k == 0 && along == 0) || (k + 2 == points.size() && along == 40)) continue;
            const float t = static_cast<float>(along) / 40;
            rays.push_back(
                {glm::mix(points[k], points[k + 1], t) + off * kWidth * side - glm::vec3(0, 1, 0),
                 {0, 1, 0},
                 INFINITY,
                 kNoStrand});
          }
      }
      const std::vector<std::uint32_t> counts = crossings(*tracer, rays);
      std::size_t wrong = 0;
      for (const std::uint32_t c : counts) wrong += c != 1;
      EXPECT_EQ(wrong, 0u) << "of " << rays.size() << ", link " << link << ", zigzag " << zigzag;
    }
  }
}

TEST(GridTracer, TheOuterSideOfABendHasNoGapAndNoSpike) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{-0.02f, 1, 0}, {0, 1, 0}, {0, 1, 0.02f}});
  const auto tracer = makeGridTracer(strands, kFibre);
  for (float angle = -1.57f; angle < 0; angle += 0.05f) {
    const glm::vec3 out(std::cos(angle), 0, std::sin(angle));
    EXPECT_EQ(crossings(*tracer, 0.49f * kWidth * out, {0, 1, 0}), 1u) << angle;
    EXPECT_EQ(crossings(*tracer, 0.51f * kWidth * out, {0, 1, 0}), 0u) << angle;
  }
}

TEST(GridTracer, AStrandThatTurnsBackIsCrossedOnEachLeg) {
  StrandSet strands;
  // As seen from below its legs lie on each other; they are 1 cm apart.
  strands.append(std::vector<glm::vec3>{{0, 1, 0}, {0.02f, 1.005f, 0}, {0, 1.01f, 0}});
  const auto tracer = makeGridTracer(strands, kFibre);
  EXPECT_EQ(crossings(*tracer, {0.01f, 0, 0}, {0, 1, 0}), 2u);
  EXPECT_EQ(crossings(*tracer, {0.01f, 1.005f, 0}, {0, 1, 0}), 1u);
  // Beyond the bend there is but the bend.
  EXPECT_EQ(crossings(*tracer, {0.02f + 0.4f * kWidth, 0, 0}, {0, 1, 0}), 1u);
}

TEST(GridTracer, CrossesWhatBruteForceCrosses) {
  struct Case {
    const char* name;
    std::uint32_t strands, points;
    float step, bend, half;
    glm::vec3 centre;
  };
  const Case cases[] = {{"waving", 300, 12, 0.02f, 0.3f, 0.05f, {0, 0, 0}},
                        {"crumpled", 200, 30, 0.004f, 3.0f, 0.02f, {0, 0, 0}},
                        {"long and few", 100, 3, 1.0f, 0.2f, 0.3f, {0, 0, 0}},
                        {"far from the origin", 100, 12, 0.02f, 0.5f, 0.05f, {900, -400, 300}}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    StrandSet strands = test::randomStrands(c.strands, c.points, c.step, c.bend, c.half);
    for (glm::vec3& p : strands.points) p += c.centre;
    const auto tracer = makeGridTracer(strands, kFibre);
    std::uint64_t total = 0;
    const auto check = [&](const std::vector<ShadowRay>& rays) {
      const std::vector<std::uint32_t> counts = crossings(*tracer, rays);
      std::size_t different = 0;
      for (std::size_t r = 0; r < rays.size(); ++r) {
        const std::uint32_t expected =
            crossingsByHand(strands, static_cast<double>(kFibre.width) * 4, rays[r]);
        different += counts[r] != expected;
        total += expected;
      }
      EXPECT_EQ(different, 0u) << "of " << rays.size();
    };
    // Rays of any direction, and some along the axes, from inside and from outside.
    std::vector<ShadowRay> rays;
    for (std::uint32_t r = 0; r < 1200; ++r) {
      glm::vec3 way = randomDirection(r, 1);
      if (r % 16 == 0) way = {r % 32 ? 1 : -1, 0, 0};
      if (r % 16 == 1) way = {0, r % 32 > 1 ? 1 : -1, 0};
      if (r % 16 == 2) way = {0, 0, r % 32 > 2 ? 1 : -1};
      glm::vec3 origin = c.centre + randomPoint(c.half, r, 2);
      if (r % 4 == 0) origin -= 3 * c.half * way;
      rays.push_back({origin, way, r % 3 ? INFINITY : 2 * c.half * uniform(r, 7),
                      r % 5 ? kNoStrand : r % c.strands});
    }
    check(rays);
    // And parallel ones, which go another way through the code.
    for (glm::vec3 way : {glm::normalize(glm::vec3(0.5f, -0.8f, 0.35f)), glm::vec3(0, 0, -1)}) {
      for (ShadowRay& ray : rays) ray.toLight = way;
      check(rays);
    }
    // Along the strands: what is seen of a segment is often shorter than it is wide.
    for (std::uint32_t r = 0; r < rays.size(); ++r) {
      const auto points = strands.strand(r % c.strands);
      const std::size_t k = r % (points.size() - 1);
      if (points[k + 1] == points[k]) continue;
      rays[r].toLight = glm::normalize(points[k + 1] - points[k] + 1e-4f * randomDirection(r, 50));
      rays[r].origin = points[k] + 0.3f * kWidth * randomDirection(r, 60);
    }
    check(rays);
    EXPECT_GT(total, 500u);
  }
}

TEST(GridTracer, FewRaysAreTracedAsManyAre) {
  const StrandSet strands = test::randomStrands(300, 12, 0.02f, 0.3f, 0.05f);
  const glm::vec3 way = randomDirection(5, 5);
  std::vector<ShadowRay> rays;
  for (std::uint32_t r = 0; r < 2000; ++r)
    rays.push_back({randomPoint(0.05f, r, 2), way, INFINITY, kNoStrand});
  const auto many = crossings(*makeGridTracer(strands, kFibre), rays);
  const auto tracer = makeGridTracer(strands, kFibre);  // has not seen that direction yet
  for (std::size_t r = 0; r < rays.size(); r += 7)
    ASSERT_EQ(crossings(*tracer, rays[r].origin, way), many[r]);
}

TEST(GridTracer, ThreadsDoNotChangeWhatIsCrossed) {
  const StrandSet strands = test::randomStrands(300, 12, 0.02f, 0.3f, 0.05f);
  for (bool parallel : {false, true}) {
    std::vector<ShadowRay> rays;
    for (std::uint32_t r = 0; r < 5000; ++r)
      rays.push_back(
          {randomPoint(0.05f, r, 2), randomDirection(parallel ? 0 : r, 1), INFINITY, kNoStrand});
    std::vector<std::vector<std::uint32_t>> results;
    for (int threads : {1, 2, 5}) {
      const ThreadLimit limit(threads);
      results.push_back(crossings(*makeGridTracer(strands, kFibre), rays));
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
  }
}

TEST(GridTracer, NoHairAndHairWithoutLengthAreNotCrossed) {
  StrandSet strands;
  EXPECT_EQ(crossings(*makeGridTracer(strands, kFibre), {0, 0, 0}, {0, 1, 0}), 0u);
  strands.append(std::vector<glm::vec3>{{0, 1, 0}, {0, 1, 0}});
  strands.append(std::vector<glm::vec3>{});
  EXPECT_EQ(crossings(*makeGridTracer(strands, kFibre), {0, 0, 0}, {0, 1, 0}), 0u);
  // Points that repeat others change nothing.
  strands.append(std::vector<glm::vec3>{{-1, 1, 0}, {-1, 1, 0}, {0, 1, 0}, {0, 1, 0}, {1, 1, 0}});
  EXPECT_EQ(crossings(*makeGridTracer(strands, kFibre), {0, 0, 0}, {0, 1, 0}), 1u);
}

TEST(GridTracer, BadArgumentsAreErrors) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{-1, 1, 0}, {1, 1, 0}});
  EXPECT_THROW(makeGridTracer(strands, Fibre{0, 0.5f, 1}), Error);
  EXPECT_THROW(makeGridTracer(strands, Fibre{1e-4f, 0.5f, -1}), Error);
  EXPECT_THROW(makeGridTracer(strands, Fibre{NAN, 0.5f, 1}), Error);
  const auto tracer = makeGridTracer(strands, kFibre);
  EXPECT_THROW(crossings(*tracer, {0, 0, 0}, {0, 0, 0}), Error);
  EXPECT_THROW(crossings(*tracer, {0, 0, 0}, {0, NAN, 0}), Error);
  EXPECT_THROW(crossings(*tracer, {NAN, 0, 0}, {0, 1, 0}), Error);
  std::vector<ShadowRay> rays(2, {{0, 0, 0}, {0, 1, 0}, INFINITY, kNoStrand});
  std::vector<std::uint32_t> counts(1);
  EXPECT_THROW(tracer->countCrossings(rays, counts), Error);
  strands.points[0].x = NAN;
  EXPECT_THROW(makeGridTracer(strands, kFibre), Error);
}

}  // namespace
}  // namespace hair
