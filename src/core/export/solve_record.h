// SolveRecord: everything the report of one run says, and its JSON form: what the command line writes with
// --report and scripts rely on. Lengths in model units unless a name says otherwise.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/design/cluster_report.h"
#include "core/design/layer_settings.h"
#include "core/diagnose/diagnosis.h"
#include "core/diagnose/ill_determined.h"
#include "core/diagnose/panel_shape.h"
#include "core/diagnose/planarity.h"
#include "core/layers/parallel_offset.h"
#include "core/mesh/health_report.h"
#include "core/solve/solve_report.h"

namespace planewright {

// Pairs of panels that cross, by the name of the other layer.
using LayerCrossings = std::vector<std::pair<std::string, int>>;

// The panels' other side, and how exactly its corners fit.
struct OffsetRecord {
  std::string file;
  double thickness = 0.0;
  Planarity planarity;  // of the panels as written and read back
  std::vector<ParallelOffset::Blunted> blunted;
  std::vector<ParallelOffset::Residual> residuals;
  int crossings = 0;       // pairs of one of its panels and a face of the mesh that cross
  LayerCrossings crosses;  // with the panels of each other layer, and with their offset
};

struct BeamsRecord {
  std::string file;
  std::string with;  // "offset": the layer's own parallel offset; else the other layer's name
  int count = 0;
  double max_planarity = 0.0;  // distance of a corner from the beam's plane
  double max_twist = 0.0;      // radians
  int most_twisted_edge = -1;  // panel edge; -1: there are none
  int turned_round = 0;        // beams twisted by more than a right angle: their edges run against each other
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
  Diagnosis diagnosis;
  std::optional<ClusterReport> clusters;  // of panels of clusters
  std::optional<OffsetRecord> offset_layer;
  std::optional<BeamsRecord> beams;
  LayerCrossings crosses;  // of the panels with those of each other layer of the run
  double seconds_build = 0.0, seconds_total = 0.0;
};

// Whether a constraint of the report is a demand, and no equation that every problem has.
bool is_demand(const SolveReport::Constraint& constraint);

// Names of the demands that were asked for and hold nothing: there is no element that they speak of (an empty
// selection, a kind of point that the panels lack), or no value that limits one. Nothing if the solve got to
// no state.
std::vector<std::string> demands_without_rows(const SolveRecord& record);

// Panels that cross themselves although `uncrossed` or `star` is demanded of the whole model and was not
// given up there.
std::vector<int> forbidden_self_crossings(const SolveRecord& record);

// The JSON text, two-space indented, with the keys of docs/command-line.md. Numbers that are not finite
// become null.
std::string to_json(const SolveRecord& record);
// Of several layers of one design: what they share, and "layers", a list of records. At least one.
std::string to_json(const std::vector<SolveRecord>& layers);

struct EarlierReport {
  std::vector<Waiver> waivers;  // its "conflicts", and what its own run had given up ("waived")
  int panels = 0, points = 0;
};

// What a report that to_json wrote gives up, and of how many panels and points. layer: whose, empty for a
// report without layers. name: what errors call the file. Fails with ErrorCode::Unreadable: no such report,
// one without that layer, a demand that does not exist.
Result<EarlierReport> read_waivers(std::string_view json, const std::string& name, const std::string& layer);

// Peak resident memory of this process so far, MB; 0 where the system does not tell.
double peak_memory_mb();

}  // namespace planewright
