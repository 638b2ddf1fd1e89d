// --project: what a run had and found, as a project to go on with in the window or in other commands.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "cli/design_files.h"
#include "cli/layer_jobs.h"
#include "cli/layer_run.h"
#include "cli/solve_options.h"
#include "core/base/result.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright::cli {

void declare_project_option(CLI::App& command, const std::shared_ptr<SolveCommandOptions>& options);

// Writes it, if it was asked for. solved: of the first jobs; those after it were stopped before their turn.
// Fails as save_project() does.
Result<void> save_project_of(const SolveCommandOptions& options, const PolygonMesh& mesh,
                             const LayerPlan& plan, const DesignFiles& files,
                             const std::vector<SolvedLayer>& solved);

}  // namespace planewright::cli
