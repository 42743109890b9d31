#include <apps/draw/frame_block.h>

#include <algorithm>

namespace hair::draw {

glm::vec3 linearFromSrgb(glm::vec3 c) {
  const glm::vec3 low = c / 12.92f, high = glm::pow((c + 0.055f) / 1.055f, glm::vec3(2.4f));
  return glm::mix(high, low, glm::lessThanEqual(c, glm::vec3(0.04045f)));
}

FrameBlock frameBlock(const Scene& scene, glm::vec4 viewport) {
  const MeshLighting& lighting = scene.meshLighting;
  const Ground& ground = scene.ground;
  const glm::mat4 clipFromView = scene.camera.clipFromView(viewport.z / viewport.w);
  FrameBlock f{};
  f.clipFromWorld = clipFromView * scene.camera.viewFromWorld();
  f.eye = glm::vec4(scene.camera.eye(), 0.5f * viewport.w * clipFromView[1][1]);
  const std::size_t lights = std::min(scene.lights.size(), kMeshLights);
  for (std::size_t l = 0; l < lights; ++l) {
    const Light& light = scene.lights[l];
    const glm::vec3 colour = light.colour * lighting.tint * lighting.intensity;
    f.allLights += glm::vec4(colour, 1);
    if (light.kind == Light::Kind::Point) {
      const glm::vec3 way = scene.pivot - light.position;
      f.lightPlace[l] = glm::vec4(light.position, 1);
      f.lightColour[l] = glm::vec4(colour * glm::dot(way, way), 0);
    } else {
      f.lightPlace[l] = glm::vec4(-glm::normalize(light.direction), 0);
      f.lightColour[l] = glm::vec4(colour, 0);
    }
  }
  f.sky = glm::vec4(glm::vec3(0.93f, 0.97f, 1.0f) * lighting.ambient, 0);
  f.backgroundMiddle = glm::vec4(linearFromSrgb(scene.background.middle), 0);
  f.backgroundEdge = glm::vec4(linearFromSrgb(scene.background.edge), 0);
  f.viewport = viewport;
  f.groundColour = glm::vec4(ground.colour, ground.height);
  f.groundPlace = glm::vec4(scene.camera.target.x, scene.camera.target.z, 0, ground.radius);
  return f;
}

}  // namespace hair::draw
