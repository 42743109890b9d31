// What the command line says of a player.
#include <gtest/gtest.h>

#include <apps/common/command_line.h>
#include <apps/common/player.h>

namespace hair {
namespace {

TEST(Player, LightsStandInTheOrderOfTheCommandLine) {
  const auto lightsOf = [](const std::string& words) {
    CLI::App app;
    PlayerOptions options;
    int threads = 0;
    addPlayerOptions(app, options, threads);
    app.parse(words);
    return options.lights;
  };
  EXPECT_TRUE(lightsOf("--fps 30").empty());
  const std::vector<Light> expected = {Light::point({1, 2, 3}),
                                       Light::parallel({-1, 0, 0.5f}, {0.25f, 0, 2}),
                                       Light::point({-0.5f, 1.5f, 0}, {1, 0.5f, 0})};
  EXPECT_EQ(lightsOf("--point 1,2,3 --light -1,0,0.5,0.25,0,2 --fps 30 --point -0.5,1.5,0,1,.5,0"),
            expected);

  CharacterOptions who;
  who.strands = 300;
  const Character character(who);
  EXPECT_EQ(frameSettings(character, {}).lights.size(), 1u);
  PlayerOptions options;
  options.lights = expected;
  EXPECT_EQ(frameSettings(character, options).lights.size(), 3u);
}

}  // namespace
}  // namespace hair
