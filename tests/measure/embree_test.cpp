#include <filesystem>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/files/strand_file.h>
#include <libhair/measure/embree/embree_tracer.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/fill_wisps.h>
#include <libhair/model/styles.h>

#include "hair_samples.h"

namespace hair {
namespace {

const LightSpace kSlanted = makeLightSpace({0.5f, -0.8f, 0.35f});

/// Rays towards the light from a disc of 3 mm around each point, and some that go anywhere.
std::vector<ShadowRay> raysFrom(const std::vector<SamplePoint>& points, bool parallel) {
  std::vector<ShadowRay> rays;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    for (std::uint32_t k = 0; k < 32; ++k)
      rays.push_back({points[i].position + test::randomPoint(3e-3f, i, 3 * k),
                      parallel ? -kSlanted.direction() : test::randomDirection(i, k), INFINITY,
                      points[i].strand});
  return rays;
}

void expectAgreement(const StrandSet& strands, const Fibre& fibre) {
  const auto grid = makeGridTracer(strands, fibre), embree = makeEmbreeTracer(strands, fibre);
  const auto points = chooseSamplePoints(strands, 200, 1);
  for (bool parallel : {true, false}) {
    const std::vector<ShadowRay> rays = raysFrom(points, parallel);
    const auto one = test::crossings(*grid, rays), other = test::crossings(*embree, rays);
    std::size_t different = 0;
    std::uint64_t sum = 0;
    for (std::size_t r = 0; r < rays.size(); ++r) {
      different += one[r] != other[r];
      sum += one[r];
    }
    const double n = static_cast<double>(rays.size());
    EXPECT_LT(static_cast<double>(different), 5e-4 * n) << (parallel ? "parallel" : "any way");
    EXPECT_GT(static_cast<double>(sum), 2 * n);
  }
  const Truth a = exactTransmittance(*grid, fibre, kSlanted, points, {.rays = 256});
  const Truth b = exactTransmittance(*embree, fibre, kSlanted, points, {.rays = 256});
  double difference = 0, variance = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double e = static_cast<double>(a.standardError[i]);
    difference += static_cast<double>(b.transmittance[i]) - static_cast<double>(a.transmittance[i]);
    variance += e * e;
  }
  EXPECT_LT(std::abs(difference), 0.1 * std::sqrt(variance));
}

TEST(EmbreeTracer, AgreesWithTheGridOnRealHair) {
  const std::filesystem::path file = std::filesystem::path(HAIR_DATA_DIR) / "hair/straight.hair";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "real data not found at " << file;
  expectAgreement(readStrands(file, {.scale = 0.00465f}).strands, {0.465e-3f, 0.64f, 1});
}

TEST(EmbreeTracer, AgreesWithTheGridOnABuiltInStyle) {
  const Groom groom =
      makeGroom(styleSettings(Style::Curly), MeshSdf{builtinHead().mesh, 0.004f, 0.05f});
  StrandSet strands;
  for (std::size_t s = 0; s + 1 < groom.first.size(); ++s) {
    std::vector<glm::vec3> points(groom.first[s + 1] - groom.first[s]);
    drawAtRest(groom, s, points);
    strands.append(points);
  }
  expectAgreement(strands, groom.fibre);
}

TEST(EmbreeTracer, CountsJointsOnceAndEndsSquare) {
  const float width = 1e-3f;
  const Fibre fibre{width, 0.5f, 1};
  StrandSet strands;
  std::vector<glm::vec3> bent{{0, 1, 0}};
  for (int k = 0; k < 20; ++k) {
    const float heading = 0.05f * static_cast<float>(k);
    bent.push_back(bent.back() + 5 * width * glm::vec3(std::cos(heading), 0, std::sin(heading)));
  }
  strands.append(bent);
  const auto tracer = makeEmbreeTracer(strands, fibre);
  const glm::vec3 up(0, 1, 0);
  for (std::size_t k = 0; k + 1 < bent.size(); ++k)
    for (int along = 1; along <= 50; ++along) {
      if (k + 2 == bent.size() && along == 50) continue;
      const glm::vec3 p = glm::mix(bent[k], bent[k + 1], static_cast<float>(along) / 50);
      EXPECT_EQ(test::crossings(*tracer, p - up, up), 1u) << k << ' ' << along;
      EXPECT_EQ(test::crossings(*tracer, p - 0.1f * width * up, up), 1u) << k << ' ' << along;
      EXPECT_EQ(test::crossings(*tracer, p + 0.1f * width * up, up), 0u) << k << ' ' << along;
    }
  EXPECT_EQ(test::crossings(*tracer, {-0.1f * width, 0, 0}, up), 0u);
  EXPECT_EQ(test::crossings(*tracer, {0.1f * width, 0, 0}, up), 1u);
  EXPECT_EQ(test::crossings(*tracer, {0.1f * width, 0, 0}, up, kNoStrand, 0.9f), 0u);
  EXPECT_EQ(test::crossings(*tracer, {0.1f * width, 0, 0}, up, kNoStrand, 1.0001f), 1u);
  EXPECT_EQ(test::crossings(*tracer, {0.1f * width, 0, 0}, up, 0), 0u);
}

TEST(EmbreeTracer, NoHairIsNotCrossedAndBadArgumentsAreErrors) {
  StrandSet strands;
  EXPECT_EQ(test::crossings(*makeEmbreeTracer(strands, {}), {0, 0, 0}, {0, 1, 0}), 0u);
  EXPECT_THROW(makeEmbreeTracer(strands, Fibre{-1, 0.5f, 1}), Error);
  strands.append(std::vector<glm::vec3>{{-1, 1, 0}, {1, 1, 0}});
  EXPECT_THROW(test::crossings(*makeEmbreeTracer(strands, {}), {0, 0, 0}, {0, 0, 0}), Error);
}

}  // namespace
}  // namespace hair
