// SolveRecord: everything the report of one run says, and its JSON form: what the command line writes with
// --report and scripts rely on. Lengths in model units unless a name says otherwise.
#pragma once

#include <string>

#include "core/diagnose/ill_determined.h"
#include "core/diagnose/panel_shape.h"
#include "core/diagnose/planarity.h"
#include "core/mesh/health_report.h"
#include "core/design/layer_settings.h"
#include "core/solve/solve_report.h"

namespace planewright {

struct SolveRecord {
  std::string input;
  LayerSettings settings;
  HealthReport health;
  SolveReport solve;
  int panels = 0, points = 0;
  double mean_edge = 1.0;  // model units: what a weight, a margin and a displacement in edges refer to
  Planarity planarity;     // of the panels as written to the file and read back
  Displacement displacement;
  std::vector<IllDetermined> ill_determined;
  std::vector<int> self_crossing;  // panels
  std::vector<ShortEdge> short_edges;
  double seconds_build = 0.0, seconds_total = 0.0;
};

// The JSON text, two-space indented, with the keys of docs/command-line.md. Numbers that are not finite
// become null.
std::string to_json(const SolveRecord& record);

// Peak resident memory of this process so far, MB; 0 where the system does not tell.
double peak_memory_mb();

}  // namespace planewright
