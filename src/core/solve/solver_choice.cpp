#include "core/solve/solver_choice.h"

#include "core/solve/auto_solver.h"
#include "core/solve/ipopt_solver.h"
#include "core/solve/tangent_solver.h"

namespace planewright {

const std::vector<SolverKind>& all_solvers() {
  static const std::vector<SolverKind> all{SolverKind::Ipopt, SolverKind::Tangent, SolverKind::Auto};
  return all;
}

const char* name(SolverKind kind) {
  switch (kind) {
    case SolverKind::Ipopt:
      return "ipopt";
    case SolverKind::Tangent:
      return "tangent";
    case SolverKind::Auto:
      return "auto";
  }
  return "";
}

Result<SolverKind> find_solver(const std::string& wanted) {
  std::string known;
  for (const SolverKind kind : all_solvers()) {
    if (wanted == name(kind)) return kind;
    known += (known.empty() ? "" : ", ") + std::string(name(kind));
  }
  return fail(ErrorCode::Usage, "there is no solver of the name '" + wanted + "'", "--solver",
              "Known: " + known);
}

std::unique_ptr<Solver> make_solver(SolverKind kind) {
  switch (kind) {
    case SolverKind::Ipopt:
      return make_ipopt_solver();
    case SolverKind::Tangent:
      return make_tangent_solver();
    case SolverKind::Auto:
      return make_auto_solver();
  }
  return nullptr;
}

}  // namespace planewright
