#include <apps/draw/light_maps.h>

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include <apps/draw/light_view.h>
#include <apps/draw/shaders.h>

namespace hair::draw {
namespace {

constexpr int kFloorSize = 128;        // pixels of the floor's occlusion map
constexpr float kFloorReach = 0.6f;    // it goes this far beyond the meshes, metres
constexpr float kFloorCeiling = 1.5f;  // what is higher over the floor hides too little to matter

gl::Program makeOcclude() {
  const auto s = shaders::floorOcclusion();
  return gl::link("floor occlusion", s.vertex, s.geometry, s.fragment);
}

// `layers`: 0 for a plain texture, else an array of them.
void allocate(const gl::Texture& texture, GLint internal, int size, int layers, GLenum format,
              GLenum type, float border) {
  const GLenum kind = layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
  glBindTexture(kind, texture);
  if (layers > 0)
    glTexImage3D(kind, 0, internal, size, size, layers, 0, format, type, nullptr);
  else
    glTexImage2D(kind, 0, internal, size, size, 0, format, type, nullptr);
  const float colour[] = {border, border, border, border};
  glTexParameterfv(kind, GL_TEXTURE_BORDER_COLOR, colour);
  glTexParameteri(kind, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(kind, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

// To the bound framebuffer.
void attachLayer(GLenum attachment, const gl::Texture& texture, int layer) {
  glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment, texture, 0, layer);
}

void withoutColour() {
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
}

void attach(const gl::Framebuffer& target, const gl::Texture* colour, const gl::Texture* depth,
            const char* name) {
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  if (colour) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *colour, 0);
  } else {
    withoutColour();
  }
  if (depth) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, *depth, 0);
  gl::requireComplete(name);
}

void bindTexture(GLuint unit, const gl::Texture& texture, GLenum kind = GL_TEXTURE_2D) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(kind, texture);
}

const glm::mat4 kTextureFromClip =
    glm::scale(glm::translate(glm::mat4(1), glm::vec3(0.5f)), glm::vec3(0.5f));

}  // namespace

LightMaps::LightMaps(int size_) : size(size_), occlude(makeOcclude()) {
  allocate(lowest, GL_DEPTH_COMPONENT24, kFloorSize, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1);
  allocate(occlusion, GL_R8, kFloorSize, 0, GL_RED, GL_UNSIGNED_BYTE, 1);
  attach(lowestTarget, nullptr, &lowest, "floor heights");
  attach(occlusionTarget, &occlusion, nullptr, "floor occlusion");
}

// Memory for as many lights as there are, not for as many as there might be.
void LightMaps::allocateLayers(int count) {
  if (count == layers) return;
  layers = count;
  allocate(meshDepth, GL_DEPTH_COMPONENT24, size, layers, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  allocate(hairDepth, GL_R16F, size, layers, GL_RED, GL_FLOAT, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, meshTarget);
  withoutColour();
  attachLayer(GL_DEPTH_ATTACHMENT, meshDepth, 0);
  gl::requireComplete("mesh shadow");
  glBindFramebuffer(GL_FRAMEBUFFER, hairTarget);
  attachLayer(GL_COLOR_ATTACHMENT0, hairDepth, 0);
  attachLayer(GL_DEPTH_ATTACHMENT, meshDepth, 0);
  gl::requireComplete("hair shadow");
}

void LightMaps::update(const Scene& scene, const MeshStore& meshes, HairPass& hair,
                       FrameBlock& frame) {
  Bounds casters = meshes.worldBounds(scene);
  const Bounds h = hair.worldBounds();
  if (h.lower.x <= h.upper.x) casters.extend(h.lower), casters.extend(h.upper);
  if (casters.lower.x > casters.upper.x) casters.extend(glm::vec3(0));
  const int lights = static_cast<int>(std::min(scene.lights.size(), kMeshLights));
  allocateLayers(std::max(1, lights));
  frame.shadowTexel = glm::vec4(1.0f / float(size), 0, 0, 0);

  glViewport(0, 0, size, size);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glClearDepth(1);
  glClearColor(0, 0, 0, 0);
  for (int l = 0; l < lights; ++l) {
    const LightView view =
        lightView(scene.lights[std::size_t(l)], scene.pivot, casters, casters, size);
    frame.shadowFromWorld[l] = kTextureFromClip * view.clipFromWorld;
    frame.lightTexel[l] = view.texel;

    glBindFramebuffer(GL_FRAMEBUFFER, meshTarget);
    attachLayer(GL_DEPTH_ATTACHMENT, meshDepth, l);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 4);
    meshes.drawDepth(scene, view.clipFromWorld);
    glDisable(GL_POLYGON_OFFSET_FILL);

    glBindFramebuffer(GL_FRAMEBUFFER, hairTarget);
    attachLayer(GL_COLOR_ATTACHMENT0, hairDepth, l);
    attachLayer(GL_DEPTH_ATTACHMENT, meshDepth, l);
    glClear(GL_COLOR_BUFFER_BIT);
    hair.drawDepth(scene, view.clipFromWorld, view.texel);
  }

  updateFloor(scene, meshes, frame);
  bindTexture(2, occlusion);
  bindTexture(1, hairDepth, GL_TEXTURE_2D_ARRAY);
  bindTexture(0, meshDepth, GL_TEXTURE_2D_ARRAY);
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
