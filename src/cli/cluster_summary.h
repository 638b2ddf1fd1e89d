// What a person is told of a clustering and how near its panels are to the mesh.
#pragma once

#include <string>

#include "core/design/cluster_report.h"

namespace planewright::cli {

void print_clusters(const ClusterReport& report, const std::string& unit);

// Whether it came to its end and meets the error that was asked for; warns if not. begin: of the warning's
// line.
bool clustering_done(const ClusterReport& report, const std::string& begin);

}  // namespace planewright::cli
