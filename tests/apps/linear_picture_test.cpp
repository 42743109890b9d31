// Hair's light on its way into a file, through the renderer: it is never bytes.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <unistd.h>

#include <gtest/gtest.h>

#include <apps/common/scene_view.h>
#include <apps/draw/image.h>
#include <libhair/shade/srgb.h>
#include <tests/apps/offscreen_test.h>

namespace hair {
namespace {

class LinearPicture : public test::OffscreenTest {};

TEST_F(LinearPicture, IsOfLightThatWasNeverBytes) {
  Character character(fewStrands(1000));
  // A highlight much brighter than a display.
  character.look.specular = 8;
  Player player(character, settlesForAMoment());
  draw::RenderSettings how{.samples = 1, .linear = true};
  draw::Renderer renderer(how);
  SceneView view(player);
  // Near enough that strands cover whole pixels.
  view.frameHead(0.3f, 0.3f, 0.5f);
  view.drawTimed(renderer, 256, 256);
  float brightest = 0;
  for (const glm::vec3 light : player.hair.radiance) brightest = std::max(brightest, light.x);
  EXPECT_GT(brightest, 2);
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / text("hair_staging_", ::getpid(), ".exr");
  draw::writeImage(renderer.readLinear(), file);
  const draw::LinearPicture picture = draw::readLinearImage(file);
  std::filesystem::remove(file);
  std::size_t above = 0, byteLike = 0;
  for (const float x : picture.rgb) {
    above += x > 1;
    // What an EXR held that was made of bytes: the light of 256 sRGB values, and no other.
    const float s = 255 * srgbFromLinear(x);
    byteLike += x <= 1 && std::abs(s - std::round(s)) < 0.01f;
  }
  EXPECT_GT(above, 50u);
  EXPECT_LT(byteLike, picture.rgb.size() / 10);
}

}  // namespace
}  // namespace hair
