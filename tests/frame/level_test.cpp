// Laws of hair at a level of detail, through the whole pipeline.
#include <libhair/wisps/wisps.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/core/state_hash.h>
#include <libhair/shade/appearance.h>
#include <libhair/shadow/density_map.h>
#include <libhair/wisps/bind.h>
#include <tests/frame/scene.h>

namespace hair {
namespace {

LevelOfDetail levelOf(float strands, float points = 1, float cellSize = 0) {
  LevelOfDetail level;
  level.strands = strands, level.points = points, level.cellSize = cellSize;
  return level;
}

std::uint64_t guidesOf(const Hair& hair) {
  StateHash hash;
  hair.guides.addTo(hash);
  return hash.value();
}

// Strands of 0.2 m side by side, as a curtain 4 cm thick across light along -z.
const Groom& curtain() {
  static const Groom groom = [] {
    constexpr std::uint32_t kStrands = 6000;
    StrandSet strands;
    for (std::uint32_t s = 0; s < kStrands; ++s) {
      std::vector<glm::vec3> points;
      for (std::uint32_t k = 0; k < 21; ++k)
        points.emplace_back(0.2f * uniform(s, 0) - 0.1f, -0.01f * static_cast<float>(k),
                            0.04f * uniform(s, 1));
      strands.append(points);
    }
    return bindGroom(strands, {16, 8, 0.5f}, kStrands);
  }();
  return groom;
}

// The curtain at a level, and light behind it.
struct LitCurtain {
  GroomDetail detail{curtain()};
  GuideStrands guides{curtain(), {}};
  Wisps wisps{curtain(), guides};
  DensityMap map;
  std::vector<glm::vec3> behind;

  LitCurtain() {
    for (int x = -70; x <= 70; x += 5)
      for (int y = 4; y <= 18; ++y)
        behind.emplace_back(static_cast<float>(x) * 1e-3f, static_cast<float>(y) * -0.01f, -0.02f);
  }
  std::vector<float> at(const LevelOfDetail& level, Deposit how = Deposit::Columns) {
    setLevel(detail, level, wisps);
    interpolateWisps(guides, {}, wisps);
    DensityMapSettings settings;
    settings.deposit = how;
    clear(map, settings, makeLightSpace({0, 0, -1}));
    deposit(wisps.drawnHair(), map);
    computeTransmittance(map);
    std::vector<float> t(behind.size());
    sampleTransmittance(map, behind, t);
    return t;
  }
  // Sum over the map, of optical depth.
  double depth() const {
    double sum = 0;
    const DensityGrid& grid = map.grid;
    for (int i = grid.lower.x; i <= grid.upper.x; ++i)
      for (int j = grid.lower.y; j <= grid.upper.y; ++j)
        for (int k = grid.lower.z; k <= grid.upper.z; ++k) sum += grid.count({i, j, k});
    return sum * static_cast<double>(grid.quantum);
  }
};

double mean(const std::vector<float>& values) {
  double sum = 0;
  for (const float v : values) sum += static_cast<double>(v);
  return sum / static_cast<double>(values.size());
}

double area(const Wisps& wisps) {
  const StrandView strands = wisps.strands();
  double sum = 0;
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    sum += static_cast<double>(arcLength(strands.strand(s)) *
                               (wisps.drawn.weights.empty() ? 1 : wisps.drawn.weights[s]));
  return sum * static_cast<double>(wisps.fibre().hairsPerStrand * wisps.fibre().width);
}

TEST(Level, OfAllStrandsHasTheBitsOfHairWithoutLevels) {
  FrameSettings settings;
  test::Scene plain(test::small(Style::Smooth), Motion::dance(), settings);
  test::Scene levelled(test::small(Style::Smooth), Motion::dance(), settings);
  const GroomDetail detail(levelled.groom);
  levelled.hair.detail = &detail;
  levelled.hair.level = levelFor(detail, 1e5f);
  for (int f = 0; f < 5; ++f) {
    plain.step(), levelled.step();
    // And comes back to them.
    if (f == 2) levelled.hair.level = levelOf(0.3f, 0.5f, 0.02f), redraw(levelled.hair);
    if (f == 2) levelled.hair.level = {};
  }
  EXPECT_EQ(levelled.hash(), plain.hash());
  EXPECT_EQ(levelled.hair.transmittance, plain.hair.transmittance);
  EXPECT_EQ(levelled.hair.colours, plain.hair.colours);
}

TEST(Level, ThatChangesEveryFrameLeavesTheGuidesTheirBits) {
  FrameSettings settings = test::Scene::simulationOnly();
  settings.wind.velocity = {3, 0, 1};
  settings.repulsion.threshold = 0, settings.repulsion.tolerance = 1;  // pushes for sure
  test::Scene plain(test::small(Style::Curly), Motion::dance(), settings);
  test::Scene changing(test::small(Style::Curly), Motion::dance(), settings);
  const GroomDetail detail(changing.groom);
  changing.hair.detail = &detail;
  for (int f = 0; f < 30; ++f) {
    changing.hair.level = levelOf(0.05f + 0.9f * uniform(static_cast<std::uint32_t>(f), 0),
                                  0.2f + 0.8f * uniform(static_cast<std::uint32_t>(f), 1), 0.03f);
    plain.step(), changing.step();
    ASSERT_EQ(guidesOf(changing.hair), guidesOf(plain.hair)) << "frame " << f;
  }
  EXPECT_LT(changing.hair.wisps.points.size(), plain.hair.wisps.points.size());
}

TEST(Level, KeepsRootsAndTipsOfTheStrandsThatStay) {
  test::Scene plain(test::small(Style::Curly), Motion::dance());
  test::Scene less(test::small(Style::Curly), Motion::dance());
  const GroomDetail detail(less.groom);
  less.hair.detail = &detail;
  less.hair.level = levelOf(0.3f, 0.4f);
  for (int f = 0; f < 3; ++f) plain.step(), less.step();
  std::size_t drawn = 0;
  for (std::size_t s = 0; s < less.groom.strandCount(); ++s) {
    const auto few = less.hair.strands().strand(s), all = plain.hair.strands().strand(s);
    if (few.empty()) continue;
    ++drawn;
    ASSERT_LT(few.size(), all.size());
    EXPECT_EQ(few.front(), all.front());
    EXPECT_EQ(few.back(), all.back());
  }
  EXPECT_NEAR(static_cast<double>(drawn), 0.3 * 1.25 * 240, 3);
}

TEST(Level, HasTheSameBitsForAnyNumberOfThreads) {
  const auto run = [](int threads) {
    const ThreadLimit limit(threads);
    test::Scene scene(test::small(Style::Curly), Motion::dance(), {});
    const GroomDetail detail(scene.groom);
    scene.hair.detail = &detail;
    scene.hair.level = levelOf(0.4f, 0.6f, 0.01f);
    for (int f = 0; f < 3; ++f) scene.step();
    return std::pair(scene.hash(), scene.hair.colours);
  };
  EXPECT_EQ(run(1), run(4));
}

TEST(Level, KeepsTheAreaThatHairCovers) {
  for (const Style style : {Style::Smooth, Style::Curly}) {
    StyleSettings settings = styleSettings(style);
    settings.strands = 1500;
    const Groom groom = makeGroom(settings, test::headCollider());
    const GroomDetail detail(groom);
    const GuideStrands guides(groom, {});
    Wisps wisps(groom, guides);
    const double whole = area(wisps);
    for (const float strands : {0.7f, 0.2f, 0.05f})
      for (const float points : {1.0f, 0.5f, 0.15f}) {
        const LevelOfDetail level = levelOf(strands, points);
        setLevel(detail, level, wisps);
        interpolateWisps(guides, {}, wisps);
        EXPECT_NEAR(area(wisps) / whole, 1, 0.02) << strands << " " << points;
        const Groom few = groomAt(groom, detail, level);
        const GuideStrands sameGuides(few, {});
        EXPECT_NEAR(area(Wisps(few, sameGuides)) / whole, 1, 0.01) << strands << " " << points;
      }
  }
}

TEST(Level, KeepsTheMeanLightBehindACurtain) {
  LitCurtain lit;
  const double whole = mean(lit.at({})), depth = lit.depth();
  EXPECT_NEAR(whole, std::exp(-6000 * 80e-6 * 0.6 / 0.2), 0.02);
  for (const float strands : {0.8f, 0.5f, 0.25f, 0.1f}) {
    // Fewer strands are less even, and light finds more ways: by half of the variance of depth.
    EXPECT_NEAR(mean(lit.at(levelOf(strands))), whole, 0.01) << strands;
    EXPECT_NEAR(lit.depth() / depth, 1, 0.003) << strands;
  }
  EXPECT_NEAR(mean(lit.at(levelOf(1, 0.3f))), whole, 0.003);
}

// The largest change of light at a point, and of all depth, while the level goes down in small
// steps.
std::pair<double, double> largestChange(float fade, Deposit how) {
  LitCurtain lit;
  LevelOfDetail level = levelOf(0.2f);
  level.fade = fade;
  std::vector<float> before = lit.at(level, how);
  double depthBefore = lit.depth(), light = 0, depth = 0;
  for (int step = 0; step < 60; ++step) {
    level.strands *= 1 - 1e-4f;
    const std::vector<float> now = lit.at(level, how);
    for (std::size_t i = 0; i < now.size(); ++i)
      light = std::max(light, std::abs(static_cast<double>(now[i] - before[i])));
    depth = std::max(depth, std::abs(lit.depth() / depthBefore - 1));
    before = now, depthBefore = lit.depth();
  }
  return {light, depth};
}

TEST(Level, LightChangesAsLittleAsTheLevelDoes) {
  for (const Deposit how : {Deposit::Columns, Deposit::Segments}) {
    const auto [light, depth] = largestChange(0.25f, how);
    // Steps of 1e-4: a strand fades by 4e-4 to 5e-4 of its width in each, and 10 are at a point.
    EXPECT_LT(light, 4e-4) << static_cast<int>(how);
    EXPECT_LT(depth, 1e-4) << static_cast<int>(how);
    // Strands that vanish at once are seen to.
    EXPECT_GT(largestChange(1e-4f, how).first, 10 * light) << static_cast<int>(how);
  }
}

TEST(Level, AFadedStrandIsAsFaintAsItIsNarrow) {
  LitCurtain lit;
  lit.at(levelOf(0.3f));
  const DrawnPart& drawn = lit.wisps.drawn;
  std::vector<std::uint32_t> colours(lit.wisps.points.size(), 0xff123456u);
  fadeColours(drawn.first, drawn.weights, colours);
  int faded = 0;
  for (std::size_t s = 0; s < drawn.weights.size(); ++s)
    for (std::uint32_t p = drawn.first[s]; p < drawn.first[s + 1]; ++p) {
      EXPECT_EQ(colours[p] & 0xffffffu, 0x123456u);
      EXPECT_NEAR(static_cast<float>(colours[p] >> 24) / 255, drawn.weights[s], 0.003f);
      faded += drawn.weights[s] < 1;
    }
  EXPECT_GT(faded, 0);
}

TEST(Level, AStrandOfHalfTheWidthDarkensHalfAsMuch) {
  StrandSet strands;
  strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0.011f, 0.013f, 0.002f}, {0.03f, 0.02f, 0}});
  strands.append(std::vector<glm::vec3>{{0, 0.05f, 0}, {0.012f, 0.06f, 0.01f}});
  const Fibre fibre{80e-6f, 0.6f, 30};
  for (const Deposit how : {Deposit::Columns, Deposit::Segments})
    for (const float weight : {0.0f, 0.25f, 0.5f, 0.9f, 1.0f}) {
      const auto depthOf = [&](std::span<const float> weights) {
        LitCurtain lit;
        DensityMapSettings settings;
        settings.deposit = how;
        clear(lit.map, settings, makeLightSpace({0, 0, -1}));
        deposit(DrawnHair{strands, fibre, weights}, lit.map);
        return lit.depth();
      };
      const double one = depthOf(std::vector<float>{1, 0}), two = depthOf(std::vector<float>{0, 1});
      EXPECT_NEAR(depthOf(std::vector<float>{1, weight}), one + static_cast<double>(weight) * two,
                  1e-5 * (one + two));
      EXPECT_EQ(depthOf(std::vector<float>{1, 1}), depthOf({}));
    }
}

TEST(Level, LargerCellsHoldTheSameExtent) {
  const DensityMapSettings settings;
  const DensityMapSettings coarse = mapAt(levelOf(1, 1, 0.02f), settings);
  EXPECT_EQ(coarse.cellSize, 0.02f);
  EXPECT_GE(coarse.extent(), settings.extent());
  EXPECT_LT(coarse.cells, settings.cells / 2);
  EXPECT_EQ(mapAt(levelOf(1, 1, 1e-3f), settings).cellSize, settings.cellSize);
}

TEST(Level, NeedsTheDetailOfItsOwnGroom) {
  test::Scene scene(test::small(Style::Smooth), Motion::dance());
  scene.hair.level = levelOf(0.5f);
  EXPECT_THROW(scene.step(), Error);
  const GroomDetail other(curtain());
  scene.hair.detail = &other;
  EXPECT_THROW(scene.step(), Error);
  const GroomDetail detail(scene.groom);
  scene.hair.detail = &detail;
  EXPECT_NO_THROW(scene.step());
  scene.hair.level.points = NAN;
  EXPECT_THROW(scene.step(), Error);
}

}  // namespace
}  // namespace hair
