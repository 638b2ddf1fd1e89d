#include "core/certify/obj_reader.h"

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <cmath>
#include <sstream>

#include "core/certify/file_bytes.h"

namespace planewright {
namespace {

// Comments before the first line that is none.
std::string opening_comments(const std::string& content) {
  std::istringstream in(content);
  std::string all, line;
  while (std::getline(in, line) && (line.empty() || line[0] == '#' || line == "\r"))
    if (line.size() > 1) all += line.substr(1);
  return all;
}

}  // namespace

std::string obj_reader_name() {
  return "tinyobjloader (double)";
}

Result<ReadMesh> read_obj_file(const std::filesystem::path& path) {
  const auto bytes = file_bytes(path);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::string name = path.filename().string();
  if (bytes->back() != '\n') return fail(ErrorCode::Unreadable, "the last line does not end", name);
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::istringstream in(*bytes);
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &in, nullptr, false, false) ||
      !error.empty())
    return fail(ErrorCode::Unreadable, error.empty() ? "tinyobjloader cannot read it" : error, name);
  const auto count = static_cast<Eigen::Index>(attributes.vertices.size() / 3);
  if (count == 0) return fail(ErrorCode::Unreadable, "no vertices", name);
  ReadMesh mesh;
  mesh.unit = opening_comments(*bytes);
  mesh.points = Eigen::Map<const Points>(attributes.vertices.data(), count, 3);
  if (!mesh.points.allFinite()) return fail(ErrorCode::Unreadable, "a coordinate is not finite", name);
  std::vector<int> face;
  for (const tinyobj::shape_t& shape : shapes) {
    if (shape.mesh.num_face_vertices.empty()) continue;
    const int object = static_cast<int>(mesh.objects.size());
    mesh.objects.push_back(shape.name);
    size_t at = 0;
    for (const auto valence : shape.mesh.num_face_vertices) {
      face.clear();
      for (size_t k = 0; k < valence; ++k) {
        const int index = shape.mesh.indices[at++].vertex_index;
        if (index < 0 || index >= count)
          return fail(ErrorCode::Unreadable, "a face of '" + shape.name + "' has a corner that is not there",
                      name);
        face.push_back(index);
      }
      mesh.faces.push_back(face);
      mesh.object_of_face.push_back(object);
    }
  }
  if (mesh.faces.empty()) return fail(ErrorCode::Unreadable, "no faces", name);
  return mesh;
}

}  // namespace planewright
