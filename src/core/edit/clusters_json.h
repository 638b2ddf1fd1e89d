// The regions of a design of clusters as a project file has them, both ways. Internal to edit/. Threads:
// pure.
#pragma once

#include "core/design/clustered_mesh.h"
#include "core/edit/json_reader.h"

namespace planewright {

nlohmann::ordered_json clusters_json(const ClusterRecord& clusters);

// faces: of the mesh. Fails for regions that are not one number for each face, and for options that no
// clustering takes; whether regions are connected is what clusters_of() finds out.
ClusterRecord read_clusters(JsonReading& reading, const nlohmann::json& json, const std::string& path,
                            int faces);

}  // namespace planewright
