#include "core/solve/finish_solve.h"

#include "core/solve/projection.h"

namespace planewright {
namespace {

// After the projection the residual may have grown by as much as its (tiny) move times the curvature.
constexpr double kStationaryAfterProjection = 10.0;

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
                  const SolveOptions& options, SolveReport& report) {
  report.state = problem.to_state({z.data(), static_cast<size_t>(z.size())});
  const ProjectionReport projection =
      project_onto_incidences(problem.complex(), report.state, problem.layout().freedom);
  report.incidence_residual = projection.after;
  report.projection_move = projection.move;

  const Vector projected = problem.from_state(report.state);
  report.multipliers = multipliers;
  report.first_order_residual = problem.first_order_residual(projected.data(), multipliers.data());
  for (const auto& share : problem.energy_shares(projected.data()))
    report.energies.push_back({share.name, share.weight, share.value});
  for (const auto& violation : problem.violations(projected.data(), options.planarity_tolerance))
    report.constraints.push_back({violation.name, violation.max_violation, violation.violated});

  const bool planar = report.incidence_residual <= options.planarity_tolerance;
  if (!planar && (report.status == SolveStatus::Converged || report.status == SolveStatus::Planar)) {
    report.status = SolveStatus::NotPlanar;
    report.stop_reason += "; some points do not lie on all of their planes";
  }
  if (report.status == SolveStatus::Converged &&
      !(report.first_order_residual <= kStationaryAfterProjection * options.tolerance)) {
    report.status = SolveStatus::Planar;
    report.stop_reason = "the exact projection moved the state away from where it was stationary";
  }
}

}  // namespace planewright
