#pragma once

#include <memory>
#include <span>

#include <apps/draw/picture.h>
#include <apps/draw/scene.h>

namespace hair::draw {

/// How much work goes into a picture.
struct RenderSettings {
  int samples = 4;                 ///< of multisampling; 1, 2, 4 or 8
  int shadowMapSize = 1024;        ///< pixels on a side, [64, 8192]
  int shadowHairSegments = 60000;  ///< at most so many cast the hair's shadow on meshes
  /// Pictures of linear floats instead of sRGB bytes: hair of its layers' `radiance`, meshes and
  /// floor of the same light as in bytes, with the same film curve; nothing is rounded, and what
  /// hair sends beyond 1 is kept. Takes about four times the memory.
  bool linear = false;
};

/// Draws scenes into a framebuffer of its own with whatever OpenGL 3.3 context is current
/// (OffscreenContext, Window); the context must outlive it and be current at every call.
/// The same scene and size give the same bytes on the same OpenGL implementation.
class Renderer {
 public:
  explicit Renderer(const RenderSettings& settings = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws the scene at a size in pixels. Throws Error for sizes outside [1, 16384] and for colour
  /// arrays that do not fit their strands.
  void draw(const Scene& scene, int width, int height);

  /// What the scene's meshes leave of each light at points, to shade hair with: 0 in the shadow of
  /// a head or body, 1 in the light, in between at the shadow's edge. `visibility`:
  /// [lights · pointCount], all points of the first light, then of the next.
  /// Points on or just under a surface that faces the light (the roots of hair) are in the light.
  void meshVisibility(const Scene& scene, std::span<const glm::vec3> points,
                      std::span<float> visibility);

  /// Waits until all is drawn, to take its time. (OpenGL only notes down what there is to do.)
  void finish() const;

  /// Whether pictures are linear floats: hair layers then need their radiance.
  bool linear() const;

  /// Reads back what was drawn last. Throws Error where pictures are linear.
  void read(Picture& picture) const;
  Picture read() const;

  /// Reads back what was drawn last. Throws Error unless pictures are linear.
  LinearPicture readLinear() const;

  /// Copies what was drawn last to a part of the window's own framebuffer, scaled to fit: `width`
  /// by `height` pixels that start `left` pixels from the window's left edge and at its bottom.
  /// Throws Error where pictures are linear.
  void present(int left, int width, int height) const;

 private:
  struct State;
  std::unique_ptr<State> state;
};

}  // namespace hair::draw
