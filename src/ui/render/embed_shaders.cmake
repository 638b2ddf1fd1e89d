# cmake -DOUTPUT=file.cpp -DFOLDER=shaders "-DNAMES=a.vert|a.frag" -P embed_shaders.cmake
# Writes the shaders as string literals with a function that finds one by its name.
string(REPLACE "|" ";" NAMES "${NAMES}")
set(table "")
foreach(name IN LISTS NAMES)
  file(READ "${FOLDER}/${name}" source)
  string(APPEND table "    {\"${name}\", R\"glsl(${source})glsl\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Made from shaders/ by embed_shaders.cmake.
#include <string_view>
#include <utility>

#include \"ui/render/shader_program.h\"

namespace planewright::render {
namespace {

constexpr std::pair<std::string_view, std::string_view> kShaders[] = {
${table}};

}  // namespace

std::string_view embedded_shader(std::string_view name) {
  for (const auto& [key, source] : kShaders) {
    if (key == name) return source;
  }
  return {};
}

}  // namespace planewright::render
")
