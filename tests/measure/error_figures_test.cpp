#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/random.h>
#include <libhair/measure/shadow/truth.h>

namespace hair {
namespace {

Truth truthOf(std::vector<float> transmittance, float noise) {
  Truth truth;
  truth.standardError.assign(transmittance.size(), noise);
  truth.transmittance = std::move(transmittance);
  return truth;
}

// Errors 0.25, -0.25, 0.5, 0 (exact in binary): by hand.
TEST(ErrorFigures, AreThoseComputedByHand) {
  const std::vector<float> measured{0.5f, 0.25f, 1.0f, 0.75f};
  const ErrorFigures f = errorFigures(measured, truthOf({0.25f, 0.5f, 0.5f, 0.75f}, 0));
  EXPECT_DOUBLE_EQ(f.bias.value, 0.125);
  EXPECT_DOUBLE_EQ(f.meanAbsolute.value, 0.25);
  EXPECT_DOUBLE_EQ(f.rms.value, std::sqrt(0.375 / 4));
  // Place 0.99 * 3 = 2.97 of 0, 0.25, 0.25, 0.5.
  EXPECT_NEAR(f.percentile99.value, 0.25 + 0.97 * 0.25, 1e-12);
  // Sums of squares about the mean: bias 0.375 - 4 / 64, absolute 0.375 - 4 / 16.
  EXPECT_DOUBLE_EQ(f.bias.standardError, std::sqrt(0.3125 / 3 / 4));
  EXPECT_DOUBLE_EQ(f.meanAbsolute.standardError, std::sqrt(0.125 / 3 / 4));
  // Squares 1/16, 1/16, 1/4, 0: mean 3/32, sum of fourth powers 18/256.
  const double variance = (18.0 / 256 - 4 * (3.0 / 32) * (3.0 / 32)) / 3;
  EXPECT_DOUBLE_EQ(f.rms.standardError, std::sqrt(variance / 4) / (2 * std::sqrt(0.375 / 4)));
}

TEST(ErrorFigures, AreNeverSurerThanTheTruth) {
  // The same error everywhere: nothing scatters, but the truth is known to 0.1 only.
  const std::vector<float> measured(25, 0.75f);
  const ErrorFigures f = errorFigures(measured, truthOf(std::vector<float>(25, 0.5f), 0.1f));
  EXPECT_DOUBLE_EQ(f.bias.value, 0.25);
  EXPECT_NEAR(f.bias.standardError, 0.1 / 5, 1e-8);
  EXPECT_NEAR(f.meanAbsolute.standardError, 0.1 / 5, 1e-8);
  EXPECT_NEAR(f.rms.standardError, std::sqrt(4 * 0.0625 * 0.01 + 2e-4) / 5 / 0.5, 1e-8);
  const std::vector<float> same(25, 0.5f);
  const ErrorFigures none = errorFigures(same, truthOf(std::vector<float>(25, 0.5f), 0.1f));
  EXPECT_EQ(none.rms.value, 0);
  EXPECT_NEAR(none.rms.standardError, 0.1 / 5, 1e-8);
}

// Many samples of the same kind of error: figures scatter as they say.
TEST(ErrorFigures, ScatterAsTheirStandardErrorsSay) {
  constexpr int kRuns = 200, kPoints = 500;
  double sum[4] = {}, squares[4] = {}, stated[4] = {};
  for (std::uint32_t run = 0; run < kRuns; ++run) {
    std::vector<float> measured(kPoints), truth(kPoints);
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      truth[i] = 0.5f;
      // About normal: the sum of four uniform numbers.
      float e = -2;
      for (std::uint32_t k = 0; k < 4; ++k) e += uniform(i, k, 77 + run);
      measured[i] = 0.51f + 0.05f * e;
    }
    const ErrorFigures f = errorFigures(measured, truthOf(truth, 0.001f));
    const ErrorFigures::Figure all[] = {f.meanAbsolute, f.rms, f.percentile99, f.bias};
    for (int k = 0; k < 4; ++k) {
      sum[k] += all[k].value / kRuns;
      squares[k] += all[k].value * all[k].value / kRuns;
      stated[k] += all[k].standardError / kRuns;
    }
  }
  for (int k = 0; k < 4; ++k) {
    const double spread = std::sqrt(squares[k] - sum[k] * sum[k]);
    // The spread of 200 is itself known to 5 %, that of a percentile's bootstrap less well.
    EXPECT_NEAR(stated[k] / spread, 1, k == 2 ? 0.35 : 0.2) << k;
  }
}

TEST(ErrorFigures, AreTheSameEachTime) {
  std::vector<float> measured(1000);
  for (std::uint32_t i = 0; i < 1000; ++i) measured[i] = uniform(i, 1);
  const Truth truth = truthOf(std::vector<float>(1000, 0.5f), 0);
  const double once = errorFigures(measured, truth).percentile99.standardError;
  EXPECT_GT(once, 0);
  EXPECT_EQ(once, errorFigures(measured, truth).percentile99.standardError);
}

TEST(ErrorFigures, OfOnePointHaveItsNoise) {
  const std::vector<float> measured{0.75f};
  const ErrorFigures f = errorFigures(measured, truthOf({0.5f}, 0.125f));
  for (const auto& figure : {f.meanAbsolute, f.rms, f.percentile99, f.bias})
    EXPECT_DOUBLE_EQ(figure.value, 0.25);
  EXPECT_DOUBLE_EQ(f.bias.standardError, 0.125);
}

TEST(ErrorFigures, OfNothingOrOfOtherPointsAreErrors) {
  EXPECT_THROW(errorFigures({}, Truth{}), Error);
  const std::vector<float> measured(3);
  EXPECT_THROW(errorFigures(measured, truthOf(std::vector<float>(4), 0)), Error);
  Truth truth = truthOf(std::vector<float>(3), 0);
  truth.standardError.pop_back();
  EXPECT_THROW(errorFigures(measured, truth), Error);
}

}  // namespace
}  // namespace hair
