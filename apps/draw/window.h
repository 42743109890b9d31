#pragma once

#include <memory>
#include <string>

#include <apps/draw/renderer.h>

namespace hair::draw {

/// What the keys asked for since the last frame.
struct WindowRequests {
  bool pause = false;  ///< space: pause or go on
  bool step = false;   ///< S: one frame
  bool reset = false;  ///< R: back to the start
  bool panel = false;  ///< Tab: show or hide the panel
};

/// The mouse over the picture.
struct Pointer {
  glm::vec2 at{0};       ///< pixels of the picture, from its upper left corner
  bool pressed = false;  ///< the left button went down in this frame, over the picture
  bool down = false;     ///< it is down, and was pressed there
};

/// A window with an OpenGL 3.3 core context, the mouse on camera and first light, and Dear ImGui.
///
///   Window window("dance", 1280, 720);
///   Renderer renderer;
///   while (window.beginFrame(scene)) {
///     ... ImGui::Begin ... ImGui::End ...
///     renderer.draw(scene, window.width(), window.height());
///     window.endFrame(renderer);
///   }
///
/// Left drag orbits, middle drag pans, the wheel zooms, right drag (or shift and left drag) turns
/// the first light, or moves it about the pivot where it is at a point. What the panel takes, the
/// scene does not get.
class Window {
 public:
  /// Throws Error when there is no display or no OpenGL 3.3.
  Window(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Polls events, moves camera and light, opens an ImGui frame. False once the window is closed.
  bool beginFrame(Scene& scene);
  WindowRequests requests() const;

  Pointer pointer() const;
  /// While `held`, the left button drags what the caller has picked, and does not turn the camera.
  void holdDrag(bool held);

  /// Shows what the renderer drew last, the panel over it.
  void endFrame(const Renderer& renderer);

  /// Keeps the picture off the left part of the window, where a panel stands: screen units, as
  /// ImGui counts. 0, the default: nothing.
  void setMargin(float units);

  /// The picture in pixels (not the window in screen units): the framebuffer but for the margin; at
  /// least 1.
  int width() const;
  int height() const;

  void close();

 private:
  struct State;
  std::unique_ptr<State> state;
};

/// Whether a window can be opened here (a display is there).
bool windowAvailable();

}  // namespace hair::draw
