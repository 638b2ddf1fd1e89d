#include "cli/project_output.h"

#include <filesystem>
#include <utility>

#include "core/edit/project_file.h"

namespace planewright::cli {

void declare_project_option(CLI::App& command, const std::shared_ptr<SolveCommandOptions>& options) {
  command.add_option("--project", options->project,
                     "Project to write: mesh, settings and solved panels (.planewright)");
}

Result<void> save_project_of(const SolveCommandOptions& options, const PolygonMesh& mesh,
                             const LayerPlan& plan, const DesignFiles& files,
                             const std::vector<SolvedLayer>& solved) {
  if (options.project.empty()) return {};
  const auto unit = parse_length_unit(options.unit, "--unit");
  if (!unit) return tl::unexpected(unit.error());
  Design design;
  design.layers.clear();
  for (const LayerJob& job : plan.jobs) design.layers.push_back(job.layer);
  design.selections = files.selections;
  // The project may be opened from anywhere.
  if (!options.reference.empty())
    design.reference = std::filesystem::absolute(options.reference).lexically_normal().string();
  Project project =
      new_project(std::filesystem::path(options.input).filename().string(), mesh, std::move(design));
  project.contract.unit = *unit;
  if (plan.clustered) project.clusters = record_of(*plan.clustered);
  for (const SolvedLayer& layer : solved) project.solved.emplace_back(layer.state);
  project.solved.resize(project.design.layers.size());
  return save_project(options.project, project);
}

}  // namespace planewright::cli
