#pragma once

#include <memory>
#include <string>

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

}  // namespace hair::draw
