#include <libhair/hair_mesh/grow.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <glm/gtc/quaternion.hpp>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <tests/hair_mesh/sample_meshes.h>

namespace hair {
namespace {

HairMeshRoots rootsOf(const HairMesh& mesh, std::uint32_t strands, std::uint32_t seed = 1) {
  return placeRoots(mesh, {.strands = strands, .seed = seed});
}

StrandSet traced(const HairMesh& mesh, const HairMeshRoots& roots, std::uint32_t points = 16) {
  StrandSet strands;
  traceStrands(mesh, roots, points, strands);
  return strands;
}

/// Chi-square by degree of freedom of roots in 4 x 4 equal cells of each face of the grid, of which
/// `shareOf(cell)` of the roots are expected. One for independent roots; less for evener ones.
template <class ShareOf>
double chiSquare(const HairMeshRoots& roots, std::uint32_t columns, std::uint32_t rows, float size,
                 ShareOf&& shareOf) {
  const std::uint32_t across = 4 * columns, cells = across * 4 * rows;
  std::vector<double> count(cells);
  for (const glm::vec3 p : roots.positions) {
    const auto x = static_cast<std::uint32_t>(p.x / size * 4),
               z = static_cast<std::uint32_t>(p.z / size * 4);
    count[std::min(z * across + x, cells - 1)] += 1;
  }
  double sum = 0;
  for (std::uint32_t c = 0; c < cells; ++c) {
    const double expected = shareOf(c) * static_cast<double>(roots.rootCount());
    sum += (count[c] - expected) * (count[c] - expected) / expected;
  }
  return sum / (cells - 1);
}

bool sameBits(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
  return std::ranges::equal(a, b);
}

HairMesh bentOutward() {
  HairMesh mesh = test::stack(test::gridScalp(3, 3), 4);
  for (std::size_t k = 1; k < mesh.layers.size(); ++k)
    for (glm::vec3& p : mesh.layers[k].positions) {
      const float bend = 0.25f * static_cast<float>(k);
      const glm::vec3 out(p.x - 0.03f, 0, p.z - 0.03f);
      p += bend * out - glm::vec3(0, 0.05f * bend * bend, 0);
    }
  return mesh;
}

}  // namespace

TEST(Roots, AreAsManyAsAsked) {
  const HairMesh mesh = test::stack(test::gridScalp(5, 4), 1);
  for (const std::uint32_t strands : {0u, 1u, 7u, 200u, 12'345u})
    EXPECT_EQ(rootsOf(mesh, strands).rootCount(), strands);
  const auto dense = placeRoots(mesh, {.perSquareMetre = 1e6f});  // on 80 cm^2
  EXPECT_NEAR(static_cast<double>(dense.rootCount()), 8000, 0.5 * 20);
}

TEST(Roots, OfAFewAreAmongThoseOfMore) {
  const HairMesh mesh = test::stack(test::gridScalp(3, 3), 1);
  const auto few = rootsOf(mesh, 500), more = rootsOf(mesh, 700);
  std::set<std::uint32_t> keys;
  for (std::size_t r = 0; r < more.rootCount(); ++r) keys.insert(more.key(r));
  for (std::size_t r = 0; r < few.rootCount(); ++r) EXPECT_TRUE(keys.contains(few.key(r)));
}

TEST(Roots, AreSpreadEvenlyByArea) {
  // Columns of unequal widths, so that faces differ in area.
  PolygonMesh scalp = test::gridScalp(3, 2, 0.02f);
  const HairMesh even = test::stack(scalp, 1);
  for (const std::uint32_t seed : {1u, 2u, 3u})
    EXPECT_LT(chiSquare(rootsOf(even, 9600, seed), 3, 2, 0.02f, [](auto) { return 1.0 / 96; }),
              0.8);
  for (glm::vec3& p : scalp.positions)
    if (p.x > 0.03f && p.x < 0.05f) p.x = 0.035f;
  const auto roots = rootsOf(test::stack(scalp, 1), 9600);
  for (std::uint32_t j = 0; j < 6; ++j) {
    const double width = j % 3 == 0 ? 0.02 : j % 3 == 1 ? 0.015 : 0.025;
    EXPECT_NEAR(roots.firstRoot[j + 1] - roots.firstRoot[j], 9600 * width / 0.12, 1.01);
  }
}

TEST(Roots, LeaveNoGapsThatChanceWouldLeave) {
  const auto roots = rootsOf(test::stack(test::gridScalp(1, 1), 1), 1024);
  // Of 32 x 32 cells, independent roots leave 1/e empty.
  std::set<std::pair<int, int>> cells;
  for (const glm::vec3 p : roots.positions) cells.emplace(int(p.x * 1600), int(p.z * 1600));
  EXPECT_GT(cells.size(), 700u);
}

TEST(Roots, StayInTheirFaceWhateverItsSides) {
  // An L, which is not convex, and a triangle on its last edge.
  const PolygonMesh scalp = {
      .positions = {{0, 0, 0}, {0, 0, 2}, {1, 0, 2}, {1, 0, 1}, {2, 0, 1}, {2, 0, 0}, {1, 0, -1}},
      .firstCorner = {0, 6, 9},
      .corners = {0, 1, 2, 3, 4, 5, 0, 5, 6}};
  const auto roots = rootsOf(test::stack(scalp, 1), 4000);
  EXPECT_NEAR(roots.firstRoot[1], 3000, 1);
  for (std::size_t r = 0; r < 4000; ++r) {
    const glm::vec3 p = roots.positions[r];
    if (roots.bundle[r] == 0)
      EXPECT_TRUE(p.z > -1e-6f && (p.x < 1 + 1e-6f || p.z < 1 + 1e-6f)) << p.x << " " << p.z;
    else
      EXPECT_TRUE(p.z < 1e-6f && p.z > -1 + std::abs(p.x - 1) - 1e-6f) << p.x << " " << p.z;
    EXPECT_EQ(roots.weightsOf(r).size(), roots.bundle[r] == 0 ? 6u : 3u);
  }
}

TEST(Roots, FollowDensity) {
  const HairMesh mesh = test::stack(test::gridScalp(3, 2, 0.02f), 1);
  // Rises within every face from left to right, half as high in the second row; none in the left
  // half of the first column.
  const auto teeth = [](glm::vec3 p) {
    return p.x < 0.01f ? 0.0f : std::fmod(p.x, 0.02f) * (p.z < 0.02f ? 50.0f : 25.0f);
  };
  const auto roots = placeRoots(mesh, {.strands = 9600}, teeth);
  EXPECT_EQ(roots.rootCount(), 9600u);
  for (const glm::vec3 p : roots.positions) EXPECT_GE(p.x, 0.01f);
  const auto share = [](std::uint32_t cell) {
    if (cell % 12 < 2) return 1e-9;
    const double inTooth = (2 * (cell % 4) + 1) / 16.0;  // of the whole tooth, 1
    return inTooth / 4 * (cell < 48 ? 2.0 : 1.0) / (3 * (3 - 0.25));
  };
  // Chance thins the even places: not as even, but more than independent roots (1).
  EXPECT_LT(chiSquare(roots, 3, 2, 0.02f, share), 0.8);
}

TEST(Roots, FollowADensityImageAsSeenFromAbove) {
  DensityImage image{2, 2, {1, 0, 0.5f, 0}, {0, 0}, {0.04f, 0.08f}};
  EXPECT_EQ(image({0.01f, 5, 0.02f}), 1);
  EXPECT_EQ(image({-1, 0, 0.06f}), 0.5f);
  EXPECT_EQ(image({0.03f, 0, 0.02f}), 0);
  EXPECT_NEAR(image({0.02f, 0, 0.04f}), 0.375f, 1e-6f);
  const auto roots = placeRoots(test::stack(test::gridScalp(2, 4), 1), {.strands = 4000}, image);
  std::size_t right = 0, back = 0;
  for (const glm::vec3 p : roots.positions) right += p.x > 0.03f, back += p.z < 0.04f;
  EXPECT_EQ(right, 0u);
  EXPECT_NEAR(static_cast<double>(back) / 4000, (0.02 + 0.875 * 0.02) / (1.5 * 0.04), 0.05);
}

TEST(Roots, StandOnlyWhereHairHasLength) {
  HairMesh mesh = test::stack(test::gridScalp(2, 1), 1);
  HairMesh::Layer& tip = mesh.layers[1];  // bundle 1 ends on the scalp; its own vertices go
  std::fill_n(tip.corners.begin() + 4, 4, kNoVertex);
  mesh.lastLayer[1] = 0;
  const auto roots = rootsOf(mesh, 100);
  EXPECT_EQ(roots.firstRoot, (std::vector<std::uint32_t>{0, 100, 100}));
  mesh.lastLayer[0] = 0;
  EXPECT_THROW(rootsOf(mesh, 100), Error);
}

TEST(Roots, KeepTheirPlacesInTheirFaceWhenAnotherFaceChanges) {
  HairMesh mesh = test::stack(test::gridScalp(4, 4), 1);
  const RootSettings settings{.perSquareMetre = 1e6f};
  const auto before = placeRoots(mesh, settings), beforeCounted = rootsOf(mesh, 6400);
  mesh.layers[0].positions.back() += glm::vec3(0.01f, 0, 0.005f);  // of the last face alone
  const auto after = placeRoots(mesh, settings), afterCounted = rootsOf(mesh, 6400);
  const std::size_t end = before.firstRoot[15];
  ASSERT_EQ(end, after.firstRoot[15]);
  for (std::size_t r = 0; r < end; ++r) {
    EXPECT_EQ(before.key(r), after.key(r));
    EXPECT_EQ(before.positions[r], after.positions[r]);
  }
  EXPECT_GT(after.rootCount(), before.rootCount());
  // With a count that is asked for, others give from the ends of their queues what that face takes.
  EXPECT_EQ(afterCounted.rootCount(), 6400u);
  for (std::uint32_t j = 0; j < 15; ++j) {
    const std::uint32_t a = beforeCounted.firstRoot[j], b = afterCounted.firstRoot[j];
    const std::uint32_t both =
        std::min(beforeCounted.firstRoot[j + 1] - a, afterCounted.firstRoot[j + 1] - b);
    for (std::uint32_t i = 0; i < both; ++i)
      EXPECT_EQ(beforeCounted.positions[a + i], afterCounted.positions[b + i]);
  }
}

TEST(TracedStrands, StartOnTheScalpAndEndInTheTip) {
  const HairMesh mesh = bentOutward();
  const auto roots = rootsOf(mesh, 1000);
  const StrandSet strands = traced(mesh, roots);
  for (std::size_t r = 0; r < roots.rootCount(); ++r) {
    EXPECT_EQ(strands.strand(r).front(), roots.positions[r]);
    EXPECT_NEAR(strands.strand(r).front().y, 0, 1e-9f);
    EXPECT_NEAR(strands.strand(r).back().y, mesh.layers[4].positions[0].y, 1e-6f);
  }
}

TEST(TracedStrands, OfAStraightStackAreStraightAndStayInTheirPrism) {
  HairMesh mesh = test::stack(test::gridScalp(3, 3), 3);
  for (glm::vec3& p : mesh.layers[2].positions) p.y = 0.0305f;  // hardly above layer 1
  const auto roots = rootsOf(mesh, 500);
  const StrandSet strands = traced(mesh, roots, 32);
  for (std::size_t r = 0; r < roots.rootCount(); ++r) {
    const auto strand = strands.strand(r);
    for (std::size_t k = 0; k < 32; ++k) {
      EXPECT_NEAR(strand[k].x, strand[0].x, 1e-7f);
      EXPECT_NEAR(strand[k].z, strand[0].z, 1e-7f);
      EXPECT_NEAR(strand[k].y, 0.09f * static_cast<float>(k) / 31, 1e-4f);
    }
    const std::uint32_t j = roots.bundle[r];
    EXPECT_GE(strand[0].x, 0.02f * static_cast<float>(j % 3) - 1e-7f);
    EXPECT_LE(strand[0].x, 0.02f * static_cast<float>(j % 3 + 1) + 1e-7f);
    EXPECT_GE(strand[0].z, 0.02f * static_cast<float>(j / 3) - 1e-7f);
    EXPECT_LE(strand[0].z, 0.02f * static_cast<float>(j / 3 + 1) + 1e-7f);
  }
}

TEST(TracedStrands, PassTheWeightedPointOfEachLayer) {
  const HairMesh mesh = bentOutward();
  const auto roots = rootsOf(mesh, 50);
  const StrandSet strands = traced(mesh, roots, 2000);
  for (std::size_t r = 0; r < roots.rootCount(); ++r)
    for (std::size_t k = 0; k < 5; ++k) {
      glm::vec3 p(0);
      for (std::size_t i = 0; i < 4; ++i)
        p += roots.weightsOf(r)[i] * mesh.layers[k].positions[mesh.face(k, roots.bundle[r])[i]];
      float nearest = INFINITY;
      for (const glm::vec3 q : strands.strand(r)) nearest = std::min(nearest, glm::distance(p, q));
      EXPECT_LT(nearest, 1e-4f);
    }
}

TEST(TracedStrands, HaveTangentsWithoutJumps) {
  const HairMesh mesh = bentOutward();
  const auto roots = rootsOf(mesh, 50);
  // Bends between segments of a curve with a tangent everywhere shrink with their length; at a
  // corner they stay.
  const auto sharpest = [&](std::uint32_t points) {
    const StrandSet strands = traced(mesh, roots, points);
    float bend = 0;
    for (std::size_t r = 0; r < roots.rootCount(); ++r) {
      const auto s = strands.strand(r);
      for (std::size_t k = 1; k + 1 < s.size(); ++k)
        bend = std::max(
            bend, glm::distance(glm::normalize(s[k] - s[k - 1]), glm::normalize(s[k + 1] - s[k])));
    }
    return bend;
  };
  EXPECT_GT(sharpest(30), 0.02f);  // it is bent at all
  EXPECT_LT(sharpest(300), 0.15f * sharpest(30));
}

TEST(TracedStrands, HavePointsAtEqualLengths) {
  const HairMesh mesh = bentOutward();
  const StrandSet strands = traced(mesh, rootsOf(mesh, 200), 32);
  for (std::size_t r = 0; r < strands.strandCount(); ++r) {
    const float mean = arcLength(strands.strand(r)) / 31;
    for (std::size_t k = 1; k < 32; ++k)
      EXPECT_NEAR(glm::distance(strands.strand(r)[k], strands.strand(r)[k - 1]), mean,
                  0.01f * mean);
  }
}

TEST(TracedStrands, HaveNoLoopsWhereLayersAreCloseOrCoincide) {
  for (const float gap : {0.0f, 1e-9f, 1e-6f, 1e-4f}) {
    HairMesh mesh = test::stack(test::gridScalp(2, 2), 4);
    for (std::size_t k = 2; k <= 4; ++k)
      for (std::size_t v = 0; v < mesh.layers[k].vertexCount(); ++v)
        mesh.layers[k].positions[v] =
            mesh.layers[k == 2 ? 1 : k - 1].positions[v] + glm::vec3(0, k == 2 ? gap : 0.03f, 0);
    for (glm::vec3& p : mesh.layers[4].positions) p.x += 0.02f;
    const StrandSet strands = traced(mesh, rootsOf(mesh, 100), 32);
    for (std::size_t r = 0; r < strands.strandCount(); ++r)
      for (std::size_t k = 1; k < 32; ++k)
        EXPECT_GT(strands.strand(r)[k].y, strands.strand(r)[k - 1].y) << gap;
  }
}

TEST(TracedStrands, OfOtherBundlesAreTheSameBitsWhenAVertexMoves) {
  HairMesh mesh = bentOutward();
  const auto roots = rootsOf(mesh, 900);
  const StrandSet before = traced(mesh, roots);
  mesh.layers[3].positions[0] += glm::vec3(0.02f);  // a corner of bundle 0 alone
  ASSERT_EQ(rootsOf(mesh, 900).positions, roots.positions);
  const StrandSet after = traced(mesh, roots);
  for (std::size_t r = 0; r < roots.rootCount(); ++r)
    EXPECT_EQ(sameBits(before.strand(r), after.strand(r)), roots.bundle[r] != 0) << r;
}

TEST(TracedStrands, MoveWithARigidMotionOfTheMesh) {
  HairMesh mesh = bentOutward();
  const StrandSet before = traced(mesh, rootsOf(mesh, 400));
  const glm::quat turn = glm::angleAxis(1.1f, glm::normalize(glm::vec3(1, 2, -1)));
  const glm::vec3 shift(0.3f, -0.1f, 0.2f);
  for (HairMesh::Layer& layer : mesh.layers)
    for (glm::vec3& p : layer.positions) p = turn * p + shift;
  const StrandSet after = traced(mesh, rootsOf(mesh, 400));  // roots placed again, too
  for (std::size_t i = 0; i < before.pointCount(); ++i)
    EXPECT_LT(glm::distance(turn * before.points[i] + shift, after.points[i]), 1e-6f);
}

TEST(TracedStrands, AreTheSameBitsForAnyNumberOfThreads) {
  const HairMesh mesh = bentOutward();
  const auto density = [](glm::vec3 p) { return 20 * p.x; };
  StrandSet one, three;
  {
    const ThreadLimit limit(1);
    traceStrands(mesh, placeRoots(mesh, {}, density), 32, one);
  }
  const ThreadLimit limit(3);
  traceStrands(mesh, placeRoots(mesh, {}, density), 32, three);
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.first, three.first);
}

TEST(TracedStrands, WantRootsOfTheirMesh) {
  HairMesh mesh = bentOutward();
  const auto roots = rootsOf(mesh, 100);
  StrandSet strands;
  EXPECT_THROW(traceStrands(mesh, roots, 1, strands), Error);
  EXPECT_THROW(traceStrands(test::stack(test::gridScalp(2, 2), 2), roots, 8, strands), Error);
  mesh.lastLayer[3] = 0;
  EXPECT_THROW(traceStrands(mesh, roots, 8, strands), Error);
}

}  // namespace hair
