// What drawing takes, apart from what simulating takes.
#include <algorithm>

#include <gtest/gtest.h>

#include <apps/common/results.h>
#include <apps/common/scene_view.h>
#include <apps/draw/gl_context.h>
#include <tests/apps/offscreen_test.h>

namespace hair {
namespace {

StageTime& of(FrameProfile& profile, Stage stage) {
  return profile[static_cast<std::size_t>(stage)];
}

TEST(DrawingTimes, AreMediansAndAddUp) {
  ProfileLog log;
  for (const int ms : {9, 2, 1}) {
    FrameProfile frame{};
    of(frame, Stage::Guides) = {ms * 500'000, 1};
    of(frame, Stage::Shade) = {ms * 500'000, 1};
    of(frame, Stage::Draw) = {ms * 4'000'000, 1};
    log.add(frame);
  }
  EXPECT_EQ(drawingTimes(log, "the CPU (llvmpipe)"),
            "simulated and shadowed 2 ms, drawn 8 ms a frame (median) by the CPU (llvmpipe): 500 "
            "frames a second without drawing, 100 with it");
  EXPECT_EQ(drawingTimes({}, ""), "no drawing was timed");
}

TEST(DrawingTimes, TellSoftwareFromGraphicsCards) {
  EXPECT_TRUE(draw::drawsOnCpu("llvmpipe (LLVM 15.0.6, 256 bits)"));
  EXPECT_TRUE(draw::drawsOnCpu("softpipe"));
  EXPECT_FALSE(draw::drawsOnCpu("NVIDIA GeForce RTX 3060/PCIe/SSE2"));
}

class SceneViewTest : public test::OffscreenTest {};

TEST_F(SceneViewTest, ShadesOncePerPictureAndFramesWithoutPictureNotAtAll) {
  const Character character(fewStrands(300));
  Player player(character, settlesForAMoment());
  FrameProfile& profile = player.profile;
  const auto points = static_cast<std::int64_t>(player.hair.strands().pointCount());
  draw::Renderer renderer({1, 64, 1000});
  SceneView view(player);
  player.step();
  EXPECT_EQ(of(profile, Stage::Shade).items, 0);
  view.drawTimed(renderer, 64, 48);
  const std::vector<std::uint32_t> once = player.hair.colours;
  EXPECT_EQ(of(profile, Stage::Shade).items, points);
  EXPECT_GT(of(profile, Stage::Draw).nanoseconds, 0);
  EXPECT_EQ(of(profile, Stage::Draw).items, points);

  view.drawTimed(renderer, 64, 48);  // stands still
  EXPECT_EQ(of(profile, Stage::Shade).items, points) << "of the last picture alone";
  EXPECT_EQ(player.hair.colours, once);
  view.scene.lights[0].direction = -view.scene.lights[0].direction;
  view.update(renderer);
  EXPECT_EQ(of(profile, Stage::Shade).items, points);
  EXPECT_EQ(of(profile, Stage::Draw).items, 0) << "not timed";
  EXPECT_NE(player.hair.colours, once) << "in another light";
  EXPECT_TRUE(player.hair.radiance.empty()) << "of no use in a picture of bytes";
}

}  // namespace
}  // namespace hair
