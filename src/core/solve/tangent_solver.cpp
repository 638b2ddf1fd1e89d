#include "core/solve/tangent_solver.h"

#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <new>

#include "core/solve/augmented_lagrangian.h"
#include "core/solve/demand_projection.h"
#include "core/solve/demand_start.h"
#include "core/solve/finish_solve.h"
#include "core/solve/multipliers.h"
#include "core/solve/mumps_gate.h"
#include "core/solve/planar_frames.h"
#include "core/solve/primal_dual_newton.h"
#include "core/solve/tangent_equations.h"

namespace planewright {
namespace {

using Clock = std::chrono::steady_clock;

// Factorisations of the augmented Lagrangian: enough to find the valley; Newton steps then go along it
// faster.
constexpr int kSoftSteps = 20;
constexpr double kSoftMostPenalty = 3e3;
// With demands, of kDemandAttempts: low in energy already, what these do not meet, more seldom do.
constexpr int kAttemptsNearSolution = 2;
// Share of the tolerance at which steps end, so that the projection afterwards has room.
constexpr double kStopShare = 0.9;

class TangentSolver final : public Solver {
 public:
  SolveReport solve(const Problem& problem, const State& start, const SolveOptions& options,
                    SolveObserver* observer, std::stop_token stop) override {
    const auto begun = Clock::now();
    const auto gate = enter_mumps_gate();
    SolveReport report;
    report.solver = "tangent";
    PlanarFrames frames(problem, observer, cache_, stop);
    try {
      Run run{problem, options, problem.from_state(start), Vector::Zero(problem.rows()), frames, stop};
      minimise(run, report);
      report.iterations = frames.told();
      SolveOptions finishing = options;
      // What was shown last is planar already: to rounding it takes one factorisation. Where the frame's
      // projection did not meet the demands, whoever stops does not wait for another one.
      if (report.status == SolveStatus::Stopped && frames.newest()) {
        run.z = *frames.newest();
        if (!frames.newest_meets_demands()) finishing.abandoned = stop;
      }
      finish_solve(problem, run.z, run.multipliers / share(problem), finishing, report, &cache_);
      remember(problem, report);
    } catch (const std::bad_alloc&) {
      report = keep_what_there_is(problem, start, frames);
    }
    report.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    return report;
  }

 private:
  struct Run {
    const Problem& problem;
    const SolveOptions& options;
    Vector z, multipliers;  // f relative to the largest weight
    PlanarFrames& frames;
    std::stop_token stop;
  };
  static double share(const Problem& problem) { return 1.0 / problem.largest_weight(); }

  // The report of a solve that ran out of memory; what the solver kept for the next one is freed first.
  SolveReport keep_what_there_is(const Problem& problem, const State& start, const PlanarFrames& frames) {
    cache_.clear();
    multipliers_.resize(0);
    remembered_rows_.clear();
    SolveReport report;
    report.solver = "tangent";
    report.status = SolveStatus::Failed;
    report.iterations = frames.told();
    if (const auto& shown = frames.newest()) {
      report.state = problem.to_state({shown->data(), static_cast<size_t>(shown->size())});
      report.stop_reason = "out of memory; the panels shown last are kept";
    } else {
      report.state = start;
      report.stop_reason = "out of memory; the state it began with is kept";
    }
    const Vector incidences = incidence_residuals(problem.complex(), report.state);
    if (incidences.size() > 0)
      report.incidence_residual = incidences.lpNorm<Eigen::Infinity>() / problem.complex().mean_edge;
    report.first_order_residual = std::numeric_limits<double>::quiet_NaN();  // not measured
    return report;
  }

  void minimise(Run& run, SolveReport& report) {
    const Problem& problem = run.problem;
    if (!std::isfinite(problem.objective(run.z.data())) || !run.z.allFinite()) {
      report.status = SolveStatus::Failed;
      report.stop_reason = "a function could not be evaluated at the start (not a finite number)";
      return;
    }
    run.frames.tell_start(run.z);
    if (run.options.near_solution &&
        (problem.has_demands() ? meets_demands_nearby(run) : is_almost_planar(run))) {
      recall(problem, run.multipliers);
      if (!drafted(run, report)) newton(run, report, Start::Near);
      return;
    }
    if (!problem.has_demands() && straight(run, report)) return;
    if (problem.has_demands()) {
      if (!find_demands(run, report) || drafted(run, report)) return;
    } else {
      soften(run, kSoftSteps, kSoftMostPenalty);
    }
    newton(run, report, Start::Valley);
  }

  // Most points on their planes, as after an edit that touched a few.
  static bool is_almost_planar(const Run& run) {
    Vector values(run.problem.rows());
    run.problem.constraint_values(run.z.data(), values.data());
    const int rows = run.problem.planarity_rows();
    const auto off = (values.head(rows).array().abs() > kOffPlane).count();
    return off <= std::max<Eigen::Index>(kEdited, rows / 10);
  }
  static constexpr double kOffPlane = 1e-3;    // mean edges
  static constexpr Eigen::Index kEdited = 24;  // incidences

  // Whether there is a state that meets every demand close to the start, moved there.
  bool meets_demands_nearby(Run& run) {
    Vector projected = run.z;
    const DemandProjectionReport projection =
        project_onto_demands(run.problem, projected, kDemandProjectionSteps, run.stop, &cache_);
    if (!projection.met || projection.move > kNearSolution) return false;
    run.z = projected;
    return true;
  }

  static bool drafted(const Run& run, SolveReport& report) {
    if (!run.options.draft || !run.problem.has_demands()) return false;
    report.status = SolveStatus::Planar;
    report.stop_reason = kDraftReason;
    return true;
  }

  // Stiff Gauss-Newton steps from the start; false, with the start kept, where its linearisation does not
  // hold.
  bool straight(Run& run, SolveReport& report) {
    const Vector start = run.z;
    NewtonOptions options = newton_options(run);
    options.begin_gauss_newton = true;
    options.only_straight = true;
    const NewtonReport newton =
        minimise_primal_dual(run.problem, run.z, run.multipliers, options, cache_, run.frames, run.stop);
    if (newton.end == NewtonEnd::NotStraight || newton.end == NewtonEnd::NoStep) {
      run.z = start;
      run.multipliers.setZero();
      return false;
    }
    damping_ = newton.damping;
    conclude(run, newton, report);
    return true;
  }

  AugmentedLagrangianReport soften(Run& run, int steps, double most_penalty) {
    AugmentedLagrangianOptions options;
    options.max_steps = std::min(steps, steps_left(run));
    options.most_penalty = most_penalty;
    options.coupling = EnergyCoupling::Dropped;
    options.cache = &cache_;
    options.tell = [&run](const Vector& z, double first_order, double step) {
      run.frames.tell(z, first_order, step, PlanarFrames::Distance::Far);
    };
    AugmentedLagrangianReport softened = minimise_augmented_lagrangian(run.problem, run.z, options, run.stop);
    run.multipliers = softened.multipliers * share(run.problem);
    return softened;
  }

  // Softly held demands, until a projection meets them all. False if none does.
  bool find_demands(Run& run, SolveReport& report) {
    Vector projected;
    int left =
        run.options.near_solution ? kAttemptsNearSolution : static_cast<int>(std::size(kDemandAttempts));
    for (const DemandAttempt& attempt : kDemandAttempts) {
      if (left-- == 0) break;
      const AugmentedLagrangianReport softened = soften(run, attempt.steps, attempt.most_penalty);
      if (softened.out_of_memory) throw std::bad_alloc();
      if (run.stop.stop_requested()) return stopped(report);
      projected = run.z;
      const DemandProjectionReport projection =
          project_onto_demands(run.problem, projected, kDemandProjectionSteps, run.stop, &cache_);
      if (projection.out_of_memory) throw std::bad_alloc();
      if (projection.met) return true;
      if (run.stop.stop_requested()) return stopped(report);
      if (steps_left(run) <= 0) break;
    }
    run.z = projected;
    report.status = SolveStatus::Infeasible;
    report.stop_reason = steps_left(run) > 0 ? "the demands could not be met together from here"
                                             : "the limit of " + std::to_string(run.options.max_iterations) +
                                                   " iterations was reached before the demands were met";
    return false;
  }

  static bool stopped(SolveReport& report) {
    report.status = SolveStatus::Stopped;
    report.stop_reason = "stopped by the user";
    return false;
  }

  int steps_left(const Run& run) const { return std::max(0, run.options.max_iterations - run.frames.told()); }

  // A result of nearly the same problem, or what the augmented Lagrangian found.
  enum class Start { Near, Valley };

  NewtonOptions newton_options(const Run& run) const {
    NewtonOptions options;
    options.max_steps = steps_left(run);
    options.first_order = kStopShare * run.options.tolerance;
    return options;
  }

  void newton(Run& run, SolveReport& report, Start start) {
    NewtonOptions options = newton_options(run);
    if (start == Start::Near) {
      options.begin_gauss_newton = true;
      options.damping = std::max(options.damping, damping_);
    }
    NewtonReport newton =
        minimise_primal_dual(run.problem, run.z, run.multipliers, options, cache_, run.frames, run.stop);
    // Where planes are nearly parallel, what rows still miss moves points far, and with them the slope: then
    // a few more steps from the exact state.
    for (int round = 0;
         round < kPolishingRounds && newton.end == NewtonEnd::Converged && !run.stop.stop_requested();
         ++round) {
      Vector exact = run.z;
      project_onto_demands(run.problem, exact, kDemandProjectionSteps, run.stop, &cache_);
      const Vector multipliers =
          estimate_multipliers(run.problem, exact, run.multipliers / share(run.problem), &cache_);
      const double residual =
          run.problem.first_order_residual(exact.data(), multipliers.data()) * share(run.problem);
      if (residual <= kStopShare * run.options.tolerance) break;
      run.z = exact;
      run.multipliers = without_unit_normals(run.problem, multipliers * share(run.problem));
      options = newton_options(run);
      options.at_solution = true;
      newton =
          minimise_primal_dual(run.problem, run.z, run.multipliers, options, cache_, run.frames, run.stop);
    }
    damping_ = newton.damping;
    conclude(run, newton, report);
  }
  static constexpr int kPolishingRounds = 3;

  static void conclude(const Run& run, const NewtonReport& newton, SolveReport& report) {
    switch (newton.end) {
      case NewtonEnd::Converged:
        report.status = SolveStatus::Converged;
        report.stop_reason = "feasible, and the energy is stationary to the tolerance";
        return;
      case NewtonEnd::Flat:
        report.status = SolveStatus::Planar;
        report.stop_reason =
            "the energy no longer falls; flat places leave rows that depend on each other, and multipliers "
            "open";
        return;
      case NewtonEnd::StepLimit:
        report.status = SolveStatus::Planar;
        report.stop_reason =
            "the limit of " + std::to_string(run.options.max_iterations) + " iterations was reached";
        return;
      case NewtonEnd::Stopped:
        report.status = SolveStatus::Stopped;
        report.stop_reason = "stopped by the user";
        return;
      case NewtonEnd::NotStraight:
      case NewtonEnd::NoStep:
        report.status = SolveStatus::Planar;
        report.stop_reason = "no step gained anything any more at this accuracy";
        return;
      case NewtonEnd::NotFinite:
        report.status = SolveStatus::Failed;
        report.stop_reason = "a function could not be evaluated (not a finite number)";
        return;
      case NewtonEnd::OutOfMemory:
        report.status = SolveStatus::Failed;
        report.stop_reason = "out of memory";
        return;
    }
  }

  // Multipliers of the last solve, for the next one of the same rows.
  void remember(const Problem& problem, const SolveReport& report) {
    if (!report.multipliers.allFinite()) return;  // would be every later solve's start
    multipliers_ = report.multipliers * share(problem);
    remembered_rows_ = problem.jacobian_pattern().columns;
  }
  void recall(const Problem& problem, Vector& multipliers) const {
    if (multipliers_.size() == problem.rows() && remembered_rows_ == problem.jacobian_pattern().columns) {
      multipliers = without_unit_normals(problem, multipliers_);
    }
  }
  // Newton steps account for those rows themselves.
  static Vector without_unit_normals(const Problem& problem, Vector multipliers) {
    const auto [first, last] = problem.unit_normal_rows();
    multipliers.segment(first, last - first).setZero();
    return multipliers;
  }

  TangentCache cache_;
  Vector multipliers_;    // f relative to the largest weight
  double damping_ = 0.0;  // that the last solve ended with; 0: none to begin with
  std::vector<int> remembered_rows_;
};

}  // namespace

std::unique_ptr<Solver> make_tangent_solver() {
  return std::make_unique<TangentSolver>();
}

}  // namespace planewright
