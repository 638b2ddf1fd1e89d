// IpoptSolver: the general interior point solver as the referee of the field ([Z] section 2.3): exact
// Hessian, our own normalisation instead of Ipopt's scaling, and a final projection that brings planarity to
// rounding.
//
// Supports Ipopt 3.11 (Debian 12) and later; only ipopt_solver.cpp includes its headers. Uses MUMPS through
// the gate.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "core/solve/solver.h"

namespace planewright {

// Ipopt's own options by name, on top of (or instead of) ours; for benchmarks.
struct IpoptOverrides {
  std::map<std::string, std::string> strings;
  std::map<std::string, double> numbers;
  std::map<std::string, int> integers;
  int gauss_newton_iterations =
      40;  // at most so many steps without the constraints' curvature; 0: exact from the start
  bool own_termination =
      true;  // stop by our test of first order and feasibility; false: by Ipopt's options alone
  // A stop test of the caller's own, so that different solvers can be asked one question: called at every
  // iterate of the problem itself (not in restoration) with z, the rows' multipliers and the infeasibility,
  // all in the problem's units. True ends the solve at that iterate.
  std::function<bool(const Vector& z, const Vector& multipliers, double infeasibility)> stop_when = {};
};

std::unique_ptr<Solver> make_ipopt_solver(IpoptOverrides overrides = {});

}  // namespace planewright
