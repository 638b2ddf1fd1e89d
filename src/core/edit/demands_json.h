// Demands and selections as a project file has them, both ways. Internal to edit/. Threads: pure.
#pragma once

#include "core/edit/json_reader.h"
#include "core/mesh/polygon_mesh.h"
#include "core/problem/demand.h"

namespace planewright {

nlohmann::ordered_json demands_json(const Demands& demands);
nlohmann::ordered_json selections_json(const std::vector<Selection>& selections);

// mode: of the layer, which says what a plane pin names. Fails for elements that the mesh does not have;
// those that waivers name are of the complex, and its reader's business.
Demands read_demands(JsonReading& reading, const nlohmann::json* json, const std::string& path,
                     ComplexKind mode, const PolygonMesh& mesh);
std::vector<Selection> read_selections(JsonReading& reading, const nlohmann::json& json,
                                       const std::string& path, const PolygonMesh& mesh);

}  // namespace planewright
