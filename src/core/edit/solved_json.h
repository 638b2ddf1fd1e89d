// Solved panels as a project file has them, both ways, and what of a design has to fit its complexes.
// Internal to edit/. Threads: pure.
#pragma once

#include <optional>
#include <vector>

#include "core/complex/state.h"
#include "core/design/layer_settings.h"
#include "core/edit/json_reader.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

struct Regions;

nlohmann::ordered_json solved_json(const std::vector<std::optional<State>>& solved);

// #layers. json: null for none. regions: of the mesh, null without. Panels that do not fit mesh and settings
// (another number of points or planes, normals that are not unit) are left out, with a warning: they can be
// solved again. Fails for lists that are none. Fails, too, for waivers of the design that name elements which
// its panels do not have.
std::vector<std::optional<State>> read_solved(JsonReading& reading, const nlohmann::json* json,
                                              const std::string& path, const PolygonMesh& mesh,
                                              const Regions* regions, const Design& design);

}  // namespace planewright
