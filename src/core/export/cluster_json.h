// The part "cluster" of a report, with the keys of docs/command-line.md. Internal to export/. Threads: pure.
#pragma once

#include "core/design/cluster_report.h"
#include "core/export/json_parts.h"

namespace planewright {

Json cluster_json(const ClusterReport& report);

}  // namespace planewright
