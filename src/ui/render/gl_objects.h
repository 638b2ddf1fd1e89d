// RAII owners of OpenGL names: one object each, move-only, freed in the context that made it.
//
// Threads: the thread of the current OpenGL context, alone. An object must die before its context does.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <utility>

namespace planewright::render {

// Traits: static GLuint create(); static void destroy(GLuint).
template <class Traits>
class GlObject {
 public:
  GlObject() = default;  // owns nothing
  static GlObject create() { return GlObject(Traits::create()); }
  explicit GlObject(GLuint name) : name_(name) {}
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) Traits::destroy(name_);
  }

  GLuint get() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  GLuint name_ = 0;
};

#define PLANEWRIGHT_GL_TRAITS(Type, Function)                          \
  struct Type##Traits {                                                \
    static GLuint create() {                                           \
      GLuint name = 0;                                                 \
      glGen##Function(1, &name);                                       \
      return name;                                                     \
    }                                                                  \
    static void destroy(GLuint name) { glDelete##Function(1, &name); } \
  };                                                                   \
  using Type = GlObject<Type##Traits>;

PLANEWRIGHT_GL_TRAITS(GlBuffer, Buffers)
PLANEWRIGHT_GL_TRAITS(GlVertexArray, VertexArrays)
PLANEWRIGHT_GL_TRAITS(GlTexture, Textures)
PLANEWRIGHT_GL_TRAITS(GlFramebuffer, Framebuffers)
PLANEWRIGHT_GL_TRAITS(GlRenderbuffer, Renderbuffers)
#undef PLANEWRIGHT_GL_TRAITS

struct GlProgramTraits {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint name) { glDeleteProgram(name); }
};
using GlProgram = GlObject<GlProgramTraits>;

struct GlShaderTraits {
  static void destroy(GLuint name) { glDeleteShader(name); }
};
using GlShader = GlObject<GlShaderTraits>;

// The names of all errors that OpenGL has recorded since it was last asked ("out of memory, invalid
// operation"); empty for none.
std::string take_gl_errors();

// Throws std::runtime_error naming `where` when OpenGL recorded an error. After uploads always; after drawing
// in debug builds only, where waiting for the driver does not matter.
void check_gl(const char* where);

}  // namespace planewright::render
