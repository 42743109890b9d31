#include <libhair/hair_mesh/interior_placement.h>

#include <algorithm>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/hair_mesh/surface.h>
#include <tests/hair_mesh/placement_samples.h>

namespace hair {
namespace {

using test::ball;
using test::gridScalp;
using test::moved;
using test::plate;
using test::shaken;
using test::shakenInside;
using test::stack;
using test::waved;

constexpr float kSize = 0.2f;  // of the meshes below, metres, about

// The sum of section 3.3 as it stands there.
double energy(const HairMesh& mesh) {
  double sum = 0;
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j)
    for (std::size_t k = 0; k < mesh.lastLayer[j]; ++k) {
      const auto low = mesh.face(k, j), high = mesh.face(k + 1, j);
      const auto along = [&](std::size_t i) {
        return glm::dvec3(mesh.layers[k + 1].positions[high[i]]) -
               glm::dvec3(mesh.layers[k].positions[low[i]]);
      };
      for (std::size_t i = 0; i < low.size(); ++i) {
        const glm::dvec3 difference = along(i) - along((i + 1) % low.size());
        sum += glm::dot(difference, difference);
      }
    }
  return sum;
}

float farthest(const HairMesh& a, const HairMesh& b) {
  float most = 0;
  for (std::size_t k = 0; k < a.layerCount(); ++k)
    for (std::size_t v = 0; v < a.layers[k].vertexCount(); ++v)
      most = std::max(most, glm::distance(a.layers[k].positions[v], b.layers[k].positions[v]));
  return most;
}

bool sameBits(const HairMesh& a, const HairMesh& b) {
  for (std::size_t k = 0; k < a.layerCount(); ++k)
    if (a.layers[k].positions != b.layers[k].positions) return false;
  return true;
}

HairMesh placed(HairMesh mesh, const PlacementSettings& settings = {}) {
  EXPECT_TRUE(placeInterior(mesh, settings).converged);
  return mesh;
}

std::string refusal(HairMesh mesh, const PlacementSettings& settings = {}) {
  try {
    placeInterior(mesh, settings);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

glm::dvec3 centroid(const HairMesh::Layer& layer) {
  glm::dvec3 sum(0);
  for (const glm::vec3 p : layer.positions) sum += glm::dvec3(p);
  return sum / static_cast<double>(layer.vertexCount());
}

class Placement : public testing::TestWithParam<test::Sample> {
 public:
  HairMesh mesh = GetParam().mesh;
};
INSTANTIATE_TEST_SUITE_P(Of, Placement, testing::ValuesIn(test::samples()), test::nameOf);

TEST_P(Placement, MovesNoVertexThatIsExteriorOrPinned) {
  mesh.layers[2].pinned[8] = 1;
  const HairMesh start = shaken(mesh, 0.05f), end = placed(start);
  const auto exterior = exteriorVertices(start);
  std::size_t free = 0;
  for (std::size_t k = 0; k < start.layerCount(); ++k)
    for (std::size_t v = 0; v < start.layers[k].vertexCount(); ++v) {
      if (exterior[k][v] != 0 || start.layers[k].pinned[v] != 0) {
        ASSERT_EQ(start.layers[k].positions[v], end.layers[k].positions[v]) << k << ' ' << v;
      } else {
        ASSERT_NE(start.layers[k].positions[v], end.layers[k].positions[v]) << k << ' ' << v;
        ++free;
      }
    }
  EXPECT_EQ(InteriorPlacement(start).freeCount(), free);
}

TEST_P(Placement, NeverRaisesTheEnergy) {
  const HairMesh start = shakenInside(mesh, 0.05f);
  double last = energy(start);
  for (std::uint32_t i = 1; i < 40; ++i) {
    PlacementSettings settings;
    settings.maxIterations = i;
    HairMesh end = start;
    placeInterior(end, settings);
    // Places are rounded to floats.
    ASSERT_LE(energy(end), last * (1 + 1e-6)) << "after " << i << " iterations";
    last = energy(end);
  }
  EXPECT_LT(last, 0.9 * energy(start));
}

TEST_P(Placement, EndsWhereNoMoveLowersTheEnergy) {
  const HairMesh end = placed(mesh);
  const double least = energy(end);
  for (std::uint32_t seed = 0; seed < 20; ++seed)
    ASSERT_GT(energy(shakenInside(end, 1e-3f, seed)), least);
}

TEST_P(Placement, DoesNotDependOnWhereInteriorVerticesWere) {
  PlacementSettings settings;
  settings.tolerance = 1e-10f;
  EXPECT_LT(farthest(placed(shakenInside(mesh, 0.1f, 1), settings),
                     placed(shakenInside(mesh, 0.1f, 2), settings)),
            1e-6f * kSize);
}

TEST_P(Placement, LeavesAloneWhatItHasPlaced) {
  PlacementSettings settings;
  settings.tolerance = 1e-6f;  // well above the rounding of places to floats
  const HairMesh end = placed(mesh);
  HairMesh again = end;
  EXPECT_EQ(placeInterior(again, settings).iterations, 0u);
  EXPECT_TRUE(sameBits(again, end));
}

TEST_P(Placement, OfAnAffineImageIsTheImageOfThePlacement) {
  const glm::mat3 turn(0.3f, -1.2f, 0.4f, 0.9f, 0.2f, -0.7f, -0.5f, 0.6f, 1.1f);
  const auto image = [&](const HairMesh& of) {
    return moved(of, [&](glm::vec3 p, std::uint32_t, std::uint32_t) {
      return turn * p + glm::vec3(0.2f, -0.1f, 0.3f);
    });
  };
  PlacementSettings settings;
  settings.tolerance = 1e-10f;
  EXPECT_LT(farthest(placed(image(mesh), settings), image(placed(mesh, settings))), 3e-6f * kSize);
}

TEST_P(Placement, IsTheSameBitsForAnyNumberOfThreads) {
  const HairMesh one = placed(mesh);
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    EXPECT_TRUE(sameBits(placed(mesh), one)) << threads << " threads";
  }
}

TEST_P(Placement, FollowsADragInFewerIterationsThanFromAnywhere) {
  const std::size_t k = mesh.layerCount() - 1;
  InteriorPlacement placement(mesh);
  HairMesh warm = placed(mesh);
  warm.layers[k].positions[0] += glm::vec3(0.003f, 0.001f, -0.002f);
  HairMesh cold = shakenInside(warm, 0.1f);
  const PlacementResult followed = placement.place(warm), found = placement.place(cold);
  EXPECT_TRUE(followed.converged && found.converged);
  EXPECT_GT(followed.iterations, 0u);
  EXPECT_LT(followed.iterations, found.iterations);
  EXPECT_LT(farthest(warm, cold), 1e-5f * kSize);
}

TEST_P(Placement, OfAnEditHasTheBitsOfANewOne) {
  InteriorPlacement placement(mesh);
  placement.place(mesh);
  mesh.layers.back().positions[3].y += 0.01f;
  HairMesh fresh = mesh;
  placement.place(mesh);
  placeInterior(fresh);
  EXPECT_TRUE(sameBits(mesh, fresh));
}

TEST(InteriorPlacement, BringsAStraightStackBack) {
  const HairMesh straight = stack(gridScalp(6, 5), 6, {0.01f, 0.03f, -0.005f});
  EXPECT_LT(farthest(placed(shakenInside(straight, 0.05f)), straight), 1e-6f * kSize);
}

// In whole numbers, so that nothing at all is left to do along y and z.
TEST(InteriorPlacement, MovesNothingAlongAnAxisThatIsRightAlready) {
  const HairMesh straight = stack(gridScalp(5, 5, 1), 5, {0, 1, 0});
  const HairMesh shaken = shakenInside(straight, 0.5f);
  const HairMesh end = placed(moved(straight, [&](glm::vec3 p, std::uint32_t k, std::uint32_t v) {
    return glm::vec3(shaken.layers[k].positions[v].x, p.y, p.z);
  }));
  EXPECT_LT(farthest(end, straight), 5e-6f);
}

// Layers that are the scalp's image, stretched and turned more and more: each edge along a hair is
// an affine function of where it stands, and so is the mean of its neighbours.
TEST(InteriorPlacement, KeepsLayersThatAreAffineImagesOfARegularGrid) {
  const HairMesh turned = moved(stack(gridScalp(6, 5), 6), [](glm::vec3 p, std::uint32_t, auto) {
    const float s = p.y;
    return glm::vec3(p.x * (1 + s) - 2 * s * p.z, s + 3 * s * p.x, p.z * (1 - s) + s * s * p.x);
  });
  EXPECT_LT(farthest(placed(shakenInside(turned, 0.05f)), turned), 2e-6f * kSize);
}

TEST(InteriorPlacement, HasNothingToDoWhereThereIsNoInside) {
  for (const HairMesh& start : {makeHairMesh(gridScalp(4, 4)), stack(gridScalp(4, 4), 1),
                                shaken(stack(gridScalp(1, 9), 5), 0.01f)}) {
    HairMesh mesh = start;
    const PlacementResult result = placeInterior(mesh);
    EXPECT_EQ(result.iterations, 0u);
    EXPECT_TRUE(result.converged && result.unique);
    EXPECT_TRUE(sameBits(mesh, start));
  }
}

TEST(InteriorPlacement, HasNothingToDoWhereAllIsPinned) {
  HairMesh mesh = shaken(stack(gridScalp(4, 4), 4), 0.01f);
  for (HairMesh::Layer& layer : mesh.layers) layer.pinned.assign(layer.vertexCount(), 1);
  const HairMesh start = mesh;
  const PlacementResult result = placeInterior(mesh);
  EXPECT_EQ(result.iterations, 0u);
  EXPECT_EQ(result.residual, 0.0f);
  EXPECT_TRUE(result.converged && result.unique);
  EXPECT_TRUE(sameBits(mesh, start));
}

TEST(InteriorPlacement, TakesPrismsWithoutHeight) {
  const HairMesh flat = stack(gridScalp(5, 5), 4, {0, 0, 0});
  const HairMesh end = placed(shakenInside(flat, 0.02f));
  EXPECT_LT(farthest(end, flat), 1e-6f * kSize);
}

TEST(InteriorPlacement, TakesEdgesWithoutLengthAlongHairAndAcross) {
  HairMesh mesh = waved(stack(gridScalp(5, 5), 4));
  mesh.layers[4].positions[14] = mesh.layers[4].positions[15];
  mesh.layers[1].positions[6] = mesh.layers[0].positions[6];
  mesh.layers[3].positions[12] = mesh.layers[2].positions[12];
  const HairMesh end = placed(mesh);
  EXPECT_LT(energy(end), energy(mesh));
}

TEST(InteriorPlacement, TakesAMeshThatIsOnePoint) {
  const glm::vec3 point(0.1f, -0.2f, 0.3f);
  HairMesh mesh = moved(stack(gridScalp(4, 4), 4), [&](auto...) { return point; });
  const HairMesh start = mesh;
  const PlacementResult result = placeInterior(mesh);
  EXPECT_EQ(result.iterations, 0u);
  EXPECT_TRUE(result.converged);
  EXPECT_TRUE(sameBits(mesh, start));

  // All that is held at one point draws the inside there.
  EXPECT_LT(farthest(placed(shakenInside(start, 0.05f)), start), 1e-6f);
}

// Layer 1 of 2 around a closed scalp: nothing holds it.
TEST(InteriorPlacement, KeepsTheCentroidOfALayerThatNothingHolds) {
  const HairMesh start =
      moved(waved(ball(4, 2)), [](glm::vec3 p, std::uint32_t k, std::uint32_t v) {
        return k == 1 ? p + glm::vec3(0.03f * uniform(v, 0), 0.02f, -0.01f * uniform(v, 1)) : p;
      });
  HairMesh mesh = start;
  const PlacementResult result = placeInterior(mesh);
  EXPECT_TRUE(result.converged);
  EXPECT_FALSE(result.unique);
  EXPECT_LT(glm::distance(centroid(mesh.layers[1]), centroid(start.layers[1])), 1e-7);

  // It differs by a shift alone from where it is when one of its vertices is held.
  HairMesh pinned = start;
  pinned.layers[1].pinned[0] = 1;
  EXPECT_TRUE(placeInterior(pinned).unique);
  const glm::vec3 shift = pinned.layers[1].positions[0] - mesh.layers[1].positions[0];
  EXPECT_GT(glm::length(shift), 1e-3f);
  for (std::size_t v = 0; v < mesh.layers[1].vertexCount(); ++v)
    EXPECT_LT(glm::distance(mesh.layers[1].positions[v] + shift, pinned.layers[1].positions[v]),
              1e-6f * kSize);
}

TEST(InteriorPlacement, IsUniqueOnlyIfEveryLayerIsHeld) {
  HairMesh mesh = ball(3, 4);
  const auto unique = [&] { return placeInterior(mesh).unique; };
  EXPECT_FALSE(unique());
  mesh.layers[1].pinned.back() = 1;
  mesh.layers[2].pinned.back() = 1;
  EXPECT_FALSE(unique());
  mesh.layers[3].pinned.back() = 1;
  EXPECT_TRUE(unique());
}

TEST(InteriorPlacement, SaysThatItHasNotConverged) {
  PlacementSettings settings;
  settings.maxIterations = 2;
  HairMesh mesh = shakenInside(waved(stack(gridScalp(6, 6), 6)), 0.05f);
  const PlacementResult result = placeInterior(mesh, settings);
  EXPECT_EQ(result.iterations, 2u);
  EXPECT_FALSE(result.converged);
  EXPECT_GT(result.residual, settings.tolerance);
}

TEST(InteriorPlacement, RefusesPlacesThatAreNotFinite) {
  InteriorPlacement placement(stack(gridScalp(4, 4), 4));
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    HairMesh mesh = shaken(stack(gridScalp(4, 4), 4), 0.01f);
    const glm::vec3 inside = mesh.layers[2].positions[12];
    mesh.layers[3].positions[2].z = bad;
    EXPECT_THROW(placement.place(mesh), Error);
    EXPECT_EQ(mesh.layers[2].positions[12], inside);
    EXPECT_NE(refusal(mesh), "");
  }
}

TEST(InteriorPlacement, RefusesAToleranceThatIsNotAboveZero) {
  for (const float bad : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity()}) {
    PlacementSettings settings;
    settings.tolerance = bad;
    EXPECT_NE(refusal(stack(gridScalp(4, 4), 4), settings).find("tolerance"), std::string::npos);
  }
}

TEST(InteriorPlacement, RefusesAMeshOfOtherTopologyOrPins) {
  const HairMesh mesh = stack(gridScalp(4, 4), 4);
  InteriorPlacement placement(mesh);
  HairMesh pinned = mesh, taller = stack(gridScalp(4, 4), 5), other = stack(gridScalp(4, 4), 4);
  pinned.layers[2].pinned[12] = 1;
  for (HairMesh::Layer& layer : other.layers)  // the same, seen from another corner of a bundle
    std::rotate(layer.corners.begin(), layer.corners.begin() + 1, layer.corners.begin() + 4);
  for (HairMesh* wrong : {&pinned, &taller, &other}) EXPECT_THROW(placement.place(*wrong), Error);
}

}  // namespace
}  // namespace hair
