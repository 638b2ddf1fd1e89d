// format_stl(): triangles of single precision, binary, little-endian.
#include <Eigen/Geometry>
#include <bit>
#include <cstdint>

#include "core/writers/number_text.h"
#include "core/writers/solid_parts.h"

namespace planewright {
namespace {

constexpr size_t kHeader = 80;

void append_bytes(std::string& out, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((value >> shift) & 0xFF);
}
void append_vector(std::string& out, const Eigen::Vector3f& v) {
  for (int axis = 0; axis < 3; ++axis) append_bytes(out, std::bit_cast<std::uint32_t>(v[axis]));
}

}  // namespace

std::string format_stl(const SolidScene& scene) {
  // 6 letters and three numbers of 24 digits at most fit exactly. It must not begin with "solid".
  const Vector3d& origin = scene.model->origin;
  std::string out =
      "mm at " + number_text(origin.x()) + ' ' + number_text(origin.y()) + ' ' + number_text(origin.z());
  out.resize(kHeader, ' ');

  std::string body;
  std::uint32_t count = 0;
  for (const SolidPart& part : scene.parts) {
    for (const auto& [a, b, c] : triangles_of(part.points, part.faces)) {
      const Vector3d pa = part.points.row(a), pb = part.points.row(b), pc = part.points.row(c);
      append_vector(body, (pb - pa).cross(pc - pa).stableNormalized().cast<float>());
      for (const Vector3d& p : {pa, pb, pc}) append_vector(body, p.cast<float>());
      body.append(2, '\0');
      ++count;
    }
  }
  append_bytes(out, count);
  return out + body;
}

}  // namespace planewright
