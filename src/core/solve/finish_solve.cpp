#include "core/solve/finish_solve.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "core/solve/demand_projection.h"
#include "core/solve/multipliers.h"

namespace planewright {
namespace {

// A user who stops does not want to wait: so many steps of the projection reach planar panels from most
// iterates.
constexpr int kStepsAfterStop = 40;

// The constraint violated most, as "incidence, by 0.0021 edges".
std::string worst_constraint(const std::vector<Problem::ConstraintViolation>& violations) {
  const auto worst = std::max_element(violations.begin(), violations.end(), [](const auto& a, const auto& b) {
    return a.max_violation < b.max_violation;
  });
  if (worst == violations.end()) return "none";
  std::ostringstream text;
  text << worst->name << ", by " << std::setprecision(2) << worst->max_violation;
  if (!worst->unit.empty()) text << ' ' << worst->unit;
  text << " at worst, " << worst->violated << (worst->violated == 1 ? " place" : " places");
  return text.str();
}

// Of every point on every plane, mean edges; fixed planes have fewer rows than incidences.
double largest_incidence(const Problem& problem, const State& state) {
  const Vector residuals = incidence_residuals(problem.complex(), state);
  return residuals.size() > 0 ? residuals.lpNorm<Eigen::Infinity>() / problem.complex().mean_edge : 0.0;
}

}  // namespace

const char* name(SolveStatus status) {
  switch (status) {
    case SolveStatus::Converged:
      return "converged";
    case SolveStatus::Planar:
      return "planar, not converged";
    case SolveStatus::Stopped:
      return "stopped";
    case SolveStatus::NotPlanar:
      return "not planar";
    case SolveStatus::Infeasible:
      return "infeasible";
    case SolveStatus::Failed:
      return "failed";
  }
  return "";
}

void finish_solve(const Problem& problem, const Vector& z, const Vector& multipliers,
                  const SolveOptions& options, SolveReport& report, TangentCache* cache) {
  const bool stopped = report.status == SolveStatus::Stopped;
  Vector projected = z;
  const DemandProjectionReport projection = project_onto_demands(
      problem, projected, stopped ? kStepsAfterStop : kDemandProjectionSteps, options.abandoned, cache);
  report.state = problem.to_state({projected.data(), static_cast<size_t>(projected.size())});
  report.projection_move = projection.move;
  report.incidence_residual = largest_incidence(problem, report.state);
  report.multipliers = multipliers;
  const auto residual = [&] {
    return problem.first_order_residual(projected.data(), report.multipliers.data()) /
           problem.largest_weight();
  };
  report.first_order_residual = residual();
  if (!(report.first_order_residual <= options.tolerance) && !stopped) {
    report.multipliers = estimate_multipliers(problem, projected, multipliers, cache);
    report.first_order_residual = residual();
  }
  for (const auto& share : problem.energy_shares(projected.data()))
    report.energies.push_back({share.name, share.weight, share.value});
  const auto violations = problem.violations(projected.data(), options.planarity_tolerance);
  int violated = 0;
  for (const auto& violation : violations) {
    report.constraints.push_back({violation.name, violation.max_violation, violation.violated, violation.unit,
                                  violation.rows, violation.worst, violation.waived});
    violated += violation.violated;
  }

  if (projection.out_of_memory && !stopped) {
    report.status = SolveStatus::Failed;
    report.stop_reason = "out of memory";
  }
  const bool planar = report.incidence_residual <= options.planarity_tolerance;
  if (!planar) report.stop_reason += "; some points do not lie on all of their planes";
  switch (report.status) {
    case SolveStatus::Converged:
    case SolveStatus::Planar:
      if (!planar) {
        report.status = SolveStatus::NotPlanar;
      } else if (violated > 0) {
        report.status = SolveStatus::Infeasible;
        report.stop_reason += "; not met: " + worst_constraint(violations);
      }
      break;
    case SolveStatus::Infeasible:  // as the solver saw it; the projection may have found a way
      if (violated == 0) {
        report.status = SolveStatus::Planar;
        report.stop_reason = "the solver found no step that gained anything; the projection met the demands";
      } else {
        report.stop_reason += "; not met: " + worst_constraint(violations);
      }
      break;
    case SolveStatus::Stopped:
    case SolveStatus::NotPlanar:
    case SolveStatus::Failed:
      break;
  }
  if (report.status == SolveStatus::Converged && !(report.first_order_residual <= options.tolerance)) {
    report.status = SolveStatus::Planar;
    report.stop_reason = "the exact projection moved the state away from where it was stationary";
  }
}

}  // namespace planewright
