#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include <libhair/core/error.h>
#include <libhair/shadow/methods/density_clustering.h>
#include <libhair/shadow/methods/shadow_method.h>

#include "ray.h"

namespace hair {
namespace {

using test::clustered;
using test::fragmentsOfGaussians;
using test::meanError;
using test::uniformHistogram;
using Start = DensityClusteringSettings::Start;

DensityClusteringSettings clusters(int count, int iterations = 1, Start start = Start::Uniform) {
  DensityClusteringSettings settings;
  settings.clusters = count;
  settings.iterations = iterations;
  settings.start = start;
  return settings;
}

TEST(Clustering, OfOneClusterIsEquationThree) {
  const std::vector<PixelFragment> fragments = {{1, 0.5f}, {2, 0.25f}, {4, 0.25f}};
  // mu = 2, sigma² = 0.5 · 1 + 0.25 · 4 = 1.5, sqrt(3) sigma = 2.12; bins end where fragments do.
  const auto bins = clustered(fragments, clusters(1));
  ASSERT_EQ(bins.size(), 1u);
  EXPECT_FLOAT_EQ(bins[0].from, 1.0f);
  EXPECT_FLOAT_EQ(bins[0].to, 4.0f);
  EXPECT_FLOAT_EQ(bins[0].opticalDepth, 1.0f);
  // A spread that ends inside: mu = 5, sigma² = 2 · 0.05 · 25, half width sqrt(3 · 2.5).
  const std::vector<PixelFragment> narrow = {{0, 0.05f}, {5, 0.9f}, {10, 0.05f}};
  const auto bin = clustered(narrow, clusters(1));
  ASSERT_EQ(bin.size(), 1u);
  EXPECT_NEAR(bin[0].from, 5 - std::sqrt(7.5), 1e-5);
  EXPECT_NEAR(bin[0].to, 5 + std::sqrt(7.5), 1e-5);
}

TEST(Clustering, BinsThatOverlapMeetHalfway) {
  // mu = 1.5 and 6.75, sigma = 1.5 and 2.25: R1 = 4.098, L2 = 2.853.
  const std::vector<PixelFragment> fragments = {{0, 0.1f}, {3, 0.1f}, {4.5f, 0.2f}, {9, 0.2f}};
  const auto bins = clustered(fragments, clusters(2));
  ASSERT_EQ(bins.size(), 2u);
  EXPECT_NEAR(bins[0].to, 0.5 * (1.5 + std::sqrt(3) * 1.5 + 6.75 - std::sqrt(3) * 2.25), 1e-5);
  EXPECT_EQ(bins[0].to, bins[1].from);
  EXPECT_FLOAT_EQ(bins[0].opticalDepth, 0.2f);
  EXPECT_FLOAT_EQ(bins[1].opticalDepth, 0.4f);
}

TEST(Clustering, ALopsidedClusterDoesNotTurnItsNeighbourAround) {
  // mu = 8 and 11.009, sigma = 0.008 and 2.997: L2 = 5.8, halfway to R1 is in front of L1.
  const std::vector<PixelFragment> fragments = {{0, 1e-6f}, {8, 1}, {10.01f, 0.9f}, {20, 0.1f}};
  const auto bins = clustered(fragments, clusters(2));
  ASSERT_EQ(bins.size(), 2u);
  EXPECT_NEAR(bins[0].from, 8, 0.02);
  EXPECT_NEAR(bins[0].to, 8, 1e-4);
  EXPECT_GE(bins[0].to, bins[0].from);
  EXPECT_EQ(bins[1].from, bins[0].to);
}

TEST(Clustering, OfEvenFragmentsIsARamp) {
  // A uniform distribution of width W has sigma² = W² / 12: the bin is as wide as it (section 3.2).
  std::vector<PixelFragment> even;
  for (int i = 0; i < 1000; ++i) even.push_back({3 + 2e-3f * static_cast<float>(i), 1e-3f});
  for (int count : {1, 2, 3, 8}) {
    const auto bins = clustered(even, clusters(count));
    ASSERT_EQ(bins.size(), static_cast<std::size_t>(count));
    EXPECT_NEAR(bins.front().from, 3, 2e-3);
    EXPECT_NEAR(bins.back().to, 5, 4e-3);
    for (int i = 0; i <= 40; ++i) {
      const float s = 2.5f + 0.075f * static_cast<float>(i);
      EXPECT_NEAR(opticalDepthAt(bins, s), std::clamp(0.5f * (s - 3), 0.0f, 1.0f), 3e-3f);
    }
  }
}

/// Eleven fragments each, one deep; those farther away are thicker.
std::vector<PixelFragment> bundles(std::initializer_list<float> middles) {
  std::vector<PixelFragment> fragments;
  for (float middle : middles)
    for (int i = -5; i <= 5; ++i)
      fragments.push_back({middle + 0.1f * static_cast<float>(i), 0.01f * middle});
  return fragments;
}

TEST(Clustering, FindsBundlesThatStandApart) {
  // Clusters begin at 13.5, 20.5, 27.5, 34.5: the second bundle is across a wall between two.
  const auto fragments = bundles({10, 17.2f, 30, 38});
  const auto bins = clustered(fragments, clusters(4, 10));
  ASSERT_EQ(bins.size(), 4u);
  for (std::size_t b = 0; b < 4; ++b) {
    const float middle = fragments[11 * b + 5].depth;
    EXPECT_NEAR(0.5f * (bins[b].from + bins[b].to), middle, 0.03f);
    EXPECT_NEAR(bins[b].to - bins[b].from, 1.0f, 0.1f);
    EXPECT_NEAR(bins[b].opticalDepth, 0.11f * middle, 1e-4f);
  }
}

TEST(Clustering, CanLeaveTwoBundlesInOneClusterForGood) {
  // "The choice of optimal initial clusters remains an open problem" (section 5).
  for (int iterations : {1, 100})
    EXPECT_EQ(clustered(bundles({10, 13, 30, 38}), clusters(4, iterations)).size(), 3u);
}

TEST(Clustering, BinsAreInOrderAndHoldAllOfTheOpticalDepth) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const int count = 1 + static_cast<int>(seed % 11), fragmentCount = 1 + static_cast<int>(seed);
    auto fragments = fragmentsOfGaussians(3, seed, fragmentCount, 2.0f);
    if (seed % 3 == 0)  // hair in layers: many of one depth
      for (PixelFragment& f : fragments) f.depth = std::round(f.depth * 20) / 20;
    for (Start start : {Start::Uniform, Start::TowardsLight})
      for (float leastWidth : {0.0f, 0.03f}) {
        const auto bins = clustered(fragments, clusters(count, 1 + count % 3, start), leastWidth);
        ASSERT_GE(bins.size(), 1u);
        ASSERT_GE(bins.front().from, fragments.front().depth);
        ASSERT_LE(bins.back().to, fragments.back().depth + leastWidth + 1e-6f);
        float sum = 0;
        for (std::size_t b = 0; b < bins.size(); ++b) {
          ASSERT_LE(bins[b].from, bins[b].to);
          if (b > 0) {
            ASSERT_LE(bins[b - 1].to, bins[b].from);
          }
          ASSERT_GT(bins[b].opticalDepth, 0.0f);
          sum += bins[b].opticalDepth;
        }
        ASSERT_NEAR(sum, 2.0f, 1e-5f);
        float last = 0;
        for (int i = -10; i <= 1200; ++i) {
          const float t = opticalDepthAt(bins, 1e-3f * static_cast<float>(i));
          ASSERT_GE(t, last);
          last = t;
        }
        ASSERT_EQ(opticalDepthAt(bins, fragments.front().depth), 0.0f);
      }
  }
}

TEST(Clustering, WithoutFragmentsMakesNoBins) {
  EXPECT_TRUE(clustered({}, clusters(4)).empty());
  EXPECT_EQ(opticalDepthAt({}, 3), 0.0f);
}

TEST(Clustering, OfALoneFragmentIsAStepOrAsWideAsAskedFor) {
  const std::vector<PixelFragment> lone = {{7, 0.5f}};
  const auto step = clustered(lone, clusters(4));
  EXPECT_EQ(opticalDepthAt(step, 7), 0.0f);
  EXPECT_EQ(opticalDepthAt(step, std::nextafter(7.0f, 8.0f)), 0.5f);
  // With a width, a point right at it hardly sees it, whatever rounding does to its depth.
  const auto ramp = clustered(lone, clusters(4), 0.5f);
  EXPECT_EQ(opticalDepthAt(ramp, 7), 0.0f);
  EXPECT_LT(opticalDepthAt(ramp, 7.0001f), 2e-4f);
  EXPECT_FLOAT_EQ(opticalDepthAt(ramp, 7.25f), 0.25f);
  EXPECT_EQ(opticalDepthAt(ramp, 7.5f), 0.5f);
}

TEST(Clustering, StopsMovingWhenFurtherRoundsChangeNothing) {
  const auto fragments = fragmentsOfGaussians(8, 5);
  const auto a = clustered(fragments, clusters(4, 50)), b = clustered(fragments, clusters(4, 5000));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].from, b[i].from);
}

/// Figure 5 of the paper, on numbers: the mean over rays of the mean error of the visibility
/// function.
struct Figure5 {
  double clustering = 0, twoMore = 0, towardsLight = 0, uniform = 0, twiceAsMany = 0;
  double nearLight = 0, nearLightTowards = 0;  // over the first quarter of the way
  int wins = 0;                                // rays on which clustering beats even bins

  Figure5(int gaussians, int count, std::uint32_t rays) {
    for (std::uint32_t seed = 0; seed < rays; ++seed) {
      const auto fragments = fragmentsOfGaussians(gaussians, seed);
      const auto bins = clustered(fragments, clusters(count));
      const auto scaled = clustered(fragments, clusters(count, 1, Start::TowardsLight));
      const double error = meanError(bins, fragments);
      const double even = meanError(uniformHistogram(fragments, count), fragments);
      clustering += error / rays;
      twoMore += meanError(clustered(fragments, clusters(count, 3)), fragments) / rays;
      towardsLight += meanError(scaled, fragments) / rays;
      uniform += even / rays;
      twiceAsMany += meanError(uniformHistogram(fragments, 2 * count), fragments) / rays;
      nearLight += meanError(bins, fragments, 0.25f) / rays;
      nearLightTowards += meanError(scaled, fragments, 0.25f) / rays;
      wins += error < even ? 1 : 0;
    }
  }
  std::string text() const {
    return hair::text("clustering ", clustering, ", 3 rounds ", twoMore, ", towards the light ",
                      towardsLight, ", K even bins ", uniform, ", 2K ", twiceAsMany,
                      "; near the light ", nearLight, ", towards ", nearLightTowards, "; wins ",
                      wins);
  }
};

TEST(Figure5, ClustersComeMuchNearerThanEvenBinsWithAsManyGaussiansAsClusters) {
  const Figure5 figure(4, 4, 300);
  EXPECT_LT(figure.clustering, 0.4 * figure.uniform) << figure.text();
  // The paper's own comparison: it gives even bins twice the number.
  EXPECT_LT(figure.clustering, 0.8 * figure.twiceAsMany) << figure.text();
  EXPECT_LT(figure.twoMore, 0.85 * figure.clustering) << figure.text();
  EXPECT_LT(figure.clustering, 0.012) << figure.text();
  EXPECT_GT(figure.wins, 280) << figure.text();
  RecordProperty("errors", figure.text());
}

TEST(Figure5, ClustersComeNearerThanEvenBinsWithMoreGaussiansThanClusters) {
  const Figure5 figure(8, 4, 300);
  EXPECT_LT(figure.clustering, 0.6 * figure.uniform) << figure.text();
  EXPECT_GT(figure.wins, 270) << figure.text();
  // The method does worse with fewer clusters than bundles, as the paper says.
  EXPECT_GT(figure.clustering, 1.3 * Figure5(4, 4, 300).clustering) << figure.text();
  // "A more accurate approximation near the origin."
  EXPECT_LT(figure.nearLightTowards, 0.85 * figure.nearLight) << figure.text();
  RecordProperty("errors", figure.text());
}

TEST(DensityClustering, RefusesSettingsOutOfRange) {
  const auto refuses = [](auto change) {
    DensityClusteringSettings settings;
    change(settings);
    EXPECT_THROW(makeDensityClustering(settings), Error);
  };
  EXPECT_NO_THROW(makeDensityClustering({}));
  EXPECT_NO_THROW(makeDensityClustering(clusters(64)));
  refuses([](auto& s) { s.pixelSize = 0; });
  refuses([](auto& s) { s.pixelSize = -1e-3f; });
  refuses([](auto& s) { s.pixelSize = std::numeric_limits<float>::quiet_NaN(); });
  refuses([](auto& s) { s.pixelSize = std::numeric_limits<float>::infinity(); });
  refuses([](auto& s) { s.clusters = 0; });
  refuses([](auto& s) { s.clusters = 65; });
  refuses([](auto& s) { s.iterations = 0; });
}

}  // namespace
}  // namespace hair
