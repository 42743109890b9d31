#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/random.h>
#include <libhair/density/cell_frame.h>
#include <libhair/light/light.h>

namespace hair {
namespace {

TEST(PointLight, ItsMappingGoesThereAndBack) {
  for (float distance : {0.2f, 0.5f, 3.0f, 1e4f}) {
    const LightSpace light = makePointLightSpace(distance * glm::vec3(0, 0.6f, 0.8f), glm::vec3(0));
    const CellFrame frame = makeCellFrame(light, glm::vec3(0), 5e-3f, 128);
    EXPECT_LT(glm::distance(light.position(), distance * glm::vec3(0, 0.6f, 0.8f)),
              1e-5f * distance);
    for (std::uint32_t i = 0; i < 1000; ++i) {
      const glm::vec3 p = 0.3f * (glm::vec3(uniform(i, 0), uniform(i, 1), uniform(i, 2)) - 0.5f);
      const glm::vec3 u = frame.cellCoordinates(p);
      ASSERT_LT(glm::distance(frame.point(u), p), 2e-6f);
      // Slices are spheres about the light.
      const float radius = glm::distance(p, light.position());
      if (distance < 100) {
        ASSERT_NEAR(u.x * 5e-3f, radius - distance, 1e-6f);
      }
    }
  }
}

TEST(PointLight, ItsCellsAreSquaresThatLookTheSameSizeToTheLight) {
  const LightSpace light = makePointLightSpace({0.1f, 0.3f, -0.2f}, {0, 0, 0});
  const CellFrame frame = makeCellFrame(light, glm::vec3(0), 5e-3f, 128);
  for (std::uint32_t i = 0; i < 500; ++i) {
    const glm::vec3 p = 0.5f * (glm::vec3(uniform(i, 0), uniform(i, 1), uniform(i, 2)) - 0.5f);
    const glm::vec3 ray = light.directionAt(p), u = frame.cellCoordinates(p);
    if (glm::distance(p, light.position()) < 0.05f) continue;
    // A short way across the ray, in any direction, is as long in cells as the magnification says.
    for (int turn = 0; turn < 8; ++turn) {
      const float angle = 0.785398f * static_cast<float>(turn);
      const glm::vec3 y = anyNormal(ray), z = glm::cross(ray, y);
      const glm::vec3 step = 1e-4f * (std::cos(angle) * y + std::sin(angle) * z);
      const glm::vec3 d =
          (frame.cellCoordinates(p + step) - frame.cellCoordinates(p - step)) / 2.0f;
      const float across = std::sqrt(d.y * d.y + d.z * d.z);
      ASSERT_NEAR(across, frame.magnification(u) * 1e-4f / 5e-3f,
                  4e-4f * std::max(1.0f, across / 0.02f));
    }
  }
}

TEST(LightSpace, NeedsADirectionAndAPlaceThatAreNumbers) {
  EXPECT_THROW(makeLightSpace(glm::vec3(0)), Error);
  EXPECT_THROW(makePointLightSpace({0, 0, 0}, {0, 0, 0}), Error);
  EXPECT_THROW(makePointLightSpace({0, NAN, 0}, {0, 0, 0}), Error);
  const Light dark = Light::parallel({0, -1, 0}, {-1, 0, 0});
  EXPECT_THROW(lightSpaceOf(dark, glm::vec3(0)), Error);
}

}  // namespace
}  // namespace hair
