// SolverKind: which solver a designer asks for, by the names that the command line and reports use.
//
//   tangent   the structured solver (tangent_solver.h): milliseconds where Ipopt takes seconds, every shown
//             state planar
//   ipopt     the general interior point solver, the referee (ipopt_solver.h)
//   auto      tangent first, then Ipopt from its state and multipliers to confirm; Ipopt alone where the
//             tangent solver cannot take the problem (auto_solver.h)
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/solve/solver.h"

namespace planewright {

enum class SolverKind { Ipopt, Tangent, Auto };

const std::vector<SolverKind>& all_solvers();
const char* name(SolverKind kind);  // "ipopt", "tangent", "auto"
// Fails with ErrorCode::Usage, the known names listed.
Result<SolverKind> find_solver(const std::string& name);

// A solver keeps what it learnt of a topology (the analysis of its matrices) for the next solve: hold on to
// it as long as problems of one design follow each other.
std::unique_ptr<Solver> make_solver(SolverKind kind);

}  // namespace planewright
