// All layers of one run, one after the other: what the commands share that write panels.
#pragma once

#include <vector>

#include "cli/design_files.h"
#include "cli/exit_status.h"
#include "cli/layer_jobs.h"
#include "cli/layer_run.h"
#include "cli/solve_options.h"
#include "core/base/result.h"
#include "core/mesh/health_report.h"

namespace planewright::cli {

// What cannot be written should be known before the work, not after it. Fails as check_outputs() does, and
// for names whose ending is no format.
Result<void> check_files(const SolveCommandOptions& options, const LayerPlan& plan,
                         const std::vector<NamedFile>& further_inputs = {},
                         const std::vector<NamedFile>& further_outputs = {});

// Says so where --reference steers nothing, because 'closeness' has no weight.
void note_idle_reference(const LayerPlan& plan, const SolveCommandOptions& options);

// Solves a prepared plan, writes panels and report, and tells how it went. seconds_build: what it took to
// prepare. solved: gets the layers, in order; fewer than planned if the run was stopped. Fails where nothing
// could be solved or written; any other outcome is an exit status.
Result<ExitStatus> solve_layers(const LayerPlan& plan, const SolveCommandOptions& options,
                                const DesignFiles& files, const HealthReport& health, double seconds_build,
                                std::vector<SolvedLayer>& solved);

}  // namespace planewright::cli
