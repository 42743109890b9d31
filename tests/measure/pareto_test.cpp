#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/random.h>
#include <libhair/measure/shadow/pareto.h>

namespace hair {
namespace {

using Indices = std::vector<std::size_t>;

bool beats(double timeA, double errorA, double timeB, double errorB) {
  return timeA <= timeB && errorA <= errorB && (timeA < timeB || errorA < errorB);
}

TEST(Pareto, TheFrontIsWhatNothingBeats) {
  std::vector<double> time, error;
  for (std::uint32_t i = 0; i < 400; ++i) {
    // Few different values, so that there are ties of every kind.
    time.push_back(std::floor(30 * static_cast<double>(uniform(i, 0))));
    error.push_back(std::floor(30 * static_cast<double>(uniform(i, 1))));
  }
  const Indices front = paretoFront(time, error);
  std::set<std::pair<double, double>> wanted, got;
  for (std::size_t i = 0; i < time.size(); ++i) {
    bool beaten = false;
    for (std::size_t j = 0; j < time.size(); ++j)
      beaten = beaten || beats(time[j], error[j], time[i], error[i]);
    if (!beaten) wanted.insert({time[i], error[i]});
  }
  for (const std::size_t i : front) got.insert({time[i], error[i]});
  EXPECT_EQ(got, wanted);
  EXPECT_EQ(front.size(), wanted.size()) << "a pair is there twice";
}

TEST(Pareto, TimeRisesAndErrorFallsAlongTheFront) {
  std::vector<double> time, error;
  for (std::uint32_t i = 0; i < 200; ++i) {
    time.push_back(static_cast<double>(uniform(i, 2)));
    error.push_back(static_cast<double>(uniform(i, 3)));
  }
  const Indices front = paretoFront(time, error);
  ASSERT_GT(front.size(), 1u);
  for (std::size_t k = 1; k < front.size(); ++k) {
    EXPECT_LT(time[front[k - 1]], time[front[k]]);
    EXPECT_GT(error[front[k - 1]], error[front[k]]);
  }
}

TEST(Pareto, OfEqualsTheFirstStays) {
  const std::vector<double> time = {2, 1, 1, 1}, error = {1, 3, 2, 2};
  EXPECT_EQ(paretoFront(time, error), (Indices{2, 0}));
}

TEST(Pareto, WhatIsNotANumberIsNeverOnTheFront) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<double> time = {nan, 1, 0, 3}, error = {0, nan, inf, 5};
  EXPECT_EQ(paretoFront(time, error), Indices{3});
  EXPECT_TRUE(paretoFront({}, {}).empty());
}

TEST(Pareto, ATimeWithoutAnErrorIsAnError) {
  const std::vector<double> two = {1, 2}, one = {1};
  EXPECT_THROW(paretoFront(two, one), Error);
}

}  // namespace
}  // namespace hair
