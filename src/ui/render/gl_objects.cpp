#include "ui/render/gl_objects.h"

#include <stdexcept>

namespace planewright::render {
namespace {

const char* name_of(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "invalid enum";
    case GL_INVALID_VALUE:
      return "invalid value";
    case GL_INVALID_OPERATION:
      return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "invalid framebuffer operation";
    case GL_OUT_OF_MEMORY:
      return "out of memory";
    default:
      return "unknown error";
  }
}

}  // namespace

std::string take_gl_errors() {
  constexpr int kMost = 8;  // without a context some drivers report errors for ever
  std::string names;
  for (int i = 0; i < kMost; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    if (!names.empty()) names += ", ";
    names += name_of(error);
  }
  return names;
}

void check_gl(const char* where) {
  const std::string names = take_gl_errors();
  if (!names.empty()) throw std::runtime_error(std::string("OpenGL: ") + names + " (" + where + ")");
}

}  // namespace planewright::render
