#pragma once

// Inside hair_draw only: where pictures are drawn.

#include <glm/glm.hpp>

#include <apps/draw/gl_objects.h>
#include <apps/draw/picture.h>

namespace hair::draw {

/// A multisampled sRGB framebuffer with depth, and the plain one that it is averaged into.
class Targets {
 public:
  /// `samples`: as many as the card has, at most this.
  explicit Targets(int samples);

  void resize(int width, int height);
  int width() const { return size.x; }
  int height() const { return size.y; }

  void bind() const;
  void resolve() const;
  void read(Picture& picture) const;
  void present(int left, int windowWidth, int windowHeight) const;

 private:
  glm::ivec2 size{0};
  int samples;
  gl::Framebuffer drawn, resolved;
  gl::Renderbuffer drawnColour, drawnDepth, resolvedColour;
};

}  // namespace hair::draw
