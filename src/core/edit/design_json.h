// A design (layers with all their settings, selections, reference surface) as a project file has it, both
// ways. Internal to edit/. Threads: pure.
#pragma once

#include "core/design/layer_settings.h"
#include "core/edit/json_reader.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

nlohmann::ordered_json design_json(const Design& design);

// What is absent is as LayerSettings, Layer and Design begin. Fails for values that no design may have and
// elements that the mesh does not have; names of energies and demands are the solver's business.
Design read_design(JsonReading& reading, const nlohmann::json* json, const std::string& path,
                   const PolygonMesh& mesh);

extern const std::span<const std::pair<ComplexKind, const char*>> kModeWords;
extern const std::span<const std::pair<BorderPolicy, const char*>> kBorderWords;

}  // namespace planewright
