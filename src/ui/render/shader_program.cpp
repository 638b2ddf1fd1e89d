#include "ui/render/shader_program.h"

#include <algorithm>
#include <string>

#include "core/base/atomic_file.h"

namespace planewright::render {
namespace {

Result<std::string> source_of(const std::string& name, const std::filesystem::path& folder) {
  if (!folder.empty()) return read_file(folder / name);
  return std::string(embedded_shader(name));
}

Result<GlShader> compile(GLenum stage, const std::string& name, const std::filesystem::path& folder) {
  const auto source = source_of(name, folder);
  if (!source) return tl::unexpected(source.error());
  GlShader shader(glCreateShader(stage));
  const char* text = source->c_str();
  glShaderSource(shader.get(), 1, &text, nullptr);
  glCompileShader(shader.get());
  GLint compiled = 0, log_length = 0;
  glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  glGetShaderiv(shader.get(), GL_INFO_LOG_LENGTH, &log_length);
  std::string log(static_cast<size_t>(std::max(log_length, 1)), '\0');
  glGetShaderInfoLog(shader.get(), log_length, nullptr, log.data());
  return fail(ErrorCode::Unavailable, "the shader does not compile: " + log, name,
              "Planewright needs OpenGL 3.3 or newer");
}

}  // namespace

Result<ShaderProgram> ShaderProgram::load(std::string_view name, const std::filesystem::path& folder) {
  const auto vertex = compile(GL_VERTEX_SHADER, std::string(name) + ".vert", folder);
  if (!vertex) return tl::unexpected(vertex.error());
  const auto fragment = compile(GL_FRAGMENT_SHADER, std::string(name) + ".frag", folder);
  if (!fragment) return tl::unexpected(fragment.error());

  GlProgram program = GlProgram::create();
  glAttachShader(program.get(), vertex->get());
  glAttachShader(program.get(), fragment->get());
  glLinkProgram(program.get());
  GLint linked = 0, log_length = 0;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return ShaderProgram(std::move(program));
  glGetProgramiv(program.get(), GL_INFO_LOG_LENGTH, &log_length);
  std::string log(static_cast<size_t>(std::max(log_length, 1)), '\0');
  glGetProgramInfoLog(program.get(), log_length, nullptr, log.data());
  return fail(ErrorCode::Unavailable, "the shaders do not link: " + log, std::string(name),
              "Planewright needs OpenGL 3.3 or newer");
}

}  // namespace planewright::render
