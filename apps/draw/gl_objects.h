#pragma once

// Inside hair_draw only: OpenGL names that free themselves. A context must be current.

#include <span>
#include <string>
#include <utility>

#include <epoxy/gl.h>

namespace hair::draw::gl {

/// A name of one kind of OpenGL object; moves, frees itself.
template <class Kind>
class Name {
 public:
  Name() : id(Kind::make()) {}
  ~Name() {
    if (id) Kind::free(id);
  }
  Name(Name&& other) noexcept : id(std::exchange(other.id, 0)) {}
  Name& operator=(Name&& other) noexcept {
    std::swap(id, other.id);
    return *this;
  }
  operator GLuint() const { return id; }

 private:
  GLuint id;
};

struct BufferKind {
  static GLuint make() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
  }
  static void free(GLuint id) { glDeleteBuffers(1, &id); }
};

struct VertexArrayKind {
  static GLuint make() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
  }
  static void free(GLuint id) { glDeleteVertexArrays(1, &id); }
};

struct TextureKind {
  static GLuint make() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
  }
  static void free(GLuint id) { glDeleteTextures(1, &id); }
};

struct RenderbufferKind {
  static GLuint make() {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return id;
  }
  static void free(GLuint id) { glDeleteRenderbuffers(1, &id); }
};

struct FramebufferKind {
  static GLuint make() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
  }
  static void free(GLuint id) { glDeleteFramebuffers(1, &id); }
};

struct ProgramKind {
  static GLuint make() { return glCreateProgram(); }
  static void free(GLuint id) { glDeleteProgram(id); }
};

using Buffer = Name<BufferKind>;
using VertexArray = Name<VertexArrayKind>;
using Texture = Name<TextureKind>;
using Renderbuffer = Name<RenderbufferKind>;
using Framebuffer = Name<FramebufferKind>;
using Program = Name<ProgramKind>;

/// Sends an array to a buffer, all of it, as new storage (so that no drawing in flight is waited
/// for). Leaves the buffer bound to `target`.
template <class T>
void upload(GLenum target, const Buffer& buffer, std::span<const T> data, GLenum usage) {
  glBindBuffer(target, buffer);
  glBufferData(target, GLsizeiptr(data.size_bytes()), data.data(), usage);
}

/// Compiles and links; `geometry` may be empty. Binds the uniform block "Frame" to kFrameBinding
/// and samplers "meshShadow", "hairShadow", "floorOcclusion" to texture units 0, 1, 2. Throws Error
/// with the driver's log.
Program link(const std::string& name, const std::string& vertex, const std::string& geometry,
             const std::string& fragment);

inline constexpr GLuint kFrameBinding = 0;

inline GLint uniform(const Program& program, const char* name) {
  return glGetUniformLocation(program, name);
}

/// Throws Error unless the framebuffer bound to GL_FRAMEBUFFER can be drawn to.
void requireComplete(const std::string& name);

}  // namespace hair::draw::gl
