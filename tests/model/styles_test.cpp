#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/state_hash.h>
#include <libhair/model/comb.h>
#include <libhair/model/fill_wisps.h>
#include <libhair/model/guide_curve.h>
#include <libhair/model/styles.h>
#include <libhair/motion/motion.h>
#include <libhair/wisps/wisps.h>

namespace hair {
namespace {

constexpr Style kStyles[] = {Style::Smooth, Style::Curly, Style::Long};

struct Grown {
  Head head = builtinHead();
  MeshSdf sdf{head.mesh, 0.004f, 0.05f};
  std::vector<Groom> grooms;
  Grown() {
    for (Style style : kStyles) grooms.push_back(makeGroom(styleSettings(style), sdf));
  }
};

const Grown& grown() {
  static const Grown g;
  return g;
}

std::vector<glm::vec3> drawn(const Groom& groom, std::size_t s) {
  std::vector<glm::vec3> points(groom.first[s + 1] - groom.first[s]);
  drawAtRest(groom, s, points);
  return points;
}

// Between chin and brow, nearer than `degrees` to straight ahead.
bool hidesFace(glm::vec3 p, float degrees) {
  return p.y > -0.02f && p.y < 0.11f && std::atan2(std::abs(p.x), p.z) < glm::radians(degrees);
}

std::uint64_t hash(const Groom& groom) {
  StateHash h;
  const auto add = [&](const auto& v) {
    h.add(std::span(reinterpret_cast<const float*>(v.data()), 3 * v.size()));
  };
  add(groom.guidePoints);
  add(groom.weights);
  add(groom.offsets);
  return h.value();
}

TEST(Styles, CountsAreThoseOfThePaper) {
  const Groom& smooth = grown().grooms[0];
  EXPECT_EQ(smooth.guideCount(), 3u * 134u);
  EXPECT_EQ(smooth.pointsPerGuide, 16u);
  EXPECT_EQ(smooth.strandCount(), 3350u);
  EXPECT_EQ(smooth.pointCount() - smooth.strandCount(), 100'500u);  // segments
  const Groom& curly = grown().grooms[1];
  EXPECT_EQ(curly.strandCount(), 3350u);
  EXPECT_EQ(curly.pointCount() - curly.strandCount(), 201'000u);
}

TEST(Styles, LinksOfAGuideAreEqual) {
  for (const Groom& groom : grown().grooms)
    for (std::size_t g = 0; g < groom.guideCount(); ++g) {
      const auto p = groom.guide(g);
      const float link = glm::distance(p[0], p[1]);
      ASSERT_GT(link, 0.004f);
      for (std::size_t i = 2; i < p.size(); ++i)
        ASSERT_NEAR(glm::distance(p[i - 1], p[i]) / link, 1, 1e-4f) << g << " " << i;
    }
}

TEST(Styles, GuidesKeepClearOfTheHeadAndTheFace) {
  for (const Groom& groom : grown().grooms)
    for (std::size_t g = 0; g < groom.guideCount(); ++g) {
      const auto p = groom.guide(g);
      EXPECT_NEAR(grown().sdf.distance(p[0]), 0, 1e-4f);
      EXPECT_GE(scalpMask(p[0]), 0.25f);
      for (std::size_t i = 1; i < p.size(); ++i) {
        ASSERT_GE(grown().sdf.distance(p[i]), kGuideClearance) << g << " " << i;
        ASSERT_FALSE(hidesFace(p[i], 60)) << g << " " << i;
      }
    }
}

TEST(Styles, GuidesLieOnTheBodyThatStandsStill) {
  const BodyPose pose = Motion::still().pose(0);
  const RigidTransform headFromWorld = inverse(pose.worldFromHead);
  for (const Groom& groom : grown().grooms)
    for (glm::vec3 p : groom.guidePoints)
      for (const Capsule& c : pose.capsules) {
        const glm::vec3 a = headFromWorld.point(c.a), ab = headFromWorld.point(c.b) - a;
        const float along = glm::dot(p - a, ab) / std::max(glm::dot(ab, ab), 1e-12f);
        const float d = glm::distance(p, a + std::clamp(along, 0.0f, 1.0f) * ab) - c.radius;
        ASSERT_GT(d, -0.001f) << p.x << " " << p.y << " " << p.z;
      }
}

TEST(Styles, DrawnHairStaysOutOfTheHeadAndOffTheFace) {
  for (const Groom& groom : grown().grooms)
    for (std::size_t s = 0; s < groom.strandCount(); ++s) {
      const auto p = drawn(groom, s);
      for (std::size_t k = 0; k < p.size(); ++k) {
        ASSERT_TRUE(std::isfinite(p[k].x + p[k].y + p[k].z));
        ASSERT_GE(grown().sdf.distance(p[k]), -5e-4f) << s << " " << k;
        if (k > 0) {
          ASSERT_GE(grown().sdf.distance(0.5f * (p[k - 1] + p[k])), -1e-3f);
        }
        ASSERT_FALSE(hidesFace(p[k], 58)) << s << " " << k;
      }
    }
}

TEST(Styles, WideCurlsHangBesideTheFace) {
  StyleSettings settings = styleSettings(Style::Curly);
  settings.curlRadius = 0.014f;
  settings.seed = 3;
  const Groom groom = makeGroom(settings, grown().sdf);
  for (std::size_t s = 0; s < groom.strandCount(); ++s)
    for (glm::vec3 p : drawn(groom, s)) ASSERT_FALSE(hidesFace(p, 58)) << s;
}

TEST(Styles, EveryStrandHasARootWithinItsWispAndWeightsOfSumOne) {
  for (const Groom& groom : grown().grooms)
    for (std::size_t s = 0; s < groom.strandCount(); ++s) {
      const glm::vec3 w = groom.weights[s];
      ASSERT_NEAR(w.x + w.y + w.z, 1, 1e-5f);
      ASSERT_GE(w.x, w.y);  // the main guide has most weight
      ASSERT_GE(w.x, w.z);
      ASSERT_GT(std::min(w.y, w.z), -0.5f);
      ASSERT_EQ(groom.parents[s].x / 3, groom.parents[s].y / 3);
      ASSERT_EQ(groom.parents[s].x / 3, groom.parents[s].z / 3);
    }
}

TEST(Styles, NoPlaceOfTheScalpIsBald) {
  const Groom& groom = grown().grooms[0];
  std::vector<glm::vec3> roots;
  for (std::size_t s = 0; s < groom.strandCount(); ++s) roots.push_back(drawn(groom, s)[0]);
  float farthest = 0;
  for (glm::vec3 p : grown().head.mesh.positions) {
    if (scalpMask(p) < 0.9f) continue;
    float nearest = 1;
    for (glm::vec3 r : roots) nearest = std::min(nearest, glm::distance(p, r));
    farthest = std::max(farthest, nearest);
  }
  EXPECT_LT(farthest, 0.0065f);
}

TEST(Styles, HairCountIsKeptWhateverIsDrawn) {
  for (std::uint32_t strands : {200u, 3350u, 20'000u}) {
    StyleSettings settings;
    settings.strands = strands;
    settings.points = 16;
    const Groom groom = makeGroom(settings, grown().sdf);
    EXPECT_EQ(groom.strandCount(), strands);
    EXPECT_EQ(groom.pointCount(), 16u * strands);
    EXPECT_NEAR(groom.fibre.hairsPerStrand * static_cast<float>(strands), 100'000, 1);
    EXPECT_EQ(groom.guideCount(), 402u);
  }
}

TEST(Styles, TheSameSeedGivesTheSameBitsForAnyThreadCount) {
  StyleSettings settings = styleSettings(Style::Curly);
  settings.strands = 1000;
  const auto grow = [&](int threads) {
    const ThreadLimit limit(threads);
    return hash(makeGroom(settings, grown().sdf));
  };
  const auto one = grow(1);
  EXPECT_EQ(one, grow(1));
  EXPECT_EQ(one, grow(3));
  ++settings.seed;
  EXPECT_NE(one, grow(1));
}

TEST(Styles, CurlsWindAroundTheGuide) {
  // With curls a drawn strand is much longer than its guide; without, about as long.
  const auto ratio = [](const Groom& groom) {
    double strands = 0, guides = 0;
    for (std::size_t s = 0; s < groom.strandCount(); s += 10) {
      strands += arcLength(drawn(groom, s));
      guides += arcLength(groom.guide(groom.parents[s].x));
    }
    return strands / guides;
  };
  EXPECT_NEAR(ratio(grown().grooms[0]), 1, 0.05);
  EXPECT_GT(ratio(grown().grooms[1]), 1.4);
}

TEST(Styles, RestIsWhatTheWispsStageDraws) {
  for (const Groom& groom : grown().grooms) {
    const GuideStrands guides(groom, {}, {}, &grown().sdf);
    WispSettings settings;
    settings.avoidColliders = false;
    Wisps wisps(groom, guides, settings, &grown().sdf);
    interpolateWisps(guides, {}, wisps);
    for (std::size_t s = 0; s < groom.strandCount(); s += 7) {
      const auto p = drawn(groom, s);
      for (std::size_t k = 0; k < p.size(); ++k)
        ASSERT_LT(glm::distance(p[k], wisps.strands().strand(s)[k]), 1e-5f) << s << " " << k;
    }
  }
}

TEST(Styles, SettingsOutOfRangeAreErrors) {
  const auto grow = [](auto change) {
    StyleSettings settings;
    change(settings);
    return makeGroom(settings, grown().sdf);
  };
  EXPECT_THROW(grow([](auto& s) { s.strands = 100; }), Error);
  EXPECT_THROW(grow([](auto& s) { s.wisps = 0; }), Error);
  EXPECT_THROW(grow([](auto& s) { s.points = 1; }), Error);
  EXPECT_THROW(grow([](auto& s) { s.pointsPerGuide = 2; }), Error);
  EXPECT_THROW(grow([](auto& s) { s.minLength = 0; }), Error);
}

TEST(EqualLinks, CutAPolylineIntoEqualChords) {
  std::vector<glm::vec3> dense;
  for (int i = 0; i <= 300; ++i) {
    const float t = 0.01f * static_cast<float>(i);
    dense.emplace_back(0.1f * std::sin(3 * t), -0.1f * t, 0.05f * t * t);
  }
  std::vector<glm::vec3> points(20);
  equalLinks(dense, points);
  EXPECT_EQ(points.front(), dense.front());
  EXPECT_LT(glm::distance(points.back(), dense.back()), 1e-4f);
  for (std::size_t i = 2; i < points.size(); ++i)
    EXPECT_NEAR(glm::distance(points[i], points[i - 1]), glm::distance(points[1], points[0]),
                1e-6f);
}

TEST(GuideCurve, PassesThroughItsPointsWithFramesThatDoNotTwist) {
  const std::vector<glm::vec3> p = {{0, 0, 0}, {0.1f, 0, 0}, {0.15f, 0.1f, 0}, {0.1f, 0.2f, 0}};
  std::vector<glm::vec3> curve(4);
  sampleGuide(p, curve);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_LT(glm::distance(curve[k], p[k]), 1e-6f);
  std::vector<glm::vec3> fine(31);
  std::vector<glm::mat3> frames(31);
  sampleGuide(p, fine);
  sampleGuideFrames(p, fine, frames);
  // The guide is plane, so what the normal has of the plane's normal is carried unchanged.
  const float out = frames[0][0].z;
  for (const glm::mat3& f : frames) {
    EXPECT_NEAR(glm::determinant(f), 1, 1e-5f);
    EXPECT_NEAR(f[0].z, out, 1e-5f);
  }
}

}  // namespace
}  // namespace hair
