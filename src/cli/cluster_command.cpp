// planewright-cli cluster IN -o OUT --panels K: a fine mesh becomes a few planar panels.
#include <chrono>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include "cli/cluster_options.h"
#include "cli/cluster_progress.h"
#include "cli/commands.h"
#include "cli/design_files.h"
#include "cli/layer_jobs.h"
#include "cli/layer_series.h"
#include "cli/project_output.h"
#include "cli/solve_options.h"
#include "core/base/atomic_file.h"
#include "core/design/region_file.h"
#include "core/mesh/mesh_io.h"

namespace planewright::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kPreset = "proxy-planes";

// Ctrl-C ends the clustering with the regions of that moment; panels are made of them.
Result<std::shared_ptr<const ClusteredMesh>> find_regions(const std::shared_ptr<const PolygonMesh>& mesh,
                                                          const ClusterOptions& options, bool quiet) {
  ClusterProgressLine progress(quiet);
  auto clustered = cluster_mesh(mesh, options, &progress, progress.stop_token());
  if (!clustered) return tl::unexpected(as_given(clustered.error()));
  if ((*clustered)->clustering.stopped)
    std::fprintf(
        stderr,
        "planewright-cli: note: clustering was stopped; panels are made of the %d regions that there "
        "are by now. Ctrl-C again stops their solve, and writes the best state\n",
        (*clustered)->regions.count());
  return clustered;
}

Result<std::shared_ptr<const ClusteredMesh>> gather(const std::shared_ptr<const PolygonMesh>& mesh,
                                                    const RegionRequest& request, bool quiet) {
  if (!request.from_regions.empty()) {
    auto regions = read_regions(request, mesh->face_count());
    if (!regions) return tl::unexpected(regions.error());
    auto clustered = mesh_of_regions(mesh, std::move(*regions), metric_of(request));
    if (!clustered) clustered.error().where = request.from_regions + ", " + clustered.error().where;
    return clustered;
  }
  const auto options = cluster_options(request, mesh->face_count());
  if (!options) return tl::unexpected(options.error());
  return find_regions(mesh, *options, quiet);
}

Result<ExitStatus> run(const SolveCommandOptions& options, const RegionRequest& request) {
  const auto begun = Clock::now();
  auto plan = plan_layers(options);
  if (!plan) return tl::unexpected(plan.error());
  if (auto checked = check_files(options, *plan, inputs_of(request), {{"--regions", request.regions}});
      !checked)
    return tl::unexpected(checked.error());

  auto loaded = load_mesh(options.input);
  if (!loaded) return tl::unexpected(loaded.error());
  if (!loaded->health.healthy())
    std::fprintf(stderr, "planewright-cli: note: %s: %s\n", options.input.c_str(),
                 loaded->health.summary().c_str());
  const auto mesh = std::make_shared<const PolygonMesh>(std::move(loaded->mesh));
  const auto files = read_design_files(options, *mesh);
  if (!files) return tl::unexpected(files.error());
  auto clustered = gather(mesh, request, options.quiet);
  if (!clustered) return tl::unexpected(clustered.error());
  plan->clustered = std::move(*clustered);
  if (!request.regions.empty()) {
    const auto& region_of_face = plan->clustered->regions.region_of_face;
    if (auto saved = write_file_atomically(request.regions, region_csv(region_of_face)); !saved)
      return tl::unexpected(saved.error());
  }
  if (auto prepared = prepare_layers(*plan, options, ComplexKind::Cluster, *files, *mesh); !prepared)
    return tl::unexpected(prepared.error());
  note_idle_reference(*plan, options);
  const double seconds_build = std::chrono::duration<double>(Clock::now() - begun).count();
  std::vector<SolvedLayer> solved;
  const auto status = solve_layers(*plan, options, *files, loaded->health, seconds_build, solved);
  if (!status) return status;
  if (auto saved = save_project_of(options, *mesh, *plan, *files, solved); !saved)
    return tl::unexpected(saved.error());
  return status;
}

}  // namespace

void add_cluster_command(CLI::App& app, ExitStatus& status) {
  auto options = std::make_shared<SolveCommandOptions>();
  auto request = std::make_shared<RegionRequest>();
  options->settings.mode = ComplexKind::Cluster;
  auto* command = app.add_subcommand("cluster", "A few planar panels, each for a region of a fine mesh");
  declare_region_options(*command, request);
  declare_solve_options(*command, options);
  declare_project_option(*command, options);
  command->callback([options, request, &status] {
    // Positions alone would let corners pull panels out of the planes that fit their regions.
    if (options->preset.empty() && !options->explicit_points) options->preset = kPreset;
    const auto result = run(*options, *request);
    status = result ? *result : report(result.error());
  });
}

}  // namespace planewright::cli
