#include <apps/draw/targets.h>

#include <algorithm>

#include <libhair/core/error.h>

namespace hair::draw {

namespace {

// OpenGL counts rows from the bottom.
template <class Pixels>
void turnOver(Pixels& picture) {
  for (int y = 0; y < picture.height / 2; ++y)
    std::swap_ranges(picture.pixel(0, y), picture.pixel(0, y) + 3 * picture.width,
                     picture.pixel(0, picture.height - 1 - y));
}

}  // namespace

Targets::Targets(int wanted, bool linear_) : linear(linear_) {
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  samples = std::clamp(wanted, 1, std::max(1, int(most)));
}

void Targets::resize(int width, int height) {
  require(width >= 1 && width <= 16384 && height >= 1 && height <= 16384, "a picture of ", width,
          " x ", height, " pixels cannot be drawn: sides are 1 to 16384");
  if (size == glm::ivec2(width, height)) return;
  const auto storage = [&](const gl::Renderbuffer& buffer, int count, GLenum format) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    // One sample asks for a multisampled buffer of one on some cards: zero is plain.
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, count > 1 ? count : 0, format, width, height);
  };
  const GLenum colour = linear ? GL_RGBA32F : GL_SRGB8_ALPHA8;
  storage(drawnColour, samples, colour);
  storage(drawnDepth, samples, GL_DEPTH_COMPONENT24);
  storage(resolvedColour, 1, colour);
  glBindFramebuffer(GL_FRAMEBUFFER, drawn);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, drawnColour);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, drawnDepth);
  gl::requireComplete("picture");
  glBindFramebuffer(GL_FRAMEBUFFER, resolved);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolvedColour);
  gl::requireComplete("resolved picture");
  size = {width, height};
}

void Targets::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn);
  glViewport(0, 0, size.x, size.y);
}

void Targets::resolve() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
  glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Targets::read(Picture& picture) const {
  require(!linear, "a renderer of linear pictures has no bytes to read");
  if (picture.width != size.x || picture.height != size.y) picture = Picture(size.x, size.y);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, picture.rgb.data());
  turnOver(picture);
}

void Targets::read(LinearPicture& picture) const {
  require(linear, "a renderer of bytes has no linear picture to read: RenderSettings::linear");
  if (picture.width != size.x || picture.height != size.y) picture = LinearPicture(size.x, size.y);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_FLOAT, picture.rgb.data());
  turnOver(picture);
}

void Targets::present(int left, int windowWidth, int windowHeight) const {
  require(!linear, "linear pictures are not shown in a window");
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  // The bytes are sRGB already, and a window's framebuffer shows bytes as they are.
  glDisable(GL_FRAMEBUFFER_SRGB);
  glBlitFramebuffer(0, 0, size.x, size.y, left, 0, left + windowWidth, windowHeight,
                    GL_COLOR_BUFFER_BIT,
                    size == glm::ivec2(windowWidth, windowHeight) ? GL_NEAREST : GL_LINEAR);
}

}  // namespace hair::draw
