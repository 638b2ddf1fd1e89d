#include "demands.h"

#include <cstdio>
#include <filesystem>
#include <functional>

#include "core/design/design.h"
#include "core/design/layer_solve.h"
#include "core/design/presets.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "core/solve/solver_choice.h"
#include "table.h"
#include "value_of.h"

namespace planewright::bench {
namespace {

// What to solve: loaded in the process that solves it.
struct Case {
  std::string name;
  std::function<PolygonMesh()> mesh;
};

Case case_of(const std::string& file) {
  return {std::filesystem::path(file).filename().string(), [file] { return value_of(load_mesh(file)).mesh; }};
}

// offset_edges: in mean panel edges.
Measurement solve(const PolygonMesh& mesh, LayerSettings settings, double offset_edges, SolverKind kind) {
  settings.offset = 0.0;
  const double edge = value_of(build_complex(mesh, settings))->mean_edge;
  settings.offset = offset_edges * edge;
  Measurement row;
  const double wall = wall_seconds(), cpu = cpu_seconds();
  const auto complex = value_of(build_complex(mesh, settings));
  const SolveReport report =
      value_of(solve_layer(*make_solver(kind), {complex, settings, {}, {}, {}},
                           start_state(*complex, settings), solve_options(settings), nullptr, {}));
  row.cpu = cpu_seconds() - cpu;
  row.wall = wall_seconds() - wall;
  measure_report(row, report, *complex, complex->mean_edge);
  return row;
}

void measure(const Case& each, const LayerSettings& settings, double offset, const DemandOptions& options) {
  for (const std::string& solver : options.solvers) {
    const SolverKind kind = value_of(find_solver(solver));
    const auto work = [&] { return solve(each.mesh(), settings, offset, kind); };
    print_demand_row(each.name, offset, solver, best_of(1, work, {.seconds = options.seconds}));
  }
}

}  // namespace

void measure_non_penetration(const DemandOptions& options) {
  LayerSettings settings;
  settings.demands.list = {{"vertex"}, {"face"}, {"edge"}};
  for (const std::string& name : options.also) settings.demands.list.push_back({name});
  settings.no_penetration = true;
  std::vector<Case> cases;
  for (const std::string& file : options.files) cases.push_back(case_of(file));
  if (cases.empty()) {
    cases.push_back({"torus, 1600 vertices", [] { return make_torus(40, 40); }});
    for (const char* sample : {"dome", "alpine-hut", "train-station", "train-station-unsymmetric"})
      cases.push_back({sample, [sample] { return value_of(make_sample(sample, 0)); }});
  }
  std::printf(
      "duals with the vertex, face and edge constraints; offset, rms, max: mean edges; MB: peak memory;\n"
      "self-x: panels that cross themselves; cross: pairs of a panel and a mesh triangle that cross\n");
  print_demand_head();
  for (const double offset : options.offsets)
    for (const Case& each : cases) measure(each, settings, offset, options);
}

void measure_uncrossed(const DemandOptions& options) {
  LayerSettings settings;
  settings.mode = ComplexKind::Planarize;
  if (const auto applied = apply(*value_of(find_preset("uncrossed")), settings); !applied)
    throw std::runtime_error(applied.error().text());
  std::printf("planarized with the preset 'uncrossed'; self-x: panels that cross themselves\n");
  print_demand_head();
  for (const std::string& file : options.files) measure(case_of(file), settings, 0.0, options);
}

}  // namespace planewright::bench
