#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/measure/shadow/truth.h>

#include "hair_samples.h"

namespace hair {
namespace {

const LightSpace kFromAbove = makeLightSpace({0, -1, 0});
const LightSpace kSlanted = makeLightSpace({0.5f, -0.8f, 0.35f});

SamplePoint freePoint(glm::vec3 position, std::uint32_t number = 0) {
  return {kNoStrand, number, position};
}

/// Waving hair of which each point is behind a few fibres, and points on it.
struct SomeHair {
  StrandSet strands = test::randomStrands(600, 12, 0.03f, 0.3f, 0.04f);
  Fibre fibre{1e-3f, 0.5f, 1};
  std::unique_ptr<FibreTracer> tracer = makeGridTracer(strands, fibre);
  std::vector<SamplePoint> points = chooseSamplePoints(strands, 60, 5);
};

TEST(Truth, BehindSoManyFibresIsThePowerOfWhatOneLeaves) {
  for (int n : {0, 1, 2, 7}) {
    StrandSet strands;
    for (int k = 0; k < n; ++k) {
      const float y = 0.1f * static_cast<float>(k + 1);
      strands.append(std::vector<glm::vec3>{{-0.1f, y, 0}, {0, y, 0}, {0.1f, y, 0}});
    }
    const Fibre fibre{0.02f, 0.3f, 1};  // wider than the footprint
    const std::vector<SamplePoint> points{freePoint({0, 0, 0})};
    const Truth truth =
        exactTransmittance(*makeGridTracer(strands, fibre), fibre, kFromAbove, points, {});
    EXPECT_FLOAT_EQ(truth.transmittance[0], std::pow(0.7f, static_cast<float>(n)));
    EXPECT_EQ(truth.standardError[0], 0);
  }
}

TEST(Truth, OfAFibreThroughTheDiscIsTheShareItCovers) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{-0.1f, 0.1f, 0}, {0.1f, 0.1f, 0}});
  const Fibre fibre{1e-3f, 0.6f, 1};
  const std::vector<SamplePoint> points{freePoint({0, 0, 0})};
  const Truth truth =
      exactTransmittance(*makeGridTracer(strands, fibre), fibre, kFromAbove, points, {});
  // A strip of half-width h through the middle of a disc of radius R.
  const double x = 0.5 / 3;
  const double share = 2 * (std::asin(x) + x * std::sqrt(1 - x * x)) / 3.14159265358979;
  EXPECT_NEAR(static_cast<double>(truth.transmittance[0]), 1 - 0.6 * share, 0.002);
  // Of plain random rays: alpha sqrt(p (1 - p) / n).
  EXPECT_NEAR(truth.standardError[0], 0.6 * std::sqrt(share * (1 - share) / 2048), 2e-4);
}

// Short level fibres strewn evenly: how many a ray crosses is Poisson, and E[(1 - a)^n] is
// exp(-a mean n).
TEST(Truth, OfARandomSlabIsThatOfPoisson) {
  constexpr std::uint32_t kFibres = 100'000;
  constexpr float kLength = 4e-3f, kWidth = 2e-4f, kSide = 0.2f;
  StrandSet strands;
  for (std::uint32_t s = 0; s < kFibres; ++s) {
    const float angle = 6.2831853f * uniform(s, 4);
    const glm::vec3 half(0.5f * kLength * std::cos(angle), 0, 0.5f * kLength * std::sin(angle));
    const glm::vec3 middle(kSide * uniform(s, 1), 0.01f + 0.05f * uniform(s, 2),
                           kSide * uniform(s, 3));
    strands.append(std::vector<glm::vec3>{middle - half, middle, middle + half});
  }
  const Fibre fibre{kWidth, 0.7f, 1};
  std::vector<SamplePoint> points;  // so far apart that no fibre is over two of them
  for (int x = 1; x < 20; ++x)
    for (int z = 1; z < 20; ++z)
      points.push_back(freePoint({0.01f * static_cast<float>(x), 0, 0.01f * static_cast<float>(z)},
                                 static_cast<std::uint32_t>(x * 20 + z)));
  const Truth truth = exactTransmittance(*makeGridTracer(strands, fibre), fibre, kFromAbove, points,
                                         {.footprint = 2e-3f, .rays = 512});
  double sum = 0, squares = 0;
  for (const float t : truth.transmittance) {
    sum += static_cast<double>(t);
    squares += static_cast<double>(t) * static_cast<double>(t);
  }
  const double n = static_cast<double>(points.size()), mean = sum / n;
  const double standardError = std::sqrt((squares / n - mean * mean) / (n - 1));
  const double meanCrossings = static_cast<double>(kFibres) * static_cast<double>(kLength) *
                               static_cast<double>(kWidth) / static_cast<double>(kSide * kSide);
  EXPECT_NEAR(mean, std::exp(-0.7 * meanCrossings), 3 * standardError);
  EXPECT_LT(standardError, 0.004);
}

// Its own kind of error is that of plain random rays; rays are spread more evenly than that.
TEST(Truth, StandardErrorIsHonest) {
  const SomeHair hair;
  constexpr std::uint32_t kSeeds = 30;
  TruthSettings settings{.rays = 256};
  std::vector<double> sum(hair.points.size()), squares(hair.points.size());
  double stated = 0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    settings.seed = seed;
    const Truth truth =
        exactTransmittance(*hair.tracer, hair.fibre, kSlanted, hair.points, settings);
    for (std::size_t i = 0; i < hair.points.size(); ++i) {
      const double t = static_cast<double>(truth.transmittance[i]);
      const double e = static_cast<double>(truth.standardError[i]);
      sum[i] += t, squares[i] += t * t, stated += e * e;
    }
  }
  const double n = static_cast<double>(hair.points.size());
  stated = std::sqrt(stated / kSeeds / n);
  settings = {.rays = 1u << 16, .seed = 99};
  const Truth finer = exactTransmittance(*hair.tracer, hair.fibre, kSlanted, hair.points, settings);
  double spread = 0, offset = 0;
  for (std::size_t i = 0; i < hair.points.size(); ++i) {
    const double mean = sum[i] / kSeeds;
    spread += (squares[i] - kSeeds * mean * mean) / (kSeeds - 1);
    offset += mean - static_cast<double>(finer.transmittance[i]);
  }
  spread = std::sqrt(spread / n);
  EXPECT_GT(stated, 1e-3);
  EXPECT_LE(spread, stated);
  EXPECT_GT(spread, 0.1 * stated);
  // No bias: all rays of all seeds together are within three of what they may be off.
  EXPECT_NEAR(offset / n, 0, 3 * spread / std::sqrt(kSeeds * n) + 3 * stated / 16 / std::sqrt(n));
}

TEST(Truth, WithoutFootprintHasNoNoise) {
  const SomeHair hair;
  const Truth truth =
      exactTransmittance(*hair.tracer, hair.fibre, kSlanted, hair.points, {.footprint = 0});
  bool shadowed = false;
  for (std::size_t i = 0; i < hair.points.size(); ++i) {
    const std::uint32_t n = test::crossings(*hair.tracer, hair.points[i].position,
                                            -kSlanted.direction(), hair.points[i].strand);
    EXPECT_EQ(truth.transmittance[i], std::pow(0.5f, static_cast<float>(n)));
    EXPECT_EQ(truth.standardError[i], 0);
    shadowed = shadowed || n > 0;
  }
  EXPECT_TRUE(shadowed);
}

TEST(Truth, OfALightFarAwayIsThatOfParallelLight) {
  const SomeHair hair;
  const LightSpace far = makePointLightSpace(-1e4f * kSlanted.direction(), {0, 0, 0});
  const Truth parallel = exactTransmittance(*hair.tracer, hair.fibre, kSlanted, hair.points, {});
  const Truth point = exactTransmittance(*hair.tracer, hair.fibre, far, hair.points, {});
  double sum = 0;
  for (std::size_t i = 0; i < hair.points.size(); ++i) {
    // Rays meet after 10 km: over 20 cm, 5 cm apart, they differ by 1 µm, a fibre is 1 mm wide.
    EXPECT_NEAR(point.transmittance[i], parallel.transmittance[i], 1e-3f);
    sum += static_cast<double>(parallel.transmittance[i]);
  }
  EXPECT_LT(sum, 0.8 * static_cast<double>(hair.points.size()));
}

TEST(Truth, RaysMeetInALightAtAPoint) {
  // A fibre just before the light hides it from the whole disc, one behind it does nothing.
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{-0.1f, 0.9f, 0}, {0.1f, 0.9f, 0}});
  strands.append(std::vector<glm::vec3>{{-0.1f, 1.1f, 0}, {0.1f, 1.1f, 0}});
  const Fibre fibre{1e-3f, 0.6f, 1};
  const auto tracer = makeGridTracer(strands, fibre);
  const LightSpace light = makePointLightSpace({0, 1, 0}, {0, 0.05f, 0});
  const std::vector<SamplePoint> points{freePoint({0, 0, 0}), freePoint({0.05f, 0, 0.02f})};
  const Truth truth = exactTransmittance(*tracer, fibre, light, points, {});
  EXPECT_FLOAT_EQ(truth.transmittance[0], 0.4f);
  EXPECT_FLOAT_EQ(truth.transmittance[1], 1.0f);  // 2 mm beside it up there
  const Truth parallel = exactTransmittance(*tracer, fibre, kFromAbove, points, {});
  EXPECT_GT(parallel.transmittance[0], 0.5f);
}

TEST(Truth, OfAPointDoesNotDependOnTheOthers) {
  const SomeHair hair;
  const TruthSettings settings{.rays = 100};
  const Truth all = exactTransmittance(*hair.tracer, hair.fibre, kSlanted, hair.points, settings);
  for (std::size_t i : {0u, 17u, 59u}) {
    const Truth one = exactTransmittance(*hair.tracer, hair.fibre, kSlanted,
                                         std::span(hair.points).subspan(i, 1), settings);
    EXPECT_EQ(one.transmittance[0], all.transmittance[i]);
    EXPECT_EQ(one.standardError[0], all.standardError[i]);
  }
}

TEST(Truth, IsTheSameForAnyNumberOfThreads) {
  const SomeHair hair;
  const LightSpace near = makePointLightSpace({0, 0.5f, 0.2f}, {0, 0, 0});
  for (const LightSpace& light : {kSlanted, near}) {
    std::vector<Truth> truths;
    for (int threads : {1, 2, 5}) {
      const ThreadLimit limit(threads);
      truths.push_back(
          exactTransmittance(*hair.tracer, hair.fibre, light, hair.points, {.rays = 200}));
    }
    for (std::size_t k : {1u, 2u}) {
      EXPECT_EQ(truths[k].transmittance, truths[0].transmittance);
      EXPECT_EQ(truths[k].standardError, truths[0].standardError);
    }
  }
}

TEST(Truth, BadSettingsAreErrors) {
  const SomeHair hair;
  const auto with = [&](TruthSettings settings, Fibre fibre) {
    return exactTransmittance(*hair.tracer, fibre, kSlanted, hair.points, settings);
  };
  EXPECT_THROW(with({.footprint = -1e-3f}, hair.fibre), Error);
  EXPECT_THROW(with({.footprint = NAN}, hair.fibre), Error);
  EXPECT_THROW(with({.rays = 1}, hair.fibre), Error);
  EXPECT_THROW(with({.rays = 0xffffffffu}, hair.fibre), Error);
  EXPECT_THROW(with({}, {1e-3f, 1.5f, 1}), Error);
  EXPECT_THROW(with({}, {1e-3f, NAN, 1}), Error);
  EXPECT_NO_THROW(with({.rays = 2}, {1e-3f, 1, 1}));
  const Truth none = exactTransmittance(*hair.tracer, hair.fibre, kSlanted, {}, {});
  EXPECT_TRUE(none.transmittance.empty());
}

}  // namespace
}  // namespace hair
