#include <apps/draw/renderer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <apps/draw/frame_block.h>
#include <apps/draw/hair_pass.h>
#include <apps/draw/light_maps.h>
#include <apps/draw/mesh_store.h>
#include <apps/draw/mesh_visibility.h>
#include <apps/draw/shaders.h>
#include <apps/draw/targets.h>
#include <libhair/core/error.h>

namespace hair::draw {
namespace {

gl::Program linked(const char* name, const shaders::Source& s) {
  return gl::link(name, s.vertex, s.geometry, s.fragment);
}

void checkScene(const Scene& scene) {
  for (const Light& light : scene.lights) lightSpaceOf(light, scene.pivot);
  require(
      scene.camera.distance > 0 && scene.camera.fieldOfView > 0 && scene.camera.fieldOfView < 3.14f,
      "the camera's distance must be above 0 and its field of view in (0, pi); they are ",
      scene.camera.distance, " and ", scene.camera.fieldOfView);
}

}  // namespace

struct Renderer::State {
  explicit State(const RenderSettings& s)
      : settings(s),
        targets(s.samples, s.linear),
        lightMaps(std::clamp(s.shadowMapSize, 64, 8192)) {}

  RenderSettings settings;
  Targets targets;
  MeshStore meshes;
  HairPass hair;
  LightMaps lightMaps;
  MeshVisibility visibility;
  gl::Buffer frameBuffer, debugBuffer;
  gl::VertexArray empty, debugArray;
  gl::Program background = linked("background", shaders::background());
  gl::Program ground = linked("ground", shaders::ground());
  gl::Program debug = linked("debug", shaders::debug());

  void drawView(const Scene& scene, FrameBlock frame, glm::ivec4 viewport, bool left);
  void drawDebug(const DebugLayer& layer);
};

Renderer::Renderer(const RenderSettings& settings) : state(std::make_unique<State>(settings)) {}
Renderer::~Renderer() = default;

void Renderer::draw(const Scene& scene, int width, int height) {
  checkScene(scene);
  State& s = *state;
  s.targets.resize(width, height);
  s.meshes.update(scene);
  s.hair.update(scene, s.settings.shadowHairSegments, s.settings.linear);

  // ImGui and other guests leave their state behind.
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDisable(GL_STENCIL_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glEnable(GL_MULTISAMPLE);
  glBlendEquation(GL_FUNC_ADD);

  FrameBlock maps{};
  s.lightMaps.update(scene, s.meshes, s.hair, maps);

  s.targets.bind();
  glEnable(GL_FRAMEBUFFER_SRGB);
  glClear(GL_DEPTH_BUFFER_BIT);
  const auto view = [&](glm::ivec4 viewport, bool left) {
    FrameBlock frame = frameBlock(scene, glm::vec4(viewport));
    std::ranges::copy(maps.shadowFromWorld, frame.shadowFromWorld);
    frame.lightTexel = maps.lightTexel;
    frame.shadowTexel = maps.shadowTexel;
    frame.floorMap = maps.floorMap;
    s.drawView(scene, frame, viewport, left);
  };
  if (scene.sideBySide && width >= 2) {
    const int half = width / 2;
    view({0, 0, half, height}, true);
    view({width - half, 0, half, height}, false);
  } else {
    view({0, 0, width, height}, false);
  }
  s.targets.resolve();
  glDisable(GL_FRAMEBUFFER_SRGB);
}

void Renderer::State::drawView(const Scene& scene, FrameBlock frame, glm::ivec4 viewport,
                               bool left) {
  gl::upload<FrameBlock>(GL_UNIFORM_BUFFER, frameBuffer, {&frame, 1}, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, gl::kFrameBinding, frameBuffer);
  glViewport(viewport.x, viewport.y, viewport.z, viewport.w);
  // Viewports do not clip lines at their edges; scissors do.
  glEnable(GL_SCISSOR_TEST);
  glScissor(viewport.x, viewport.y, viewport.z, viewport.w);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);

  // What hides most first: pixels that are hidden are never shaded.
  meshes.draw(scene);
  glBindVertexArray(empty);
  if (scene.ground.visible) {
    glUseProgram(ground);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glUseProgram(background);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  hair.draw(scene, left);
  drawDebug(scene.debug);
  glDisable(GL_SCISSOR_TEST);
}

void Renderer::State::drawDebug(const DebugLayer& layer) {
  if (layer.lines.empty() && layer.points.empty()) return;
  glUseProgram(debug);
  glBindVertexArray(debugArray);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (layer.onTop) glDisable(GL_DEPTH_TEST);
  glPointSize(layer.pointSize);
  const auto draw = [&](GLenum primitive, const std::vector<DebugLayer::Vertex>& vertices) {
    using Vertex = DebugLayer::Vertex;
    gl::upload<Vertex>(GL_ARRAY_BUFFER, debugBuffer, vertices, GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offsetof(Vertex, colour)));
    glDrawArrays(primitive, 0, GLsizei(vertices.size()));
  };
  draw(GL_LINES, layer.lines);
  draw(GL_POINTS, layer.points);
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
}

void Renderer::meshVisibility(const Scene& scene, std::span<const glm::vec3> points,
                              std::span<float> visibility) {
  checkScene(scene);
  require(visibility.size() == scene.lights.size() * points.size(), "mesh visibility of ",
          points.size(), " points and ", scene.lights.size(), " lights wanted in an array of ",
          visibility.size());
  state->meshes.update(scene);
  for (std::size_t l = 0; l < scene.lights.size(); ++l)
    state->visibility.compute(scene, scene.lights[l], state->meshes, points,
                              visibility.subspan(l * points.size(), points.size()));
}

void Renderer::finish() const {
  glFinish();
}

void Renderer::read(Picture& picture) const {
  state->targets.read(picture);
}

Picture Renderer::read() const {
  Picture picture;
  read(picture);
  return picture;
}

bool Renderer::linear() const {
  return state->settings.linear;
}

LinearPicture Renderer::readLinear() const {
  LinearPicture picture;
  state->targets.read(picture);
  return picture;
}

void Renderer::present(int left, int width, int height) const {
  state->targets.present(left, width, height);
}

}  // namespace hair::draw
