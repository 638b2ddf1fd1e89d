// Solving one layer and writing what comes of it: panels, their parallel offset, beams.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/layer_jobs.h"
#include "core/base/result.h"
#include "core/export/solve_record.h"

namespace planewright::cli {

struct SolvedLayer {
  std::shared_ptr<const TangentComplex> complex;
  State state;
  std::optional<State> offset;  // parallel, where there is a thickness
};

// jobs[earlier.size()] is the one to solve; adds what it gives to `earlier`. Fails where nothing could be
// solved or a file could not be written; any other outcome is a record.
Result<SolveRecord> run_layer(const std::vector<LayerJob>& jobs, const SolveCommandOptions& options,
                              const DesignFiles& files, std::vector<SolvedLayer>& earlier);

}  // namespace planewright::cli
