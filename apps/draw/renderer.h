#pragma once

#include <memory>

#include <apps/draw/picture.h>
#include <apps/draw/scene.h>

namespace hair::draw {

/// How much work goes into a picture.
struct RenderSettings {
  int samples = 4;                 ///< of multisampling; 1, 2, 4 or 8
  int shadowMapSize = 2048;        ///< pixels on a side, [64, 8192]
  int shadowHairSegments = 60000;  ///< at most so many cast the hair's shadow on meshes
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

  /// Reads back what was drawn last.
  void read(Picture& picture) const;
  Picture read() const;

  /// Copies what was drawn last to the window's own framebuffer of the given size.
  void present(int windowWidth, int windowHeight) const;

 private:
  struct State;
  std::unique_ptr<State> state;
};

}  // namespace hair::draw
