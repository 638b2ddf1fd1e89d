// Whether what one run made keeps clear of itself: panels of different layers, and the parallel offsets,
// which no solve knows of, against the mesh and the other layers.
#pragma once

#include <vector>

#include "cli/exit_status.h"
#include "cli/layer_run.h"
#include "core/export/solve_record.h"

namespace planewright::cli {

// Fills in SolveRecord::crosses and what cross their parallel offsets. layers, records: one per layer that
// was solved. Less than the margin is touching and none; what "no-penetration" was given up at does not count
// against the mesh.
void count_crossings(const std::vector<SolvedLayer>& layers, std::vector<SolveRecord>& records);

// One line for each two that cross.
void print_crossings(const std::vector<SolveRecord>& records);

// kNotMet, with a warning, where a layer that is to penetrate nothing does.
ExitStatus judge_crossings(const std::vector<SolveRecord>& records);

}  // namespace planewright::cli
