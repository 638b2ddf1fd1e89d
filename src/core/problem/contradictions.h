// Contradictions that need no solver: demands on unknowns that pins leave no freedom. Each row whose unknowns
// are all held (or enter with coefficient 0) is a number; outside its bounds, the row's demand and the pin
// contradict each other whatever the panels do.
#pragma once

#include "core/base/result.h"
#include "core/problem/problem.h"

namespace planewright {

// Fails with ErrorCode::Infeasible, naming the first such pair: the demand and the pin that leaves it no
// choice.
Result<void> check_contradictions(const Problem& problem);

}  // namespace planewright
