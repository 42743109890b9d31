#include <apps/draw/gl_objects.h>

#include <libhair/core/error.h>

namespace hair::draw::gl {
namespace {

void attach(const Program& program, const std::string& name, GLenum kind,
            const std::string& source) {
  const GLuint shader = glCreateShader(kind);
  const char* const text_ = source.c_str();
  glShaderSource(shader, 1, &text_, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (!ok) {
    char log[2048] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    glDeleteShader(shader);
    throw Error(text("OpenGL refused the ",
                     kind == GL_VERTEX_SHADER     ? "vertex"
                     : kind == GL_GEOMETRY_SHADER ? "geometry"
                                                  : "fragment",
                     " shader of '", name, "': ", log));
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);
}

}  // namespace

Program link(const std::string& name, const std::string& vertex, const std::string& geometry,
             const std::string& fragment) {
  Program program;
  attach(program, name, GL_VERTEX_SHADER, vertex);
  if (!geometry.empty()) attach(program, name, GL_GEOMETRY_SHADER, geometry);
  attach(program, name, GL_FRAGMENT_SHADER, fragment);
  glLinkProgram(program);
  GLint ok = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  if (!ok) {
    char log[2048] = "";
    glGetProgramInfoLog(program, sizeof log, nullptr, log);
    throw Error(text("OpenGL could not link the shaders of '", name, "': ", log));
  }
  const GLuint block = glGetUniformBlockIndex(program, "Frame");
  if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, kFrameBinding);
  glUseProgram(program);
  glUniform1i(uniform(program, "meshShadow"), 0);
  glUniform1i(uniform(program, "hairShadow"), 1);
  glUniform1i(uniform(program, "floorOcclusion"), 2);
  return program;
}

void requireComplete(const std::string& name) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  require(status == GL_FRAMEBUFFER_COMPLETE, "OpenGL cannot draw to the framebuffer of '", name,
          "' (status ", status, ", renderer ",
          reinterpret_cast<const char*>(glGetString(GL_RENDERER)), ")");
}

}  // namespace hair::draw::gl
