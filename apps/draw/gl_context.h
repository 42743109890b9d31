#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace hair::draw {

/// OpenGL 3.3 core without a screen: EGL, surfaceless, current on the calling thread while it
/// lives. Drawing goes to framebuffer objects only.
class OffscreenContext {
 public:
  /// Throws Error (the step that failed, and what to install).
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  void makeCurrent();
  /// The renderer and version strings of OpenGL.
  std::string description() const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles;
};

/// What draws in the current context, as OpenGL names it.
std::string rendererName();
/// No graphics card: OpenGL of that name is computed by the CPU, and pictures are dear.
bool drawsOnCpu(std::string_view rendererName);

}  // namespace hair::draw
