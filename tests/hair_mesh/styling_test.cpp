#include <libhair/hair_mesh/grow.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/gtc/quaternion.hpp>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/hair_mesh/grow.h>
#include <libhair/hair_mesh/mesh_groom.h>
#include <libhair/model/fill_wisps.h>
#include <libhair/wisps/wisps.h>
#include <tests/hair_mesh/sample_meshes.h>

namespace hair {
namespace {

// Bends sideways, so that frames turn.
HairMesh bent() {
  HairMesh mesh = test::stack(test::gridScalp(3, 3), 4);
  for (std::size_t k = 1; k < mesh.layers.size(); ++k)
    for (glm::vec3& p : mesh.layers[k].positions)
      p += 0.004f * static_cast<float>(k * k) * glm::vec3(1, -0.6f, 0.3f);
  return mesh;
}

StrandGroup groupOf(const StylingSettings& styling, std::uint32_t strands = 900) {
  StrandGroup group;
  group.strands = strands;
  group.points = 64;
  group.styling = styling;
  return group;
}

GrownHair grown(const HairMesh& mesh, const StylingSettings& styling, std::uint32_t strands = 900) {
  const StrandGroup group = groupOf(styling, strands);
  return growHair(mesh, std::span(&group, 1));
}

StylingSettings everything() {
  StylingSettings s;
  s.lengthCut = 0.1f, s.lengthVariation = 0.2f;
  s.clump = 0.7f, s.clumpSize = 12;
  s.curlRadius = 0.004f;
  s.noise = 0.006f;
  s.frizz = 0.001f, s.frizzShare = 0.5f;
  return s;
}

std::vector<StylingSettings> oneByOne() {
  std::vector<StylingSettings> all(6);
  all[0].lengthCut = 0.3f, all[1].clump = 0.8f, all[2].curlRadius = 0.004f, all[3].noise = 0.006f;
  all[4].frizz = 0.001f, all[5] = everything();
  return all;
}

bool sameBits(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
  return std::ranges::equal(a, b);
}

}  // namespace

TEST(Styling, ByDefaultChangesNothing) {
  const HairMesh mesh = bent();
  const auto roots = placeRoots(mesh, {.strands = 300});
  StrandSet strands;
  traceStrands(mesh, roots, 20, strands);
  const StrandSet before = strands;
  style(mesh, roots, {}, 1, strands);
  EXPECT_EQ(before.points, strands.points);
  EXPECT_EQ(before.first, strands.first);
}

TEST(Styling, NeverMovesRoots) {
  const HairMesh mesh = bent();
  const GrownHair plain = grown(mesh, {});
  for (const StylingSettings& styling : oneByOne()) {
    const GrownHair styled = grown(mesh, styling);
    for (std::size_t s = 0; s < plain.strands.strandCount(); ++s)
      ASSERT_EQ(plain.strands.strand(s).front(), styled.strands.strand(s).front());
    EXPECT_NE(plain.strands.points, styled.strands.points);
    validate(styled.strands, "styled", 2);
  }
}

TEST(Styling, ChangesNothingInOtherBundlesWhenAVertexMoves) {
  HairMesh mesh = bent();
  for (const StylingSettings& styling : oneByOne()) {
    const GrownHair before = grown(mesh, styling);
    HairMesh edited = mesh;
    edited.layers[3].positions[0] += glm::vec3(0.01f, 0.004f, -0.01f);  // of bundle 0 alone
    const GrownHair after = grown(edited, styling);
    ASSERT_EQ(before.strands.strandCount(), after.strands.strandCount());
    for (std::size_t s = 0; s < before.strands.strandCount(); ++s)
      ASSERT_EQ(sameBits(before.strands.strand(s), after.strands.strand(s)),
                before.roots[0].bundle[s] != 0);
  }
}

TEST(Styling, ChangesNothingInOtherBundlesWhenAFaceOfTheScalpTakesMoreRoots) {
  HairMesh mesh = bent();
  StrandGroup group = groupOf(everything());
  group.perSquareMetre = 250'000;
  const GrownHair before = growHair(mesh, std::span(&group, 1));
  mesh.layers[0].positions[0] -= glm::vec3(0.01f, 0, 0.01f);  // of bundle 0 alone
  const GrownHair after = growHair(mesh, std::span(&group, 1));
  const std::uint32_t old = before.roots[0].firstRoot[1], now = after.roots[0].firstRoot[1];
  ASSERT_GT(now, old);
  ASSERT_EQ(before.strands.strandCount() - old, after.strands.strandCount() - now);
  for (std::size_t s = 0; s + old < before.strands.strandCount(); ++s)
    EXPECT_TRUE(sameBits(before.strands.strand(old + s), after.strands.strand(now + s)));
}

TEST(Styling, TurnsWithTheMesh) {
  const HairMesh mesh = bent();
  const glm::quat turn = glm::angleAxis(2.1f, glm::normalize(glm::vec3(1, 2, -1)));
  const glm::vec3 shift(0.3f, -0.1f, 0.2f);
  HairMesh moved = mesh;
  for (HairMesh::Layer& layer : moved.layers)
    for (glm::vec3& p : layer.positions) p = turn * p + shift;
  for (const StylingSettings& styling : oneByOne()) {
    const GrownHair before = grown(mesh, styling), after = grown(moved, styling);
    for (std::size_t i = 0; i < before.strands.pointCount(); ++i)
      ASSERT_LT(glm::distance(turn * before.strands.points[i] + shift, after.strands.points[i]),
                3e-6f);
  }
}

TEST(Styling, IsTheSameBitsForAnyNumberOfThreads) {
  const HairMesh mesh = bent();
  const auto with = [&](int threads) {
    const ThreadLimit limit(threads);
    return grown(mesh, everything()).strands.points;
  };
  EXPECT_EQ(with(1), with(3));
}

TEST(Styling, CutsStrandsToTheirShare) {
  const HairMesh mesh = bent();
  const GrownHair plain = grown(mesh, {});
  StylingSettings styling;
  styling.lengthCut = 0.4f;
  const GrownHair cut = grown(mesh, styling);
  styling.lengthVariation = 0.3f;
  const GrownHair varied = grown(mesh, styling);
  double sum = 0;
  for (std::size_t s = 0; s < plain.strands.strandCount(); ++s) {
    const float whole = arcLength(plain.strands.strand(s));
    EXPECT_NEAR(arcLength(cut.strands.strand(s)) / whole, 0.6f, 1e-3f);
    const float share = arcLength(varied.strands.strand(s)) / whole;
    EXPECT_GT(share, 0.299f);
    EXPECT_LT(share, 0.601f);
    sum += static_cast<double>(share);
    // What is left lies where it was.
    float nearest = INFINITY;
    for (const glm::vec3 p : plain.strands.strand(s))
      nearest = std::min(nearest, glm::distance(p, cut.strands.strand(s).back()));
    EXPECT_LT(nearest, 0.51f * whole / 63);
  }
  EXPECT_NEAR(sum / static_cast<double>(plain.strands.strandCount()), 0.45, 0.01);
}

TEST(Styling, ClumpsBringTipsTogether) {
  const HairMesh mesh = bent();
  StylingSettings styling;
  styling.clumpSize = 20;
  // Mean distance from a tip to the fifth nearest of its bundle.
  const auto apart = [&](float clump) {
    styling.clump = clump;
    const GrownHair hair = grown(mesh, styling);
    double sum = 0;
    for (std::size_t s = 0; s < 900; ++s) {
      std::vector<float> distances;
      for (std::size_t t = 0; t < 900; ++t)
        if (hair.roots[0].bundle[s] == hair.roots[0].bundle[t])
          distances.push_back(
              glm::distance(hair.strands.strand(s).back(), hair.strands.strand(t).back()));
      std::ranges::nth_element(distances, distances.begin() + 5);
      sum += static_cast<double>(distances[5]) / 900;
    }
    return sum;
  };
  const double none = apart(0);
  EXPECT_NEAR(apart(0.5f), 0.5 * none, 0.1 * none);
  EXPECT_LT(apart(1), 0.1 * none);
}

TEST(Styling, ClumpsAreOfOneBundleAndOfAboutTheirSize) {
  const HairMesh mesh = bent();
  StylingSettings styling;
  styling.clump = 1, styling.clumpSize = 25;
  const GrownHair hair = grown(mesh, styling);
  // Tips of a clump are one point.
  std::vector<std::pair<glm::vec3, std::uint32_t>> tips;
  for (std::size_t s = 0; s < 900; ++s) {
    const glm::vec3 tip = hair.strands.strand(s).back();
    const auto same = std::ranges::find_if(
        tips, [&](const auto& t) { return glm::distance(t.first, tip) < 1e-6f; });
    if (same == tips.end())
      tips.emplace_back(tip, hair.roots[0].bundle[s]);
    else
      EXPECT_EQ(same->second, hair.roots[0].bundle[s]);
  }
  EXPECT_EQ(tips.size(), 9u * 4u);  // 100 strands each
  // A strand goes with the nearest of its bundle's first roots.
  const HairMeshRoots& roots = hair.roots[0];
  for (std::size_t s = 0; s < 900; ++s) {
    const std::uint32_t first = roots.firstRoot[roots.bundle[s]];
    std::uint32_t centre = first;
    for (std::uint32_t c = first; c < first + 4; ++c)
      if (glm::distance(roots.positions[c], roots.positions[s]) <
          glm::distance(roots.positions[centre], roots.positions[s]))
        centre = c;
    EXPECT_LT(glm::distance(hair.strands.strand(s).back(), hair.strands.strand(centre).back()),
              1e-6f);
  }
}

TEST(Styling, CurlsAreHelicesAroundTheStrand) {
  const HairMesh mesh = test::stack(test::gridScalp(1, 1, 0.03f), 3, {0, 0.05f, 0});
  StylingSettings styling;
  styling.curlRadius = 0.005f;
  styling.curlPitch = 0.04f;
  styling.curlFromRoot = 0.2f;
  styling.clumpSize = 1;
  const GrownHair plain = grown(mesh, {}, 40), curly = grown(mesh, styling, 40);
  for (std::size_t s = 0; s < 40; ++s) {
    float turned = 0;
    for (std::size_t k = 1; k < 64; ++k) {
      const auto away = [&](std::size_t i) {
        return curly.strands.strand(s)[i] - plain.strands.strand(s)[i];
      };
      const float along = 0.15f * static_cast<float>(k) / 63;
      EXPECT_NEAR(away(k).y, 0, 1e-6f);
      EXPECT_EQ(glm::length(away(k)) == 0, along < 0.03f);
      if (along < 0.03f + 1.2f * 0.04f) continue;
      EXPECT_NEAR(glm::length(away(k)), 0.005f, 1e-5f);
      const glm::vec3 a = glm::normalize(away(k - 1)), b = glm::normalize(away(k));
      turned += std::atan2(glm::cross(a, b).y, glm::dot(a, b));
    }
    // Over 0.072 m, and a step at most, at a pitch that varies by a fifth.
    EXPECT_GT(std::abs(turned) / 6.2831853f, 0.072f / (1.2f * 0.04f));
    EXPECT_LT(std::abs(turned) / 6.2831853f, 0.0744f / (0.8f * 0.04f));
  }
}

TEST(Styling, StrandsOfAClumpCurlAlike) {
  const HairMesh mesh = test::stack(test::gridScalp(1, 1, 0.03f), 3, {0, 0.05f, 0});
  StylingSettings styling;
  styling.curlRadius = 0.005f;
  styling.clumpSize = 1000;
  const GrownHair plain = grown(mesh, {}, 40), curly = grown(mesh, styling, 40);
  const glm::vec3 first = curly.strands.strand(0).back() - plain.strands.strand(0).back();
  for (std::size_t s = 1; s < 40; ++s)
    EXPECT_LT(glm::distance(curly.strands.strand(s).back() - plain.strands.strand(s).back(), first),
              1e-4f);
}

TEST(Styling, NoiseGrowsTowardsTheTipAndStaysWithinItsBound) {
  const HairMesh mesh = bent();
  const GrownHair plain = grown(mesh, {});
  StylingSettings noise, frizz;
  noise.noise = 0.01f;
  frizz.frizz = 0.002f, frizz.frizzShare = 0.3f;
  const GrownHair noisy = grown(mesh, noise), frizzy = grown(mesh, frizz);
  float greatest = 0;
  std::size_t touched = 0;
  for (std::size_t s = 0; s < 900; ++s) {
    bool moved = false;
    for (std::size_t k = 0; k < 64; ++k) {
      const glm::vec3 p = plain.strands.strand(s)[k];
      const float slow = glm::distance(noisy.strands.strand(s)[k], p);
      const float quick = glm::distance(frizzy.strands.strand(s)[k], p);
      EXPECT_LE(slow, 0.01f * 1.02f * static_cast<float>(k) / 63 + 1e-6f);
      EXPECT_LE(quick, 0.002f + 1e-6f);
      greatest = std::max(greatest, slow);
      moved |= quick > 0;
    }
    touched += moved;
  }
  EXPECT_GT(greatest, 0.007f);
  EXPECT_NEAR(static_cast<double>(touched) / 900, 0.3, 0.05);
}

TEST(Styling, RefusesWhatIsOutOfRange) {
  const HairMesh mesh = bent();
  const auto with = [](auto&& change) {
    StylingSettings s;
    change(s);
    return s;
  };
  for (const StylingSettings& bad :
       {with([](auto& s) { s.lengthCut = 1; }),
        with([](auto& s) { s.lengthCut = 0.5f, s.lengthVariation = 0.6f; }),
        with([](auto& s) { s.clump = 1.1f; }), with([](auto& s) { s.clumpSize = 0; }),
        with([](auto& s) { s.curlRadius = -1; }), with([](auto& s) { s.curlPitch = 0; }),
        with([](auto& s) { s.curlFromRoot = 1; }), with([](auto& s) { s.noise = NAN; }),
        with([](auto& s) { s.noiseLength = 0; }), with([](auto& s) { s.frizzLength = -1; }),
        with([](auto& s) { s.frizzShare = 2; })})
    EXPECT_THROW(grown(mesh, bad), Error);
}

TEST(GrownHair, IsTheUnionOfItsGroups) {
  const HairMesh mesh = bent();
  StylingSettings frizz;
  frizz.frizz = 0.002f;
  std::vector<StrandGroup> groups = {groupOf({}, 500), groupOf(frizz, 100)};
  groups[1].seed = 7;
  groups[1].points = 100;
  const GrownHair both = growHair(mesh, groups);
  const GrownHair base = growHair(mesh, std::span(groups).first(1));
  const GrownHair added = growHair(mesh, std::span(groups).last(1));
  ASSERT_EQ(both.strands.strandCount(), 600u);
  for (std::size_t s = 0; s < 600; ++s) {
    EXPECT_EQ(both.group[s], s < 500 ? 0u : 1u);
    const auto alone = s < 500 ? base.strands.strand(s) : added.strands.strand(s - 500);
    EXPECT_TRUE(sameBits(both.strands.strand(s), alone));
  }
}

TEST(GrownHair, GrownAgainAfterAnEditIsAsGrownAnew) {
  HairMesh mesh = bent();
  const std::vector<StrandGroup> groups = {groupOf(everything(), 500), groupOf({}, 100)};
  GrownHair hair = growHair(mesh, groups);
  for (glm::vec3& p : mesh.layers[2].positions) p.x += 0.01f;
  regrow(mesh, groups, hair);
  EXPECT_EQ(hair.strands.points, growHair(mesh, groups).strands.points);
  EXPECT_THROW(regrow(mesh, std::span(groups).first(1), hair), Error);
}

TEST(WispGroom, DrawsStrandsFromRootsOfTheirOwnAlongTheCurves) {
  const HairMesh mesh = bent();
  WispCurveSettings settings;
  settings.curves.strands = 60;
  settings.curves.styling.noise = 0.01f;
  settings.fill.strands = 2000;
  settings.fill.wholeShare = 0, settings.fill.tipShare = 0;
  const Groom groom = wispGroom(mesh, settings);
  ASSERT_EQ(groom.guideCount(), 60u);
  ASSERT_EQ(groom.strandCount(), 2000u);
  const auto roots = placeRoots(mesh, {.strands = 2000, .seed = settings.fill.seed});
  const auto curves = placeRoots(mesh, {.strands = 60, .seed = settings.curves.seed});
  std::vector<glm::vec3> points(settings.fill.points);
  for (std::size_t s = 0; s < 2000; ++s) {
    drawAtRest(groom, s, points);
    EXPECT_LT(glm::distance(points.front(), roots.positions[s]), 1e-6f);
    const std::uint32_t wisp = groom.parents[s].x;
    EXPECT_EQ(curves.bundle[wisp], roots.bundle[s]);
    // Its place in the wisp shrinks to `spread` of what it was.
    const auto guide = groom.guide(wisp);
    EXPECT_NEAR(glm::distance(points.back(), guide.back()),
                settings.fill.spread * glm::distance(points.front(), guide.front()), 1e-5f);
  }
  for (std::size_t w = 0; w < 60; ++w) {
    const auto guide = groom.guide(w);
    const float link = glm::distance(guide[0], guide[1]);
    EXPECT_EQ(guide[0], curves.positions[w]);
    for (std::size_t k = 2; k < guide.size(); ++k)
      EXPECT_NEAR(glm::distance(guide[k - 1], guide[k]), link, 1e-4f * link);
  }
}

TEST(WispGroom, IsDrawnFromItsGuidesAsItIsAtRest) {
  WispCurveSettings settings;
  settings.curves.strands = 40;
  settings.fill.strands = 300;
  const Groom groom = wispGroom(bent(), settings);
  const GuideStrands guides(groom, {});
  Wisps wisps(groom, guides);
  interpolateWisps(guides, {}, wisps);
  std::vector<glm::vec3> points(settings.fill.points);
  for (std::size_t s = 0; s < 300; ++s) {
    drawAtRest(groom, s, points);
    for (std::size_t k = 0; k < points.size(); ++k)
      EXPECT_LT(glm::distance(points[k], wisps.strands().strand(s)[k]), 1e-4f);
  }
}

}  // namespace hair
