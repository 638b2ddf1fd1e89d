// planewright-bench: one run prints a table, side by side, of Ipopt with its default options in raw
// coordinates, of the first prototype's options, and of this program as it ships.
//
//   planewright-bench                            the torus of 10,000 panels (minutes: mostly the default
//   options) planewright-bench --rows 40 --columns 40     a small one planewright-bench --mesh FILE... this
//   program alone on real meshes planewright-bench --no-penetration [--offset E ...] [--also NAME ...]
//   [--mesh FILE...]    with the paper's constraints planewright-bench --uncrossed --mesh FILE... quads that
//   do not cross themselves
//
// Times are of one process on one thread: wall and CPU (user + system); ratios within one run are what counts
// on a shared machine. Energy and displacement in mean edges, planarity relative to the bounding box's
// diagonal.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "baselines.h"
#include "core/design/design.h"
#include "core/export/solve_record.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "demands.h"
#include "table.h"

namespace planewright::bench {
namespace {

Row measure(std::string name, std::shared_ptr<const TangentComplex> complex, const LayerSettings& settings,
            const IpoptOverrides& overrides, double mean_edge) {
  Row row;
  row.name = std::move(name);
  const auto begun = std::chrono::steady_clock::now();
  const double cpu = cpu_seconds();
  const auto problem = build_problem(complex, settings);
  if (!problem) throw std::runtime_error(problem.error().text());
  row.report = make_ipopt_solver(overrides)->solve(**problem, start_state(*complex, settings),
                                                   solve_options(settings), nullptr, {});
  row.cpu = cpu_seconds() - cpu;
  row.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  measure_state(row, *complex, mean_edge);
  return row;
}

void compare_on_torus(int rows, int columns, bool baselines) {
  const PolygonMesh torus = make_torus(rows, columns);
  LayerSettings settings;
  const auto complex = build_complex(torus, settings);
  if (!complex) throw std::runtime_error(complex.error().text());
  const double edge = (*complex)->mean_edge;
  std::printf("dual of the torus, %d x %d: %d panels, %d points; position energy alone\n", rows, columns,
              (*complex)->plane_count(), (*complex)->point_count());
  print_head();
  const Row ours = measure("as shipped", *complex, settings, {}, edge);
  print(ours);
  if (!baselines) return;
  const Row prototype = measure("prototype's options", *complex, settings, prototype_options(), edge);
  print(prototype);
  const Row defaults = measure("default options, raw coordinates", raw_coordinates(**complex), settings,
                               default_options(), edge);
  print(defaults);
  std::printf(
      "as shipped against default options: %.1f times faster (wall), %.1f (CPU); energy %.4f of its\n",
      defaults.wall / ours.wall, defaults.cpu / ours.cpu, ours.energy / defaults.energy);
}

void measure_meshes(const std::vector<std::string>& files) {
  print_head();
  for (const std::string& file : files) {
    const auto checked = load_mesh(file);
    if (!checked) throw std::runtime_error(checked.error().text());
    LayerSettings settings;
    settings.mode = suggested_mode(checked->mesh);
    const auto complex = build_complex(checked->mesh, settings);
    if (!complex) throw std::runtime_error(complex.error().text());
    const auto slash = file.find_last_of('/');
    print(measure(file.substr(slash == std::string::npos ? 0 : slash + 1), *complex, settings, {},
                  (*complex)->mean_edge));
  }
}

}  // namespace
}  // namespace planewright::bench

int main(int argc, char** argv) {
  using namespace planewright;
  CLI::App app{"Measures solvers side by side in one run"};
  int rows = 100, columns = 100;  // frozen: 10,000 panels
  bool only_ours = false, no_penetration = false, uncrossed = false;
  std::vector<double> offsets{0.2};
  std::vector<std::string> also;
  std::vector<std::string> meshes;
  app.add_option("--rows", rows, "Torus: vertices round the tube")->check(CLI::Range(4, 2000));
  app.add_option("--columns", columns, "Torus: vertices round the axis")->check(CLI::Range(4, 2000));
  app.add_flag("--only-ours", only_ours, "Leave out the baselines");
  app.add_option("--mesh", meshes, "Real meshes instead of the torus");
  auto* constraints = app.add_flag("--no-penetration", no_penetration, "Duals with the paper's constraints");
  app.add_option("--offset", offsets, "With --no-penetration: offsets, mean panel edges")->needs(constraints);
  app.add_option("--also", also, "With --no-penetration: further demands, by name")->needs(constraints);
  app.add_flag("--uncrossed", uncrossed, "Real meshes planarized with the preset 'uncrossed'");
  CLI11_PARSE(app, argc, argv);
  try {
    if (no_penetration)
      bench::measure_non_penetration(meshes, offsets, also);
    else if (uncrossed)
      bench::measure_uncrossed(meshes);
    else if (meshes.empty())
      bench::compare_on_torus(rows, columns, !only_ours);
    else
      bench::measure_meshes(meshes);
    std::printf("peak memory %.0f MB\n", peak_memory_mb());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "planewright-bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
