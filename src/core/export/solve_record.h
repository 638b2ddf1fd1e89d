// SolveRecord: everything the report of one run says, and its JSON form: what the command line writes with
// --report and scripts rely on. Lengths in model units unless a name says otherwise.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/design/layer_settings.h"
#include "core/diagnose/ill_determined.h"
#include "core/diagnose/panel_shape.h"
#include "core/diagnose/planarity.h"
#include "core/layers/parallel_offset.h"
#include "core/mesh/health_report.h"
#include "core/solve/solve_report.h"

namespace planewright {

// The panels' other side, and how exactly its corners fit.
struct OffsetRecord {
  std::string file;
  double thickness = 0.0;
  Planarity planarity;  // of the panels as written and read back
  std::vector<ParallelOffset::Blunted> blunted;
  std::vector<ParallelOffset::Residual> residuals;
};

struct BeamsRecord {
  std::string file;
  std::string with;  // "offset": the layer's own parallel offset; else the other layer's name
  int count = 0;
  double max_planarity = 0.0;  // distance of a corner from the beam's plane
  double max_twist = 0.0;      // radians
};

struct SolveRecord {
  std::string input;
  std::string layer;      // its name; empty: the only one
  std::string preset;     // that the settings began with; empty: none
  std::string reference;  // file that closeness refers to; empty: the mesh itself
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
  std::optional<OffsetRecord> offset_layer;
  std::optional<BeamsRecord> beams;
  double seconds_build = 0.0, seconds_total = 0.0;
};

// The JSON text, two-space indented, with the keys of docs/command-line.md. Numbers that are not finite
// become null.
std::string to_json(const SolveRecord& record);
// Of several layers of one design: what they share, and "layers", a list of records. At least one.
std::string to_json(const std::vector<SolveRecord>& layers);

// What a report that to_json wrote gives up: the demands of its "conflicts", and those that its own run had
// given up ("waived"). layer: whose, empty for a report without layers. name: what errors call the file.
// Fails with ErrorCode::Unreadable: no such report, or one without that layer.
Result<std::vector<Waiver>> read_waivers(std::string_view json, const std::string& name,
                                         const std::string& layer);

// Peak resident memory of this process so far, MB; 0 where the system does not tell.
double peak_memory_mb();

}  // namespace planewright
