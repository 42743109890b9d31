#include <libhair/hair_mesh/mean_value.h>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <libhair/core/random.h>

namespace hair {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::vector<glm::dvec2> regular(std::size_t sides) {
  std::vector<glm::dvec2> polygon;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = kTurn * (static_cast<double>(i) + 0.3) / static_cast<double>(sides);
    polygon.emplace_back(0.02 * std::cos(angle), 0.03 * std::sin(angle));
  }
  return polygon;
}

// An L, whose inner corner is corner 3.
std::vector<glm::dvec2> letterL() {
  return {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
}

glm::dvec2 random(std::uint32_t i, double size) {
  return size * glm::dvec2(2 * uniform(i, 1) - 1, 2 * uniform(i, 2) - 1);
}

std::vector<float> weightsOf(const std::vector<glm::dvec2>& polygon, glm::dvec2 p) {
  std::vector<float> weights(polygon.size());
  meanValueCoordinates(polygon, p, weights);
  return weights;
}

void expectPartitionAndPrecision(const std::vector<glm::dvec2>& polygon, glm::dvec2 p,
                                 double tolerance) {
  const auto weights = weightsOf(polygon, p);
  double sum = 0;
  glm::dvec2 q(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += static_cast<double>(weights[i]);
    q += static_cast<double>(weights[i]) * polygon[i];
  }
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_LT(glm::distance(p, q), tolerance) << p.x << " " << p.y;
}

}  // namespace

TEST(MeanValueCoordinates, SumToOneAndGiveThePointBack) {
  for (const std::size_t sides : {3u, 4u, 5u, 6u, 9u})
    for (std::uint32_t i = 0; i < 200; ++i)
      expectPartitionAndPrecision(regular(sides), random(i, 0.03), 1e-8);
  for (std::uint32_t i = 0; i < 500; ++i)
    expectPartitionAndPrecision(letterL(), random(i, 1) + glm::dvec2(1), 1e-6);
}

TEST(MeanValueCoordinates, OfATriangleAreBarycentric) {
  const std::vector<glm::dvec2> t = {{0, 0}, {3, 0}, {0, 2}};
  const auto weights = weightsOf(t, {0.6, 0.5});
  EXPECT_NEAR(weights[1], 0.2f, 1e-6f);
  EXPECT_NEAR(weights[2], 0.25f, 1e-6f);
}

TEST(MeanValueCoordinates, AreNeverNegativeInAConvexPolygon) {
  const auto polygon = regular(7);
  for (std::uint32_t i = 0; i < 500; ++i) {
    // Between the middle and a point of an edge, at times very close to it.
    const glm::dvec2 a = polygon[i % 7], b = polygon[(i + 1) % 7];
    const double inside = i % 3 == 0 ? 1 - 1e-13 : static_cast<double>(uniform(i, 2));
    const glm::dvec2 p = inside * glm::mix(a, b, static_cast<double>(uniform(i, 1)));
    for (const float w : weightsOf(polygon, p)) EXPECT_GE(w, 0);
  }
}

TEST(MeanValueCoordinates, AreExactAtCornersAndLinearOnEdges) {
  for (const auto& polygon : {regular(3), regular(5), letterL()})
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t j = (i + 1) % polygon.size();
      EXPECT_EQ(weightsOf(polygon, polygon[i])[i], 1);
      const auto weights = weightsOf(polygon, glm::mix(polygon[i], polygon[j], 0.25));
      for (std::size_t c = 0; c < polygon.size(); ++c)
        EXPECT_NEAR(weights[c], c == i ? 0.75f : c == j ? 0.25f : 0.0f, 1e-6f);
    }
}

TEST(MeanValueCoordinates, HaveNoJumpAtEdgesAndCorners) {
  const auto polygon = letterL();
  for (std::uint32_t i = 0; i < 60; ++i) {
    const std::size_t c = i % 6;
    const glm::dvec2 at = glm::mix(polygon[c], polygon[(c + 1) % 6], i < 6 ? 0.0 : 0.1 * (i / 6));
    const auto there = weightsOf(polygon, at);
    for (double away = 1e-16; away < 1e-6; away *= 3) {
      const auto near = weightsOf(polygon, at + away * glm::dvec2(0.6, 0.8));
      for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(near[k], there[k], 30 * away + 3e-7) << i << " " << away;
    }
  }
}

TEST(MeanValueCoordinates, InSpaceMoveWithThePolygonAndGivePlanarPointsBack) {
  const glm::vec3 x(0.6f, 0, 0.8f), y(0, 1, 0), origin(0.1f, 1.6f, -0.05f);
  std::vector<glm::vec3> polygon;
  for (const glm::dvec2 c : regular(6)) polygon.push_back(origin + float(c.x) * x + float(c.y) * y);
  std::vector<float> weights(6);
  for (std::uint32_t i = 0; i < 100; ++i) {
    const glm::dvec2 flat = random(i, 0.02);
    const glm::vec3 p = origin + float(flat.x) * x + float(flat.y) * y;
    meanValueCoordinates(polygon, p + 0.01f * glm::cross(x, y), weights);  // off its plane
    const auto expected = weightsOf(regular(6), flat);
    glm::vec3 back(0);
    for (std::size_t c = 0; c < 6; ++c) {
      EXPECT_NEAR(weights[c], expected[c], 2e-5f);
      back += weights[c] * polygon[c];
    }
    EXPECT_LT(glm::distance(back, p), 5e-7f);
  }
}

TEST(MeanValueCoordinates, OfAFoldedQuadGivePointsOverTheirProjection) {
  const std::vector<glm::vec3> quad = {{0, 0, 0}, {1, 0.3f, 0}, {1, 0, -1}, {0, 0.3f, -1}};
  const FlatPolygon flat(quad);
  EXPECT_NEAR(flat.area, 1, 1e-6);
  EXPECT_NEAR(flat.normal.y, 1, 1e-6);
  std::vector<float> weights(4);
  for (std::uint32_t i = 0; i < 100; ++i) {
    const glm::vec3 p(uniform(i, 1), 0.15f, -uniform(i, 2));
    meanValueCoordinates(quad, p, weights);
    glm::vec3 back(0);
    for (std::size_t c = 0; c < 4; ++c) back += weights[c] * quad[c];
    EXPECT_NEAR(back.x, p.x, 1e-6f);
    EXPECT_NEAR(back.z, p.z, 1e-6f);
    EXPECT_GE(back.y, 0);
    EXPECT_LE(back.y, 0.3f);
  }
}

TEST(MeanValueCoordinates, OfAPolygonWithoutAreaAreEqual) {
  const std::vector<glm::vec3> line = {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}};
  std::vector<float> weights(4);
  meanValueCoordinates(line, {1, 1, 0}, weights);
  for (const float w : weights) EXPECT_EQ(w, 0.25f);
}

TEST(FlatPolygon, ContainsWhatIsInsideAnL) {
  std::vector<glm::vec3> polygon;
  for (const glm::dvec2 c : letterL()) polygon.emplace_back(c.x, c.y, 0);
  const FlatPolygon flat(polygon);
  EXPECT_NEAR(flat.area, 3, 1e-12);
  EXPECT_TRUE(flat.contains(flat.project({0.5, 1.5, 0})));
  EXPECT_TRUE(flat.contains(flat.project({1.5, 0.5, 0})));
  EXPECT_FALSE(flat.contains(flat.project({1.5, 1.5, 0})));
  EXPECT_FALSE(flat.contains(flat.project({-0.5, 0.5, 0})));
}

}  // namespace hair
