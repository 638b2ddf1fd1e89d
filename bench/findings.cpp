#include "findings.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/design/design.h"
#include "core/design/layer_solve.h"
#include "core/diagnose/close_points.h"
#include "core/diagnose/collapsed_quads.h"
#include "core/diagnose/crossing_panels.h"
#include "core/diagnose/diagnosis.h"
#include "core/diagnose/far_points.h"
#include "core/diagnose/ill_determined_points.h"
#include "core/diagnose/not_convex_panels.h"
#include "core/diagnose/reversed_edges.h"
#include "core/diagnose/self_crossing_panels.h"
#include "core/diagnose/twisted_beams.h"
#include "core/mesh/sample_shapes.h"
#include "core/solve/solver_choice.h"
#include "measurement.h"
#include "mesh_runs.h"
#include "value_of.h"

namespace planewright::bench {
namespace {

constexpr double kGoalMs = 100.0;
constexpr int kGoalPanels = 10000;

struct Detector {
  FindingKind kind;
  std::function<void(const Subject&, double threshold)> find;
};

void measure(const std::string& name, const PolygonMesh& mesh, int repeat) {
  LayerSettings layer;
  layer.mode = suggested_mode(mesh);
  const auto complex = value_of(build_complex(mesh, layer));
  const auto solver = make_solver(SolverKind::Tangent);
  const State state = value_of(solve_layer(*solver, {complex, layer, {}, {}, {}},
                                           start_state(*complex, layer), solve_options(layer), nullptr, {}))
                          .state;
  const FindingSettings settings;
  // Beams to the wanted places: as many as there are edges.
  const NeighbourLayer other{complex, initial_state(*complex)};
  const MeshPlaces places(*complex);
  const Subject subject{*complex, state, places};
  FindingSettings none;
  for (auto& of : none.kinds) of.on = false;
  const auto crossing = [&](FindingKind kind) {
    return [&, kind](const Subject& s, double) {
      FindingSettings only = none;
      only[kind].on = true;
      find_crossing_panels(s, only);
    };
  };
  const std::vector<Detector> detectors{
      {FindingKind::IllDetermined, find_ill_determined_points},
      {FindingKind::ClosePoints, find_close_points},
      {FindingKind::ReversedEdge, find_reversed_edges},
      {FindingKind::SelfCrossing, find_self_crossing_panels},
      {FindingKind::FoldedOver, crossing(FindingKind::FoldedOver)},
      {FindingKind::CrossingPanels, crossing(FindingKind::CrossingPanels)},
      {FindingKind::NotConvex,
       [&](const Subject& s, double t) { find_not_convex_panels(s, t, settings.least_defect); }},
      {FindingKind::FarPoint, find_far_points},
      {FindingKind::CollapsedQuad, find_collapsed_quads},
      {FindingKind::TwistedBeam, [&](const Subject& s, double t) { find_twisted_beams(s, other, t); }}};
  const Diagnosis all = diagnose(*complex, state, settings, &other);
  std::printf("%s: %d panels%s\n", name.c_str(), complex->plane_count(), all.solved ? "" : ", NOT SOLVED");
  std::printf("  %-18s %8.2f\n", "places of the mesh", best_ms(repeat, [&] { MeshPlaces again(*complex); }));
  for (const Detector& detector : detectors)
    std::printf("  %-18s %8.2f %8d\n", info(detector.kind).name,
                best_ms(repeat, [&] { detector.find(subject, settings[detector.kind].threshold); }),
                all.count(detector.kind));
  const double total = best_ms(repeat, [&] { diagnose(*complex, state, settings, &other); });
  const char* verdict = complex->plane_count() != kGoalPanels ? "" : total <= kGoalMs ? "met" : "MISSED";
  std::printf("  %-18s %8.2f %8zu  %s\n\n", "all", total, all.findings.size(), verdict);
  std::fflush(stdout);
}

void measure_findings(const MeshRunOptions& options) {
  std::printf(
      "Panels solved for their wanted positions, thresholds by default, beams to the wanted places. CPU ms,\n"
      "best of %d; folded-over and crossing-panels are one search, shown for each alone. Goal: all within\n"
      "%g ms at %d panels.\n\n  %-18s %8s %8s\n",
      options.repeat, kGoalMs, kGoalPanels, "", "CPU ms", "found");
  measure("torus", make_torus(100, 100), options.repeat);
  for_each_mesh(
      options,
      {"tri/bunny1k.obj", "tri/train-station.off", "tri/aqua-center.off", "tri/torus.off",
       "quad/fertility_quad.off"},
      [&](const std::string& file, const PolygonMesh& mesh) { measure(file, mesh, options.repeat); });
}

}  // namespace

void declare_findings(CLI::App& app) {
  auto options = std::make_shared<MeshRunOptions>();
  CLI::App* command =
      app.add_subcommand("findings", "Time and number of the findings, on the torus and real meshes");
  declare_mesh_run(*command, *options);
  command->callback([options] { measure_findings(*options); });
}

}  // namespace planewright::bench
