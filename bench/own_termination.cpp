#include "own_termination.h"

#include <cstdio>
#include <filesystem>
#include <functional>

#include "baselines.h"
#include "core/design/design.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "measurement.h"
#include "table.h"
#include "value_of.h"

namespace planewright::bench {
namespace {

using SharedComplex = std::shared_ptr<const TangentComplex>;

// complex: as the solver is shown it; mean_edge: model units.
Measurement measure(const SharedComplex& complex, const LayerSettings& settings,
                    const IpoptOverrides& overrides, double mean_edge) {
  Measurement row;
  const double wall = wall_seconds(), cpu = cpu_seconds();
  const auto problem = value_of(build_problem(complex, settings));
  const SolveReport report = make_ipopt_solver(overrides)->solve(*problem, start_state(*complex, settings),
                                                                 solve_options(settings), nullptr, {});
  row.cpu = cpu_seconds() - cpu;
  row.wall = wall_seconds() - wall;
  measure_report(row, report, *complex, mean_edge);
  return row;
}

}  // namespace

void compare_on_torus(int rows, int columns, bool baselines) {
  std::printf("dual of the torus, %d x %d; position energy alone\n", rows, columns);
  print_solver_head();
  const auto run = [&](const char* name, const IpoptOverrides& overrides, bool raw) {
    const MeasuredRow row = best_of(
        1,
        [&] {
          const LayerSettings settings;
          const SharedComplex complex = value_of(build_complex(make_torus(rows, columns), settings));
          return measure(raw ? raw_coordinates(*complex) : complex, settings, overrides, complex->mean_edge);
        },
        {});
    print_solver_row(name, row);
    return row;
  };
  const MeasuredRow ours = run("as shipped", {}, false);
  if (!baselines) return;
  run("prototype's options", prototype_options(), false);
  const MeasuredRow defaults = run("default, raw coordinates", default_options(), true);
  if (ours.end == ChildEnd::Finished && defaults.end == ChildEnd::Finished)
    std::printf(
        "as shipped against default options: %.1f times faster (wall), %.1f (CPU); energy %.4f of its\n",
        defaults.value.wall / ours.value.wall, defaults.value.cpu / ours.value.cpu,
        ours.value.energy / defaults.value.energy);
}

void measure_meshes(const std::vector<std::string>& files) {
  print_solver_head();
  for (const std::string& file : files) {
    const auto work = [&] {
      const PolygonMesh mesh = value_of(load_mesh(file)).mesh;
      LayerSettings settings;
      settings.mode = suggested_mode(mesh);
      const SharedComplex complex = value_of(build_complex(mesh, settings));
      return measure(complex, settings, {}, complex->mean_edge);
    };
    print_solver_row(std::filesystem::path(file).filename().string(), best_of(1, work, {}));
  }
}

}  // namespace planewright::bench
