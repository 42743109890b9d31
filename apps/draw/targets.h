#pragma once

// Inside hair_draw only: where pictures are drawn.

#include <glm/glm.hpp>

#include <apps/draw/gl_objects.h>
#include <apps/draw/picture.h>

namespace hair::draw {

/// A multisampled framebuffer with depth, and the plain one that it is averaged into. Both are sRGB
/// bytes, or linear floats of 32 bits: a hundred strands may be blended into a pixel, each of which
/// would be rounded to half floats.
class Targets {
 public:
  /// `samples`: as many as the card has, at most this.
  Targets(int samples, bool linear);

  void resize(int width, int height);
  int width() const { return size.x; }
  int height() const { return size.y; }

  void bind() const;
  void resolve() const;
  /// Of sRGB bytes alone.
  void read(Picture& picture) const;
  /// Of linear floats alone.
  void read(LinearPicture& picture) const;
  /// Of sRGB bytes alone.
  void present(int left, int windowWidth, int windowHeight) const;

 private:
  glm::ivec2 size{0};
  int samples;
  bool linear;
  gl::Framebuffer drawn, resolved;
  gl::Renderbuffer drawnColour, drawnDepth, resolvedColour;
};

}  // namespace hair::draw
