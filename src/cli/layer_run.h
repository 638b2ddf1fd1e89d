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

// The layer that this one is made to fit; null: none.
std::shared_ptr<const NeighbourLayer> neighbour_of(const LayerJob& job,
                                                   const std::vector<SolvedLayer>& earlier);

// Solves one job, with progress on stderr, and writes nothing. earlier: the layers solved before. Fails where
// nothing could be solved.
Result<SolveReport> solve_job(const LayerJob& job, const SolveCommandOptions& options,
                              const DesignFiles& files, const std::vector<SolvedLayer>& earlier);

// jobs[earlier.size()] is the one to solve; adds what it gives to `earlier`. Fails where nothing could be
// solved or a file could not be written; any other outcome is a record.
Result<SolveRecord> run_layer(const std::vector<LayerJob>& jobs, const SolveCommandOptions& options,
                              const DesignFiles& files, std::vector<SolvedLayer>& earlier);

}  // namespace planewright::cli
