#include "workshop.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/complex/state.h"
#include "core/design/design.h"
#include "core/design/layer_solve.h"
#include "core/fabricate/export_run.h"
#include "core/mesh/sample_shapes.h"
#include "core/solve/solver_choice.h"
#include "measurement.h"
#include "mesh_runs.h"
#include "value_of.h"

namespace planewright::bench {
namespace {

constexpr double kGoalSeconds = 20.0;
constexpr int kGoalPanels = 1000;      // and more
constexpr double kPanelSize = 1000.0;  // mm, mean edge that every model is brought to
constexpr double kThickness = 20.0;    // mm
constexpr double kGap = 8.0;           // mm

// CPU seconds of one export, by stage.
struct Stages {
  double naming = 0.0, preparing = 0.0, writing = 0.0;
  double total() const { return naming + preparing + writing; }
};

ExportSettings all_formats() {
  ExportSettings settings;
  settings.formats.insert(export_formats().begin(), export_formats().end());
  settings.thickness = kThickness;
  settings.gap = kGap;
  settings.density = 2500.0;
  settings.nesting = NestingOptions{};
  settings.overwrite = true;
  return settings;
}

// No panel may cross itself: such a one has no pattern, and no certificate says yes to it.
Panels solved_dual(const PolygonMesh& mesh) {
  LayerSettings layer;
  layer.mode = ComplexKind::Dual;
  layer.demands.list.push_back({"uncrossed", true, {}, {}});
  const auto complex = value_of(build_complex(mesh, layer));
  const auto solver = make_solver(SolverKind::Tangent);
  const State state = value_of(solve_layer(*solver, {complex, layer, {}, {}, {}},
                                           start_state(*complex, layer), solve_options(layer), nullptr, {}))
                          .state;
  Panels panels = panels_of(*complex, state);
  panels.points *= kPanelSize / complex->mean_edge;
  return panels;
}

void measure(const std::string& name, const PolygonMesh& mesh, int repeat) {
  const Panels panels = solved_dual(mesh);
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("planewright-bench-" + std::to_string(::getpid()));
  const ExportSettings settings = all_formats();
  Stages best;
  ExportPreparation prepared;
  ExportOutcome outcome;
  for (int k = 0; k < repeat; ++k) {
    Stages stages;
    double begun = cpu_seconds();
    const auto lap = [&begun] {
      const double now = cpu_seconds(), took = now - begun;
      begun = now;
      return took;
    };
    WorkshopOptions naming;
    naming.title = name;
    naming.unit = LengthUnit::Millimetre;
    const auto model = value_of(make_workshop_model(panels.points, panels.polygons, naming));
    stages.naming = lap();
    prepared = value_of(prepare_export(model, settings, nullptr));
    stages.preparing = lap();
    outcome = value_of(write_export(model, prepared, settings, folder));
    stages.writing = lap();
    if (k == 0 || stages.total() < best.total()) best = stages;
  }
  std::filesystem::remove_all(folder);
  const int count = panels.polygons.size();
  const bool met = best.total() <= kGoalSeconds && outcome.certificate.pass();
  const char* verdict = count < kGoalPanels ? "" : met ? "met" : "MISSED";
  std::printf("%-26s %7d %8.2f %8.2f %8.2f %8.2f %6s %7zu %7.1f %6zu  %s\n", name.c_str(), count, best.naming,
              best.preparing, best.writing, best.total(), verdict, prepared.nesting->sheets.size(),
              100.0 * prepared.nesting->filled, outcome.files.size(),
              outcome.certificate.pass() ? "certified" : "NOT CERTIFIED");
  std::fflush(stdout);
}

void measure_workshop(const MeshRunOptions& options) {
  std::printf(
      "Duals with a mean edge of %g mm, %g mm thick, gap %g mm, sheets of 3210 x 6000 mm, all formats, read "
      "back and\n"
      "certified; demanded: uncrossed. CPU seconds, best of %d. Goal: all within %g s, certified, for %d "
      "panels and "
      "more.\n\n"
      "%-26s %7s %8s %8s %8s %8s %6s %7s %7s %6s\n",
      kPanelSize, kThickness, kGap, options.repeat, kGoalSeconds, kGoalPanels, "", "panels", "names",
      "prepare", "write", "total", "goal", "sheets", "filled", "files");
  measure("dome", value_of(make_sample("dome", 1000)), options.repeat);
  for_each_mesh(
      options, {"tri/train-station.off", "tri/bunny1k.obj"},
      [&](const std::string& file, const PolygonMesh& mesh) { measure(file, mesh, options.repeat); });
}

}  // namespace

void declare_workshop(CLI::App& app) {
  auto options = std::make_shared<MeshRunOptions>();
  CLI::App* command =
      app.add_subcommand("workshop", "CPU time of an export in all formats, certificate included");
  declare_mesh_run(*command, *options);
  command->callback([options] { measure_workshop(*options); });
}

}  // namespace planewright::bench
