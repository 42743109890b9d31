// What may change in the middle of a performance.
#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include <apps/common/command_line.h>
#include <apps/common/performance.h>

namespace hair {
namespace {

bool sameBits(const std::vector<Lanes>& a, const std::vector<Lanes>& b) {
  return a.size() == b.size() && !a.empty() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(Lanes)) == 0;
}

TEST(Performance, SelfCollisionThatComesLateKnowsTheGroomAtRest) {
  SubjectOptions options;
  options.strands = 300;
  const Subject subject(options);
  PerformanceOptions on, off;
  on.settle = off.settle = 0.02f;
  off.selfCollision = false;
  const Performance early(subject, on);
  Performance late(subject, off);
  for (int i = 0; i < 5; ++i) late.step();
  late.setSelfCollision(true, late.settings.repulsion);
  EXPECT_TRUE(sameBits(early.hair.repulsion.allowed, late.hair.repulsion.allowed));
  late.step();

  RepulsionSettings other = late.settings.repulsion;
  other.kind = RepulsionKind::CellCentre;
  other.strength = 10;
  late.setSelfCollision(true, other);
  EXPECT_FALSE(sameBits(early.hair.repulsion.allowed, late.hair.repulsion.allowed));
  late.step();
  EXPECT_EQ(late.settings.repulsion.strength, 10);

  late.setSelfCollision(false, other);
  late.setSelfCollision(true, other);
  const auto& push = late.hair.repulsion.push;
  EXPECT_TRUE(std::ranges::all_of(push, [](const LaneVec3& p) {
    for (std::size_t l = 0; l < kLanes; ++l)
      if (lane(p, l) != glm::vec3(0)) return false;
    return true;
  })) << "pushes of before it was off";
}

TEST(Performance, LightsStandInTheOrderOfTheCommandLine) {
  const auto lightsOf = [](const std::string& words) {
    CLI::App app;
    PerformanceOptions options;
    int threads = 0;
    addPerformanceOptions(app, options, threads);
    app.parse(words);
    return options.lights;
  };
  EXPECT_TRUE(lightsOf("--fps 30").empty());
  const std::vector<Light> expected = {Light::point({1, 2, 3}),
                                       Light::parallel({-1, 0, 0.5f}, {0.25f, 0, 2}),
                                       Light::point({-0.5f, 1.5f, 0}, {1, 0.5f, 0})};
  EXPECT_EQ(lightsOf("--point 1,2,3 --light -1,0,0.5,0.25,0,2 --fps 30 --point -0.5,1.5,0,1,.5,0"),
            expected);

  SubjectOptions who;
  who.strands = 300;
  const Subject subject(who);
  EXPECT_EQ(frameSettings(subject, {}).lights.size(), 1u);
  PerformanceOptions options;
  options.lights = expected;
  EXPECT_EQ(frameSettings(subject, options).lights.size(), 3u);
}

}  // namespace
}  // namespace hair
