// A linked GLSL program, and where shader sources come from: embedded at build time, or a folder for live
// reload.
//
// Threads: the thread of the current OpenGL context, alone.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string_view>

#include "core/base/result.h"
#include "ui/render/gl_objects.h"

namespace planewright::render {

// The source of shaders/`name` ("panel.vert") as it stood at build time; empty for an unknown name.
std::string_view embedded_shader(std::string_view name);

class ShaderProgram {
 public:
  ShaderProgram() = default;
  // Compiles and links NAME.vert and NAME.frag, from `folder` or, when that is empty, the embedded ones.
  // Fails with ErrorCode::Unavailable and the compiler's log, or ErrorCode::Unreadable for a missing file.
  static Result<ShaderProgram> load(std::string_view name, const std::filesystem::path& folder);

  void use() const { glUseProgram(program_.get()); }
  // Uniforms of the program in use. A name that the shader does not use is ignored: the compiler removes what
  // has no effect, and a shader being edited may do without it for a while.
  void set(const char* uniform, int value) const { glUniform1i(at(uniform), value); }
  void set(const char* uniform, float value) const { glUniform1f(at(uniform), value); }
  void set(const char* uniform, const glm::vec2& v) const { glUniform2f(at(uniform), v.x, v.y); }
  void set(const char* uniform, const glm::vec3& v) const { glUniform3f(at(uniform), v.x, v.y, v.z); }
  void set(const char* uniform, const glm::vec4& v) const { glUniform4f(at(uniform), v.x, v.y, v.z, v.w); }
  void set(const char* uniform, const glm::mat4& m) const {
    glUniformMatrix4fv(at(uniform), 1, GL_FALSE, &m[0][0]);
  }

 private:
  explicit ShaderProgram(GlProgram program) : program_(std::move(program)) {}
  GLint at(const char* uniform) const { return glGetUniformLocation(program_.get(), uniform); }

  GlProgram program_;
};

}  // namespace planewright::render
