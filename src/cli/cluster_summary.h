// What a person is told of a clustering and how near its panels are to the mesh.
#pragma once

#include <string>

#include "core/design/cluster_report.h"

namespace planewright::cli {

void print_clusters(const ClusterReport& report, const std::string& unit);

// Whether the error that was asked for is met; warns if not. begin: of the warning's line.
bool error_met(const ClusterReport& report, const std::string& begin);

}  // namespace planewright::cli
