// The baseline without optimisation (--explicit), as a report like any other.
#pragma once

#include <memory>

#include "core/design/layer_settings.h"
#include "core/solve/solve_report.h"

namespace planewright::cli {

// Energies are what those of an optimisation come to here, for comparison; left out where the problem cannot
// be stated.
SolveReport solve_explicitly(const std::shared_ptr<const TangentComplex>& complex,
                             const LayerSettings& settings);

}  // namespace planewright::cli
