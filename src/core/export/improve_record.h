// ImproveRecord: what `planewright-cli improve` did to a design, and its JSON form with the keys of
// docs/command-line.md. Lengths in model units unless a name says otherwise.
#pragma once

#include <string>

#include "core/advise/improve.h"
#include "core/diagnose/planarity.h"
#include "core/mesh/health_report.h"

namespace planewright {

struct ImproveRecord {
  std::string input, panels_file, mesh_file;  // mesh_file: empty if not asked for
  HealthReport health;
  ImproveReport report;
  Planarity planarity;  // of the panels as written and read back
  double seconds = 0.0;
};

std::string to_json(const ImproveRecord& record);

}  // namespace planewright
