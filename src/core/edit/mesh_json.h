// A mesh as a project file has it, both ways. Internal to edit/. Threads: pure.
#pragma once

#include "core/edit/json_reader.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

// Edges are listed where their numbers differ from those that the faces alone give (after flips).
nlohmann::ordered_json mesh_json(const PolygonMesh& mesh);

// Fails for what PolygonMesh::from_polygons() refuses, and for a mesh without faces.
PolygonMesh read_mesh(JsonReading& reading, const nlohmann::json& json, const std::string& path);

}  // namespace planewright
