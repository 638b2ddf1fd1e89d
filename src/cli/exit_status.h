// The command line's exit statuses: stable, scripts and tests rest on them.
#pragma once

#include "core/base/result.h"
#include "core/solve/solve_report.h"

namespace planewright::cli {

enum ExitStatus {
  kSuccess = 0,      // converged and everything met
  kNotMet = 1,       // a state was written, but it is not converged or misses a tolerance
  kUsage = 2,        // bad usage
  kUnreadable = 3,   // input unreadable or refused
  kInfeasible = 4,   // the demands cannot be met together (best state written, demands named)
  kUnavailable = 5,  // the machine lacks something (disk space, OpenGL, memory)
};

ExitStatus exit_status(ErrorCode code);
ExitStatus exit_status(SolveStatus status);

// Prints "planewright-cli: error: ..." to stderr and returns the status that goes with it.
ExitStatus report(const Error& error);

}  // namespace planewright::cli
