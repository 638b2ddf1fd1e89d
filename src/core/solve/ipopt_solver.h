// IpoptSolver: the general interior point solver as the referee of the field ([Z] section 2.3): exact
// Hessian, our own normalisation instead of Ipopt's scaling, and a final projection that brings planarity to
// rounding.
//
// Supports Ipopt 3.11 (Debian 12) and later; only ipopt_solver.cpp includes its headers. Uses MUMPS through
// the gate.
#pragma once

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
};

std::unique_ptr<Solver> make_ipopt_solver(IpoptOverrides overrides = {});

}  // namespace planewright
