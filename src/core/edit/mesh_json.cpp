#include "core/edit/mesh_json.h"

#include <array>

namespace planewright {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;
using Edges = std::vector<std::array<int, 2>>;

Edges edges_of(const PolygonMesh& mesh) {
  Edges edges;
  edges.reserve(static_cast<std::size_t>(mesh.edge_count()));
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const MeshEdge edge = mesh.edge(e);
    edges.push_back({edge.a, edge.b});
  }
  return edges;
}

Polygons read_faces(JsonReading& reading, const Json& json, const std::string& path, int vertices) {
  Polygons faces;
  if (!reading.list(json, path)) return faces;
  for (std::size_t f = 0; f < json.size() && !reading.failed(); ++f)
    faces.push_back(reading.integers(json[f], entry_path(path, f), 0, vertices - 1));
  return faces;
}

Edges read_edges(JsonReading& reading, const Json& json, const std::string& path, int vertices) {
  Edges edges;
  if (!reading.list(json, path)) return edges;
  for (std::size_t e = 0; e < json.size() && !reading.failed(); ++e) {
    const std::vector<int> ends = reading.integers(json[e], entry_path(path, e), 0, vertices - 1);
    if (!reading.failed() && ends.size() != 2) reading.fail(entry_path(path, e), "an edge has two ends");
    if (!reading.failed()) edges.push_back({ends[0], ends[1]});
  }
  return edges;
}

}  // namespace

Written mesh_json(const PolygonMesh& mesh) {
  Written vertices = Written::array(), faces = Written::array();
  const Points& positions = mesh.positions();
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
    vertices.push_back({positions(v, 0), positions(v, 1), positions(v, 2)});
  const Polygons polygons = mesh.faces();
  for (int f = 0; f < polygons.size(); ++f)
    faces.push_back(std::vector<int>(polygons[f].begin(), polygons[f].end()));
  Written json = {{"vertices", std::move(vertices)}, {"faces", std::move(faces)}};
  const auto plain = PolygonMesh::from_polygons(positions, polygons);
  if (const Edges edges = edges_of(mesh); plain && edges_of(*plain) != edges) json["edges"] = edges;
  return json;
}

PolygonMesh read_mesh(JsonReading& reading, const Json& json, const std::string& path) {
  JsonObject object(reading, &json, path);
  Points positions(0, 3);
  if (const Json* vertices = object.needed("vertices"))
    positions = reading.points(*vertices, object.path_of("vertices"));
  Polygons faces;
  if (const Json* list = object.needed("faces"))
    faces = read_faces(reading, *list, object.path_of("faces"), static_cast<int>(positions.rows()));
  if (faces.empty()) object.fail("faces", "the mesh has no faces");
  const Json* listed = object.find("edges");
  const Edges edges =
      listed ? read_edges(reading, *listed, object.path_of("edges"), static_cast<int>(positions.rows()))
             : Edges();
  if (reading.failed()) return {};
  auto mesh = listed ? PolygonMesh::from_polygons(positions, faces, edges)
                     : PolygonMesh::from_polygons(positions, faces);
  if (mesh) return std::move(*mesh);
  Error error = mesh.error();
  error.code = ErrorCode::Unreadable;
  error.where = reading.file() + ", " + path + (error.where.empty() ? std::string() : ", " + error.where);
  reading.fail(std::move(error));
  return {};
}

}  // namespace planewright
