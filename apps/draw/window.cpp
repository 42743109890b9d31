#include <apps/draw/window.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <epoxy/gl.h>
// After the loader, which brings its own gl.h.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <glm/gtc/quaternion.hpp>

#include <libhair/core/error.h>

namespace hair::draw {
namespace {

constexpr float kRadiansPerHeight = 4.0f;  // a drag over the window's whole height turns so far

std::string glfwComplaint() {
  const char* what = nullptr;
  glfwGetError(&what);
  return what ? what : "no reason given";
}

/// Turns the first light as a drag would turn a ball that the camera looks at.
void turnLight(Scene& scene, float rightBy, float upBy) {
  if (scene.lights.empty()) return;
  Light& light = scene.lights.front();
  const glm::mat3 worldFromView = glm::transpose(glm::mat3(scene.camera.viewFromWorld()));
  const glm::vec3 right = worldFromView[0], up = worldFromView[1];
  // The light's own place (against its direction) follows the hand.
  const auto turned = [&](glm::vec3 place) {
    place = glm::angleAxis(rightBy, up) * place;
    return glm::angleAxis(-upBy, right) * place;
  };
  if (light.kind == Light::Kind::Point)
    light.position = scene.pivot + turned(light.position - scene.pivot);
  else
    light.direction = -glm::normalize(turned(-glm::normalize(light.direction)));
}

}  // namespace

struct Window::State {
  GLFWwindow* window = nullptr;
  int width = 1, height = 1;  // of the framebuffer, pixels
  int margin = 0;             // of it, left of the picture
  double cursorX = 0, cursorY = 0, wheel = 0;
  ImGuiContext* panel = nullptr;
  WindowRequests requests;
  Pointer pointer;
  bool held = false, buttonBefore = false;

  ~State() {
    if (panel) {
      ImGui_ImplOpenGL3_Shutdown();
      ImGui_ImplGlfw_Shutdown();
      ImGui::DestroyContext(panel);
    }
    if (window) glfwDestroyWindow(window);
    glfwTerminate();
  }

  void point();
  void drag(Scene& scene);
};

bool windowAvailable() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  // The GLFW of today's distributions opens windows through X, under Wayland too.
  // No glfwTerminate: a display server that loses its only client starts anew, and for a moment
  // answers nobody. The window takes the connection over.
  return set("DISPLAY") && glfwInit();
}

Window::Window(const std::string& title, int width, int height) : state(std::make_unique<State>()) {
  const bool started = glfwInit();
  require(started, "cannot open a window: ", glfwComplaint());
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  // The renderer multisamples in a framebuffer of its own.
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  state->window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  require(state->window != nullptr, "cannot open a window with OpenGL 3.3: ", glfwComplaint(),
          "; --headless does without");
  glfwMakeContextCurrent(state->window);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(state->window, state.get());
  // Before ImGui, whose back end passes events on to the callbacks it finds.
  glfwSetScrollCallback(state->window, [](GLFWwindow* w, double, double by) {
    static_cast<State*>(glfwGetWindowUserPointer(w))->wheel += by;
  });
  glfwSetKeyCallback(state->window, [](GLFWwindow* w, int key, int, int action, int) {
    if (action == GLFW_RELEASE || (ImGui::GetCurrentContext() && ImGui::GetIO().WantTextInput))
      return;
    WindowRequests& r = static_cast<State*>(glfwGetWindowUserPointer(w))->requests;
    if (key == GLFW_KEY_SPACE && action == GLFW_PRESS) r.pause = !r.pause;
    if (key == GLFW_KEY_S) r.step = true;
    if (key == GLFW_KEY_R && action == GLFW_PRESS) r.reset = true;
    if (key == GLFW_KEY_TAB && action == GLFW_PRESS) r.panel = !r.panel;
  });

  IMGUI_CHECKVERSION();
  state->panel = ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // no file appears in the user's folder
  float scale = 1;
  glfwGetWindowContentScale(state->window, &scale, nullptr);
  ImGui::StyleColorsDark();
  ImGui::GetStyle().ScaleAllSizes(scale);
  ImFontConfig font;
  font.SizePixels = std::round(13 * scale);
  io.Fonts->AddFontDefault(&font);
  ImGui_ImplGlfw_InitForOpenGL(state->window, true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
  glfwGetFramebufferSize(state->window, &state->width, &state->height);
}

Window::~Window() = default;

void Window::State::point() {
  double x = 0, y = 0;
  glfwGetCursorPos(window, &x, &y);
  int unitsWide = 1, unitsHigh = 1;
  glfwGetWindowSize(window, &unitsWide, &unitsHigh);
  pointer.at = {float(x * width / std::max(1, unitsWide)) - float(margin),
                float(y * height / std::max(1, unitsHigh))};
  const bool before = pointer.down;
  const bool button = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
  pointer.pressed = button && !buttonBefore && !ImGui::GetIO().WantCaptureMouse;
  pointer.down = button && (before || pointer.pressed);
  buttonBefore = button;
}

void Window::State::drag(Scene& scene) {
  Camera& camera = scene.camera;
  double x = 0, y = 0;
  glfwGetCursorPos(window, &x, &y);
  int unitsWide = 1, unitsHigh = 1;
  glfwGetWindowSize(window, &unitsWide, &unitsHigh);
  const float dx = float((x - cursorX) / std::max(1, unitsHigh));
  const float dy = float((cursorY - y) / std::max(1, unitsHigh));
  cursorX = x, cursorY = y;
  const double turns = wheel;
  wheel = 0;
  if (ImGui::GetIO().WantCaptureMouse) return;
  const auto down = [&](int button) { return glfwGetMouseButton(window, button) == GLFW_PRESS; };
  const bool shift = glfwGetKey(window, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ||
                     glfwGetKey(window, GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
  const float turn = kRadiansPerHeight;
  if (down(GLFW_MOUSE_BUTTON_RIGHT) || (shift && down(GLFW_MOUSE_BUTTON_LEFT))) {
    if (dx != 0 || dy != 0) turnLight(scene, turn * dx, turn * dy);
  } else if (down(GLFW_MOUSE_BUTTON_MIDDLE)) {
    camera.pan({-dx, -dy});
  } else if (down(GLFW_MOUSE_BUTTON_LEFT) && !held) {
    camera.orbit(-turn * dx, -turn * dy);
  }
  if (turns != 0) camera.zoom(std::pow(0.9f, float(turns)));
}

bool Window::beginFrame(Scene& scene) {
  State& s = *state;
  s.requests = {};
  glfwPollEvents();
  if (glfwWindowShouldClose(s.window)) return false;
  int w = 0, h = 0;
  glfwGetFramebufferSize(s.window, &w, &h);
  s.width = std::max(1, w), s.height = std::max(1, h);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  s.point();
  s.drag(scene);
  return true;
}

WindowRequests Window::requests() const {
  return state->requests;
}

Pointer Window::pointer() const {
  return state->pointer;
}

void Window::holdDrag(bool held) {
  state->held = held;
}

void Window::endFrame(const Renderer& renderer) {
  ImGui::Render();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  renderer.present(state->margin, width(), height());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, state->width, state->height);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(state->window);
}

void Window::setMargin(float units) {
  const float pixels = units * ImGui::GetIO().DisplayFramebufferScale.x;
  state->margin = std::clamp(static_cast<int>(pixels), 0, state->width - 1);
}

int Window::width() const {
  return std::max(1, state->width - state->margin);
}
int Window::height() const {
  return state->height;
}

void Window::close() {
  glfwSetWindowShouldClose(state->window, GLFW_TRUE);
}

}  // namespace hair::draw
