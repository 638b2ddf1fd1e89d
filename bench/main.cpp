// planewright-bench: one run prints a table, side by side, of Ipopt with its default options in raw
// coordinates, of the first prototype's options, and of this program as it ships.
//
//   planewright-bench                 the torus of 10,000 panels (minutes: the default options take most of
//   them) planewright-bench --rows 40 --columns 40        a small one planewright-bench --mesh FILE...  this
//   program alone on real meshes: time, planarity, displacement
//
// Times are of one process on one thread: wall and CPU (user + system); ratios within one run are what counts
// on a shared machine. Energy and displacement in mean edges, planarity relative to the bounding box's
// diagonal.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "baselines.h"
#include "core/diagnose/planarity.h"
#include "core/export/solve_record.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "core/design/design.h"

namespace planewright::bench {
namespace {

double cpu_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Row {
  std::string name;
  SolveReport report;
  double wall = 0.0, cpu = 0.0;
  double energy = 0.0;  // sum |x - f|^2, mean edges squared
  Displacement displacement;
  Planarity planarity;
};

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
  row.displacement = measure_displacement(row.report.state.x, complex->preferred);
  row.energy = row.displacement.per_point.squaredNorm() / (mean_edge * mean_edge);
  row.displacement.rms /= mean_edge;
  row.displacement.max /= mean_edge;
  const Panels panels = panels_of(*complex, row.report.state);
  row.planarity = measure_planarity(panels.points, panels.polygons);
  return row;
}

void print_head() {
  std::printf("%-34s %9s %9s %6s %12s %8s %8s %9s  %s\n", "", "wall s", "CPU s", "iter", "energy", "rms",
              "max", "planarity", "status");
}

void print(const Row& row) {
  std::printf("%-34s %9.2f %9.2f %6d %12.6g %8.4f %8.4f %9.1e  %s\n", row.name.c_str(), row.wall, row.cpu,
              row.report.iterations, row.energy, row.displacement.rms, row.displacement.max,
              row.planarity.max_relative_to_bbox, name(row.report.status));
  std::fflush(stdout);
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
  bool only_ours = false;
  std::vector<std::string> meshes;
  app.add_option("--rows", rows, "Torus: vertices round the tube")->check(CLI::Range(4, 2000));
  app.add_option("--columns", columns, "Torus: vertices round the axis")->check(CLI::Range(4, 2000));
  app.add_flag("--only-ours", only_ours, "Leave out the baselines");
  app.add_option("--mesh", meshes, "Real meshes instead of the torus");
  CLI11_PARSE(app, argc, argv);
  try {
    if (meshes.empty())
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
