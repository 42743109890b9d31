#include <apps/draw/light_maps.h>

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include <apps/draw/shaders.h>
#include <libhair/core/transform.h>

namespace hair::draw {
namespace {

constexpr int kFloorSize = 128;        // pixels of the floor's occlusion map
constexpr float kFloorReach = 0.6f;    // it goes this far beyond the meshes, metres
constexpr float kFloorCeiling = 1.5f;  // what is higher over the floor hides too little to matter

gl::Program makeOcclude() {
  const auto s = shaders::floorOcclusion();
  return gl::link("floor occlusion", s.vertex, s.geometry, s.fragment);
}

void allocate(const gl::Texture& texture, GLint internal, int size, GLenum format, GLenum type,
              float border) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, internal, size, size, 0, format, type, nullptr);
  const float colour[] = {border, border, border, border};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, colour);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void attach(const gl::Framebuffer& target, const gl::Texture* colour, const gl::Texture* depth,
            const char* name) {
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  if (colour) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *colour, 0);
  } else {
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }
  if (depth) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, *depth, 0);
  gl::requireComplete(name);
}

void bindTexture(GLuint unit, const gl::Texture& texture) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
}

struct LightView {
  glm::mat4 clipFromWorld;
  float texel;  // metres
};

/// A square as the light sees it around all that casts shadows. Its side grows in steps and its
/// middle moves by whole pixels, so that shadow edges do not swim while the subject moves.
LightView lightView(glm::vec3 towardsLight, const Bounds& casters, int size) {
  const glm::vec3 z = towardsLight, x = anyNormal(z), y = glm::cross(z, x);
  const glm::mat3 lightFromWorld = glm::transpose(glm::mat3(x, y, z));
  Bounds seen;
  for (int i = 0; i < 8; ++i) {
    seen.extend(lightFromWorld * glm::vec3(i & 1 ? casters.upper.x : casters.lower.x,
                                           i & 2 ? casters.upper.y : casters.lower.y,
                                           i & 4 ? casters.upper.z : casters.lower.z));
  }
  constexpr float kStep = 0.25f;
  const float wanted = std::max(seen.size().x, seen.size().y) + 0.02f;
  const float side = kStep * std::ceil(wanted / kStep), texel = side / float(size);
  const glm::vec2 corner =
      texel * glm::floor((glm::vec2(seen.centre()) - 0.5f * side) / texel + 0.5f);
  const float margin = 0.05f;
  const glm::mat4 clipFromLight = glm::ortho(corner.x, corner.x + side, corner.y, corner.y + side,
                                             -seen.upper.z - margin, -seen.lower.z + margin);
  return {clipFromLight * glm::mat4(lightFromWorld), texel};
}

const glm::mat4 kTextureFromClip =
    glm::scale(glm::translate(glm::mat4(1), glm::vec3(0.5f)), glm::vec3(0.5f));

}  // namespace

LightMaps::LightMaps(int size_) : size(size_), occlude(makeOcclude()) {
  allocate(meshDepth, GL_DEPTH_COMPONENT24, size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  allocate(hairDepth, GL_R16F, size, GL_RED, GL_FLOAT, 0);
  allocate(lowest, GL_DEPTH_COMPONENT24, kFloorSize, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1);
  allocate(occlusion, GL_R8, kFloorSize, GL_RED, GL_UNSIGNED_BYTE, 1);
  attach(meshTarget, nullptr, &meshDepth, "mesh shadow");
  attach(hairTarget, &hairDepth, &meshDepth, "hair shadow");
  attach(lowestTarget, nullptr, &lowest, "floor heights");
  attach(occlusionTarget, &occlusion, nullptr, "floor occlusion");
}

void LightMaps::update(const Scene& scene, const MeshStore& meshes, HairPass& hair,
                       FrameBlock& frame) {
  Bounds casters = meshes.worldBounds(scene);
  const Bounds h = hair.worldBounds();
  if (h.lower.x <= h.upper.x) casters.extend(h.lower), casters.extend(h.upper);
  if (casters.lower.x > casters.upper.x) casters.extend(glm::vec3(0));
  const LightView view = lightView(glm::vec3(frame.towardsLight), casters, size);
  frame.shadowFromWorld = kTextureFromClip * view.clipFromWorld;
  frame.towardsLight.w = view.texel;
  frame.shadowTexel = glm::vec4(1.0f / float(size), 0, 0, 0);

  glViewport(0, 0, size, size);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glBindFramebuffer(GL_FRAMEBUFFER, meshTarget);
  glClearDepth(1);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2, 4);
  meshes.drawDepth(scene, view.clipFromWorld);
  glDisable(GL_POLYGON_OFFSET_FILL);

  glBindFramebuffer(GL_FRAMEBUFFER, hairTarget);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  hair.drawDepth(scene, view.clipFromWorld, view.texel);

  updateFloor(scene, meshes, frame);
  bindTexture(2, occlusion);
  bindTexture(1, hairDepth);
  bindTexture(0, meshDepth);
}

void LightMaps::updateFloor(const Scene& scene, const MeshStore& meshes, FrameBlock& frame) {
  const Bounds b = meshes.worldBounds(scene);
  frame.floorMap = glm::vec4(0);
  if (!scene.ground.visible || b.lower.x > b.upper.x) return;
  if (b.lower.y > scene.ground.height + 0.5f) return;
  const float side = std::max(b.size().x, b.size().z) + 2 * kFloorReach;
  const glm::vec3 centre = b.centre();
  const glm::vec3 corner(centre.x - 0.5f * side, scene.ground.height, centre.z - 0.5f * side);
  frame.floorMap = glm::vec4(corner.x, corner.z, 1 / side, 1);

  // Looking up from the floor: clip x is world x, clip y is world z, depth is height.
  glm::mat4 clipFromWorld(0);
  clipFromWorld[0][0] = 2 / side;
  clipFromWorld[2][1] = 2 / side;
  clipFromWorld[1][2] = 2 / kFloorCeiling;
  clipFromWorld[3] = glm::vec4(-1 - 2 * corner.x / side, -1 - 2 * corner.z / side,
                               -1 - 2 * corner.y / kFloorCeiling, 1);
  glViewport(0, 0, kFloorSize, kFloorSize);
  glBindFramebuffer(GL_FRAMEBUFFER, lowestTarget);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_CLAMP);  // soles a little below the floor still touch it
  meshes.drawDepth(scene, clipFromWorld);
  glDisable(GL_DEPTH_CLAMP);

  glBindFramebuffer(GL_FRAMEBUFFER, occlusionTarget);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(occlude);
  glUniform1i(gl::uniform(occlude, "lowest"), 3);
  glUniform2f(gl::uniform(occlude, "side"), side, kFloorCeiling);
  bindTexture(3, lowest);
  glBindVertexArray(empty);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace hair::draw
