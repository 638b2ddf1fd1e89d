#include "cluster.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/cluster/anchor_polygons.h"
#include "core/cluster/regions.h"
#include "core/cluster/surface_distance.h"
#include "core/complex/cluster.h"
#include "core/design/presets.h"
#include "core/diagnose/panel_shape.h"
#include "core/diagnose/planarity.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/sample_shapes.h"
#include "core/solve/solver_choice.h"
#include "measurement.h"
#include "mesh_runs.h"
#include "value_of.h"

namespace planewright::bench {
namespace {

constexpr double kGoalSeconds = 5.0;   // 100,000 triangles into 1,000 regions
constexpr double kGoalLiveMs = 100.0;  // 10,000 triangles, one region more or fewer

// Of solved panels: relative to the diagonal; to the mesh, panel edges; of the RMS distance, times that of
// the anchor polygons.
constexpr double kPlanar = 1e-9, kFar = 2.0, kRatio = 1.1;

struct ClusterBenchOptions {
  MeshRunOptions run;
  std::vector<std::string> solvers{"tangent"};
};

// goal: ms, 0 for none.
void print_row(const char* what, int panels, double ms, double goal, const std::string& result) {
  std::printf("  %-14s %6d %10.1f  %-6s  %s\n", what, panels, ms,
              goal <= 0.0  ? ""
              : ms <= goal ? "met"
                           : "MISSED",
              result.c_str());
  std::fflush(stdout);
}

std::string told(const Clustering& clustering) {
  char text[120];
  std::snprintf(text, sizeof text, "normals off by %.4f (rms), %d iterations, %d teleports",
                clustering.normal_error, clustering.iterations, clustering.teleports);
  return text;
}

void measure_mesh(const std::string& name, const PolygonMesh& mesh, const std::vector<int>& sizes,
                  int repeat) {
  const FaceGraph graph = value_of(FaceGraph::create(mesh));
  std::printf("%s: %d faces\n", name.c_str(), graph.face_count());
  print_row("face graph", 0, best_ms(repeat, [&] { value_of(FaceGraph::create(mesh)); }), 0.0, "");
  for (const int panels : sizes) {
    ClusterOptions options;
    options.panels = panels;
    Clustering clustering;
    const double anew = best_ms(repeat, [&] { clustering = value_of(cluster(graph, options)); });
    const bool has_goal = graph.face_count() == 100000 && panels == 1000;
    print_row("anew", panels, anew, has_goal ? 1e3 * kGoalSeconds : 0.0, told(clustering));
    const double live_goal = graph.face_count() == 10000 ? kGoalLiveMs : 0.0;
    for (const int step : {1, -1}) {
      options.panels = panels + step;
      Clustering next;
      const double live =
          best_ms(repeat, [&] { next = value_of(cluster(graph, options, nullptr, {}, &clustering)); });
      print_row(step > 0 ? "one more" : "one fewer", options.panels, live, live_goal, told(next));
    }
    Regions regions;
    const double made = best_ms(repeat, [&] { regions = value_of(make_regions(graph, clustering)); });
    print_row("repair", regions.count(), made, 0.0, std::to_string(regions.repairs.size()) + " repairs");
  }
  std::printf("\n");
}

void solve_panels(const PolygonMesh& mesh, int panels, SolverKind kind) {
  const FaceGraph graph = value_of(FaceGraph::create(mesh));
  ClusterOptions options;
  options.panels = panels;
  const Regions regions = value_of(make_regions(graph, value_of(cluster(graph, options))));
  const auto complex = std::make_shared<const TangentComplex>(value_of(build_cluster(mesh, regions)));
  const auto problem = value_of(
      Problem::create(complex, {Freedom::NormalsAndOffsets, value_of(find_preset("proxy-planes"))->weights}));
  const double begun = cpu_seconds();
  const SolveReport report = make_solver(kind)->solve(*problem, initial_state(*complex), {}, nullptr, {});
  const double cpu = cpu_seconds() - begun;
  const Panels solved = panels_of(*complex, report.state);
  const double diagonal = bounding_diagonal(mesh.positions());
  const double planarity = measure_planarity(solved.points, solved.polygons).max / diagonal;
  const auto surface = value_of(ReferenceSurface::create(mesh.positions(), mesh.faces(), "the mesh"));
  double far = 0.0;
  for (Eigen::Index j = 0; j < solved.points.rows(); ++j)
    far = std::max(far, std::abs(surface->closest(solved.points.row(j), Vector3d::Zero()).distance));
  far /= complex->mean_edge;
  const auto distance =
      value_of(surface_distance(solved.points, solved.polygons, mesh.positions(), mesh.faces()));
  const auto classic = value_of(surface_distance(anchor_points(mesh, regions), regions.corners_of_region,
                                                 mesh.positions(), mesh.faces()));
  const double ratio = distance.rms() / classic.rms();
  // However panels are solved, each of these regions is at best as near to its plane as that.
  const Clustering best = value_of(clustering_of(graph, regions.region_of_face, ClusterMetric::l2()));
  const double least = best.distance_error * graph.length / classic.rms();
  const bool met = planarity <= kPlanar && far <= kFar && ratio <= kRatio;
  std::printf("  %4d %4d %-8s %8.2f  %-22s %9.1e %6.2f %8.5f %6.3f %6.3f %7zu %7d  %s\n", panels,
              regions.count(), name(kind), cpu, name(report.status), planarity, far,
              distance.rms() / diagonal, ratio, least,
              find_self_crossing(solved.points, solved.polygons).size(),
              regions.corners_by_valence().rbegin()->first, met ? "met" : "MISSED");
  std::fflush(stdout);
}

void solve_mesh(const std::string& name, const PolygonMesh& mesh, const ClusterBenchOptions& options) {
  std::printf("%s: %d faces\n", name.c_str(), mesh.face_count());
  for (const int panels : {50, 200, 500})
    for (const std::string& solver : options.solvers)
      if (panels < mesh.face_count()) solve_panels(mesh, panels, value_of(find_solver(solver)));
}

void measure_panels(const ClusterBenchOptions& options) {
  std::printf(
      "Panels solved with the preset 'proxy-planes'.\n"
      "  planar   worst corner off its plane, of the diagonal (<= %g)\n"
      "  far      farthest corner from the mesh, mean panel edges (<= %g)\n"
      "  rms      distance of panels and mesh, the larger of both sides, of the diagonal\n"
      "  ratio    of that and the same of the anchor polygons of these regions, which are not planar (<= "
      "%g)\n"
      "  least    the ratio of the regions' distance to their own best planes\n"
      "  crossed  panels that cross themselves; valence: the highest of a corner\n\n"
      "  %4s %4s %-8s %8s  %-22s %9s %6s %8s %6s %6s %7s %7s\n",
      kPlanar, kFar, kRatio, "K", "of", "solver", "CPU s", "", "planar", "far", "rms", "ratio", "least",
      "crossed", "valence");
  for_each_mesh(options.run, {"tri/bunny1k.obj", "tri/fertility.off", "tri/feline.obj"},
                [&](const std::string& file, const PolygonMesh& mesh) { solve_mesh(file, mesh, options); });
  for (const char* sample : {"alpine-hut", "train-station"})
    solve_mesh(sample, value_of(make_sample(sample)), options);
}

void measure_cluster(const ClusterBenchOptions& options) {
  std::printf(
      "Clustering by the default metric and seeds, teleports included. CPU ms, best of %d; one more, one "
      "fewer:\n"
      "from the clustering before, as a slider's step. Goals: 100,000 triangles into 1,000 regions within %g "
      "s;\n"
      "10,000 triangles, one region more or fewer, within %g ms.\n\n  %-14s %6s %10s\n",
      options.run.repeat, kGoalSeconds, kGoalLiveMs, "", "K", "CPU ms");
  measure_mesh("torus", make_torus(200, 250), {1000}, options.run.repeat);
  measure_mesh("torus", make_torus(50, 100), {50, 200, 500}, options.run.repeat);
  for_each_mesh(options.run, {"tri/feline.obj", "tri/fertility.off", "tri/bunny1k.obj"},
                [&](const std::string& file, const PolygonMesh& mesh) {
                  measure_mesh(file, mesh, {50, 200, 500}, options.run.repeat);
                });
  measure_panels(options);
}

}  // namespace

void declare_cluster(CLI::App& app) {
  auto options = std::make_shared<ClusterBenchOptions>();
  CLI::App* command =
      app.add_subcommand("cluster", "Time of clustering into regions, anew and as K changes by one");
  declare_mesh_run(*command, options->run);
  command->add_option("--solver", options->solvers, "Solvers of the panels: tangent, ipopt, auto")
      ->delimiter(',')
      ->capture_default_str();
  command->callback([options] { measure_cluster(*options); });
}

}  // namespace planewright::bench
