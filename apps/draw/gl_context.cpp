#include <apps/draw/gl_context.h>

#include <cstring>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <libhair/core/error.h>

namespace hair::draw {

struct OffscreenContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  ~Handles() {
    if (context == EGL_NO_CONTEXT) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    // The display stays: it is one for the whole process, and ending it would end other contexts.
  }
};

OffscreenContext::OffscreenContext() : handles(std::make_unique<Handles>()) {
  const auto check = [](bool ok, const char* step) {
    require(ok, "cannot draw without a screen: ", step, " failed (EGL error 0x", std::hex,
            eglGetError(), "); install libegl1, libegl-mesa0 and libgl1-mesa-dri");
  };
  const char* const extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  check(extensions && std::strstr(extensions, "EGL_MESA_platform_surfaceless"),
        "looking for EGL_MESA_platform_surfaceless");
  auto& display = handles->display;
  display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  check(display != EGL_NO_DISPLAY, "eglGetPlatformDisplayEXT");
  check(eglInitialize(display, nullptr, nullptr), "eglInitialize");
  check(eglBindAPI(EGL_OPENGL_API), "eglBindAPI(OpenGL)");

  const EGLint configWanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  // Surfaceless displays may offer no config that draws to a window; none is needed then.
  const bool chosen = eglChooseConfig(display, configWanted, &config, 1, &count) && count > 0;
  const EGLint contextWanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
  handles->context =
      eglCreateContext(display, chosen ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, contextWanted);
  check(handles->context != EGL_NO_CONTEXT, "eglCreateContext(OpenGL 3.3 core)");
  makeCurrent();
}

OffscreenContext::~OffscreenContext() = default;

void OffscreenContext::makeCurrent() {
  const bool current =
      eglMakeCurrent(handles->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles->context);
  require(current, "cannot draw without a screen: eglMakeCurrent failed (EGL error 0x", std::hex,
          eglGetError(), "); a context is current on one thread at a time");
}

std::string OffscreenContext::description() const {
  return text(rendererName(), ", OpenGL ", reinterpret_cast<const char*>(glGetString(GL_VERSION)));
}

std::string rendererName() {
  const auto* bytes = glGetString(GL_RENDERER);
  return bytes ? reinterpret_cast<const char*>(bytes) : "";
}

bool drawsOnCpu(std::string_view rendererName) {
  for (const std::string_view software : {"llvmpipe", "softpipe", "SwiftShader", "Software"})
    if (rendererName.find(software) != std::string_view::npos) return true;
  return false;
}

}  // namespace hair::draw
