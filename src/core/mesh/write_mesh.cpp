// format_mesh(): polygons as the text of an OBJ, OFF, PLY or STL file.
#include <Eigen/Geometry>
#include <array>
#include <charconv>
#include <limits>
#include <string>

#include "core/mesh/mesh_io.h"
#include "core/mesh/triangulate.h"

namespace planewright {
namespace {

void append(std::string& out, double value) {
  std::array<char, 32> buffer;
  // 17 significant digits bring back every double exactly.
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 17);
  out.append(buffer.data(), end.ptr);
}

void append(std::string& out, int value) {
  std::array<char, 16> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  out.append(buffer.data(), end.ptr);
}

// "PREFIX x y z\n", the prefix with its blank.
template <class Row>
void append_point(std::string& out, const char* prefix, const Row& point) {
  out += prefix;
  append(out, point[0]);
  out += ' ';
  append(out, point[1]);
  out += ' ';
  append(out, point[2]);
  out += '\n';
}

Result<void> check(const Points& positions, const Polygons& faces) {
  for (int v = 0; v < positions.rows(); ++v)
    if (!positions.row(v).allFinite())
      return fail(ErrorCode::Refused, "a coordinate is not a finite number", "vertex " + std::to_string(v),
                  "A file could not hold it");
  for (int f = 0; f < faces.size(); ++f) {
    if (faces.valence(f) < 3)
      return fail(ErrorCode::Refused, "the face has fewer than 3 corners", "face " + std::to_string(f),
                  "Remove the face");
    for (int v : faces[f])
      if (v < 0 || v >= positions.rows())
        return fail(ErrorCode::Refused,
                    "the face names vertex " + std::to_string(v) + ", which does not exist",
                    "face " + std::to_string(f), "Correct or remove the face");
  }
  return {};
}

void append_counted_faces(std::string& out, const Polygons& faces) {
  for (int f = 0; f < faces.size(); ++f) {
    append(out, faces.valence(f));
    for (int v : faces[f]) {
      out += ' ';
      append(out, v);
    }
    out += '\n';
  }
}

std::string format_obj(const Points& positions, const Polygons& faces) {
  std::string out;
  for (int v = 0; v < positions.rows(); ++v) append_point(out, "v ", positions.row(v));
  for (int f = 0; f < faces.size(); ++f) {
    out += 'f';
    for (int v : faces[f]) {
      out += ' ';
      append(out, v + 1);
    }
    out += '\n';
  }
  return out;
}

std::string format_off(const Points& positions, const Polygons& faces) {
  std::string out = "OFF\n" + std::to_string(positions.rows()) + " " + std::to_string(faces.size()) + " 0\n";
  for (int v = 0; v < positions.rows(); ++v) append_point(out, "", positions.row(v));
  append_counted_faces(out, faces);
  return out;
}

std::string format_ply(const Points& positions, const Polygons& faces) {
  int longest = 0;
  for (int f = 0; f < faces.size(); ++f) longest = std::max(longest, faces.valence(f));
  // Most readers expect a byte for the length of a list; only longer ones ask for more.
  const char* length_type = longest <= std::numeric_limits<unsigned char>::max() ? "uchar" : "int";
  std::string out = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(positions.rows()) +
                    "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                    std::to_string(faces.size()) + "\nproperty list " + length_type +
                    " int vertex_indices\nend_header\n";
  for (int v = 0; v < positions.rows(); ++v) append_point(out, "", positions.row(v));
  append_counted_faces(out, faces);
  return out;
}

std::string format_stl(const Points& positions, const Polygons& faces) {
  std::string out = "solid planewright\n";
  for (int f = 0; f < faces.size(); ++f)
    for (const std::array<int, 3>& triangle : triangulate(positions, faces[f])) {
      const Vector3d normal = newell_vector(positions, triangle);
      append_point(out, "facet normal ", Vector3d(normal.stableNormalized()));
      out += "outer loop\n";
      for (int v : triangle) append_point(out, "vertex ", positions.row(v));
      out += "endloop\nendfacet\n";
    }
  return out + "endsolid planewright\n";
}

}  // namespace

Result<std::string> format_mesh(MeshFormat format, const Points& positions, const Polygons& faces) {
  if (auto ok = check(positions, faces); !ok) return tl::unexpected(ok.error());
  switch (format) {
    case MeshFormat::Obj:
      return format_obj(positions, faces);
    case MeshFormat::Off:
      return format_off(positions, faces);
    case MeshFormat::Ply:
      return format_ply(positions, faces);
    case MeshFormat::Stl:
      return format_stl(positions, faces);
  }
  return fail(ErrorCode::Usage, "the format is unknown", {}, "Use OBJ, OFF, PLY or STL");
}

}  // namespace planewright
