#include "cluster.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/cluster/regions.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "measurement.h"
#include "models.h"
#include "table.h"
#include "value_of.h"

namespace planewright::bench {
namespace {

constexpr double kGoalSeconds = 5.0;   // 100,000 triangles into 1,000 regions
constexpr double kGoalLiveMs = 100.0;  // 10,000 triangles, one region more or fewer

struct ClusterBenchOptions {
  std::string meshes;
  int repeat = 5;
};

// Least CPU time of so many runs, ms.
double best_ms(int repeat, const std::function<void()>& work) {
  double best = 0.0;
  for (int k = 0; k < repeat; ++k) {
    const double begun = cpu_seconds();
    work();
    const double ms = 1e3 * (cpu_seconds() - begun);
    best = k == 0 ? ms : std::min(best, ms);
  }
  return best;
}

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

void measure_cluster(const ClusterBenchOptions& options) {
  const std::filesystem::path meshes = meshes_folder(options.meshes);
  std::printf(
      "Clustering by the default metric and seeds, teleports included. CPU ms, best of %d; one more, one "
      "fewer:\n"
      "from the clustering before, as a slider's step. Goals: 100,000 triangles into 1,000 regions within %g "
      "s;\n"
      "10,000 triangles, one region more or fewer, within %g ms.\n\n  %-14s %6s %10s\n",
      options.repeat, kGoalSeconds, kGoalLiveMs, "", "K", "CPU ms");
  measure_mesh("torus", make_torus(200, 250), {1000}, options.repeat);
  measure_mesh("torus", make_torus(50, 100), {50, 200, 500}, options.repeat);
  for (const char* file : {"tri/feline.obj", "tri/fertility.off", "tri/bunny1k.obj"}) {
    std::error_code error;
    if (meshes.empty() || !std::filesystem::is_regular_file(meshes / file, error))
      print_skipped(file, "it is not there; name its folder with --meshes");
    else
      measure_mesh(file, value_of(load_mesh((meshes / file).string())).mesh, {50, 200, 500}, options.repeat);
  }
}

}  // namespace

void declare_cluster(CLI::App& app) {
  auto options = std::make_shared<ClusterBenchOptions>();
  CLI::App* command =
      app.add_subcommand("cluster", "Time of clustering into regions, anew and as K changes by one");
  command->add_option(
      "--meshes", options->meshes,
      "Folder of the real meshes (default: $PLANEWRIGHT_MESHES, else shared/meshes near the source)");
  command->add_option("--repeat", options->repeat, "Measure each so often; the least CPU time counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->callback([options] { measure_cluster(*options); });
}

}  // namespace planewright::bench
