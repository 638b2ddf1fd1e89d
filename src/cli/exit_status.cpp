#include "cli/exit_status.h"

#include <cstdio>

namespace planewright::cli {

ExitStatus exit_status(ErrorCode code) {
  switch (code) {
    case ErrorCode::Usage:
      return kUsage;
    case ErrorCode::Unreadable:
    case ErrorCode::Refused:
      return kUnreadable;
    case ErrorCode::Infeasible:
      return kInfeasible;
    case ErrorCode::Unwritable:
    case ErrorCode::Unavailable:
      return kUnavailable;
  }
  return kUnavailable;
}

ExitStatus exit_status(SolveStatus status) {
  switch (status) {
    case SolveStatus::Converged:
      return kSuccess;
    case SolveStatus::Infeasible:
      return kInfeasible;
    case SolveStatus::Planar:
    case SolveStatus::Stopped:
    case SolveStatus::NotPlanar:
    case SolveStatus::Failed:
      return kNotMet;
  }
  return kNotMet;
}

ExitStatus report(const Error& error) {
  std::fprintf(stderr, "planewright-cli: error: %s\n", error.text().c_str());
  return exit_status(error.code);
}

}  // namespace planewright::cli
