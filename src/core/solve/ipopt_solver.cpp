#include "core/solve/ipopt_solver.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <new>
#include <optional>

// Some of Ipopt 3.11's headers ask which C headers exist; every C++20 compiler has them.
#ifndef HAVE_CSTDDEF
#define HAVE_CSTDDEF 1
#endif
#include <IpIpoptApplication.hpp>
#include <IpIpoptCalculatedQuantities.hpp>
#include <IpIpoptData.hpp>
#include <IpOrigIpoptNLP.hpp>
#include <IpTNLP.hpp>
#include <IpTNLPAdapter.hpp>

#include "core/solve/curvature_schedule.h"
#include "core/solve/demand_start.h"
#include "core/solve/finish_solve.h"
#include "core/solve/hold.h"
#include "core/solve/mumps_gate.h"
#include "core/solve/projection.h"

namespace planewright {
namespace {

using Ipopt::Index;
using Ipopt::Number;
using Clock = std::chrono::steady_clock;

// An iterate worth keeping: z, the multipliers of the rows, and how good it is.
struct Kept {
  Vector z, multipliers;
  double objective = std::numeric_limits<double>::infinity();
  double infeasibility = std::numeric_limits<double>::infinity();
};

// Feasible enough for the projection to be a small correction; among such iterates the lower energy is
// better.
constexpr double kNearlyFeasible = 1e-4;
// Share of the tolerance at which steps end, so that the projection afterwards has room.
constexpr double kStopShare = 0.8;
// Share of the tolerance below which the barrier of inequalities has to be: the energy is then within some
// 1e-4 of its own. Much less leaves no room between active rows and where the projection aims.
constexpr double kBarrierShare = 0.15;
// Share of the tolerance below which further exact steps would only shuffle the last digits.
constexpr double kFarBelow = 1e-5;
// Root mean square move of the first step, edges, beyond which another start is tried; real designs stay
// below 0.3.
constexpr double kFirstStepTooLong = 0.5;
// What the final projection easily takes to rounding; asking Ipopt for more gains nothing.
constexpr double kFeasible = 1e-7;

bool better(const Kept& a, const Kept& b) {
  const bool a_near = a.infeasibility <= kNearlyFeasible, b_near = b.infeasibility <= kNearlyFeasible;
  if (a_near != b_near) return a_near;
  return a_near ? a.objective <= b.objective : a.infeasibility < b.infeasibility;
}

// Ipopt's view of a Problem.
class Adapter final : public Ipopt::TNLP {
 public:
  Adapter(const Problem& problem, Vector start, const SolveOptions& options, const IpoptOverrides& overrides,
          SolveObserver* observer, std::stop_token stop)
      : problem_(problem),
        waived_(problem.waived_at(start.data())),
        hold_(problem, start),
        weight_(problem.largest_weight()),
        start_(std::move(start)),
        options_(options),
        own_termination_(overrides.own_termination),
        stop_when_(overrides.stop_when),
        observer_(observer),
        stop_(std::move(stop)),
        begun_(Clock::now()),
        no_multipliers_(Vector::Zero(problem.rows())),
        gauss_newton_iterations_(overrides.gauss_newton_iterations),
        curvature_(overrides.gauss_newton_iterations) {
    count_equations();
  }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_slots, Index& hessian_slots,
                    IndexStyleEnum& style) override {
    n = problem_.variables();
    m = problem_.rows();
    jacobian_slots = problem_.jacobian_pattern().size();
    hessian_slots = problem_.hessian_pattern().size();
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* low, Number* high, Index m, Number* row_low,
                       Number* row_high) override {
    for (Index v = 0; v < n; ++v) {
      const bool free = problem_.layout().is_free(v);
      low[v] = free ? -kUnbounded : start_[v];
      high[v] = free ? kUnbounded : start_[v];
    }
    for (Index r = 0; r < m; ++r) {
      row_low[r] = bounds(r).low;
      row_high[r] = bounds(r).high;
    }
    return true;
  }

  bool get_starting_point(Index n, bool init_x, Number* x, bool init_bounds, Number* lower, Number* upper,
                          Index m, bool init_rows, Number* multipliers) override {
    if (init_x) std::copy(start_.data(), start_.data() + n, x);
    if (init_bounds) {  // no unknown has bounds of its own; fixed ones are taken out
      std::fill(lower, lower + n, 0.0);
      std::fill(upper, upper + n, 0.0);
    }
    if (init_rows)
      for (Index r = 0; r < m; ++r) multipliers[r] = best.multipliers[r] / weight_;
    return true;
  }

  bool eval_f(Index, const Number* z, bool, Number& value) override {
    value = problem_.objective(z) / weight_;
    value += hold_.value(z);
    return std::isfinite(value);
  }
  bool eval_grad_f(Index n, const Number* z, bool, Number* out) override {
    problem_.gradient(z, out);
    for (Index v = 0; v < n; ++v) out[v] /= weight_;
    if (hold_.active()) Eigen::Map<Vector>(out, 3 * problem_.layout().points) += hold_.gradient(z);
    return all_finite(out, n);
  }
  bool eval_g(Index, const Number* z, bool, Index m, Number* out) override {
    problem_.constraint_values(z, out);
    return all_finite(out, m);
  }
  bool eval_jac_g(Index, const Number* z, bool, Index, Index slots, Index* rows, Index* columns,
                  Number* values) override {
    if (!values) return copy_pattern(problem_.jacobian_pattern(), rows, columns);
    problem_.jacobian_values(z, values);
    return all_finite(values, slots);
  }
  bool eval_h(Index, const Number* z, bool, Number factor, Index, const Number* multipliers, bool,
              Index slots, Index* rows, Index* columns, Number* values) override {
    if (!values) return copy_pattern(problem_.hessian_pattern(), rows, columns);
    problem_.hessian_values(z, factor / weight_, curvature_.exact() ? multipliers : no_multipliers_.data(),
                            values);
    if (!curvature_.exact()) damp_planes(values);
    if (hold_.active())
      for (Index v = 0; v < 3 * problem_.layout().points; ++v)
        values[problem_.hessian_diagonal()[static_cast<size_t>(v)]] += factor * hold_.curvature();
    return all_finite(values, slots);
  }

  bool intermediate_callback(Ipopt::AlgorithmMode mode, Index number, Number objective, Number infeasibility,
                             Number first_order, Number barrier, Number step, Number, Number, Number, Index,
                             const Ipopt::IpoptData* data,
                             Ipopt::IpoptCalculatedQuantities* quantities) override {
    Iteration iteration;
    iteration.solver = "ipopt";
    iteration.number = iterations_before_ + number;
    iteration.objective = objective * weight_;
    iteration.infeasibility = infeasibility;
    iteration.first_order = first_order;
    iteration.step = step;
    iteration.seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    iteration.restoration = mode == Ipopt::RestorationPhaseMode;
    iterations = iteration.number;
    curvature_.after(number, objective, infeasibility, first_order);

    Kept now;
    const bool known = recover(data, quantities, now);
    if (known) {
      now.objective = objective;
      now.infeasibility = infeasibility;
      if (!converged && better(now, best)) best = now;
    }
    const bool told_before =
        number == 0 && iterations_before_ > 0;  // a restart begins where the last one ended
    if (observer_ && !told_before) {
      if (known) {
        iteration.energies = problem_.energy_shares(now.z.data());
        const State state = problem_.to_state({now.z.data(), static_cast<size_t>(now.z.size())});
        observer_->on_iteration(iteration, &state);
      } else {
        observer_->on_iteration(iteration, nullptr);
      }
    }
    if (known && stop_when_ && stop_when_(now.z, now.multipliers, infeasibility)) {
      best = now;
      converged = true;
      return false;
    }
    if (own_termination_ && known && is_converged(now, infeasibility, first_order, barrier)) return false;
    // Where the design's edges run along asymptotic directions (a hypar along its rulings), the incidences
    // linearised at the start are nearly contradictory, and the first step throws the points far away.
    if (number == 1 && known && may_start_elsewhere && moved(now.z) > kFirstStepTooLong) {
      start_elsewhere = true;
      return false;
    }
    return !stop_.stop_requested();
  }

  void finalize_solution(Ipopt::SolverReturn end, Index n, const Number* z, const Number*, const Number*,
                         Index m, const Number* c, const Number* multipliers, Number objective,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    if (converged || start_elsewhere) return;
    // Covers what the callback did not see: a problem solved at its start, a last iterate after restoration.
    Kept last;
    last.z = Eigen::Map<const Vector>(z, n);
    last.multipliers = weight_ * Eigen::Map<const Vector>(multipliers, m);
    last.objective = objective;
    last.infeasibility = 0.0;
    for (Index r = 0; r < m; ++r)
      last.infeasibility = std::max({last.infeasibility, bounds(r).low - c[r], c[r] - bounds(r).high});
    if (last.z.allFinite() && (end == Ipopt::SUCCESS || better(last, best))) best = last;
  }

  // Ready for another solve from elsewhere, as if nothing had been solved yet.
  void restart_from(const Vector& z) {
    best = Kept{};
    best.z = z;
    best.multipliers = Vector::Zero(problem_.rows());
    may_start_elsewhere = start_elsewhere = false;
    restart();
  }

  // Ready for another solve from the best state so far; iterations go on counting.
  void restart() {
    start_ = best.z;
    waived_ = problem_.waived_at(start_.data());
    iterations_before_ = iterations;
    curvature_ = CurvatureSchedule(gauss_newton_iterations_);
  }

  Kept best;
  int iterations = 0;
  bool converged = false;  // by our own test, or the caller's
  bool may_start_elsewhere = true;
  bool start_elsewhere = false;  // the first step was hopeless: another start is wanted

  // Iterations that were told before this solve began.
  void count_from(int iterations_before) { iterations = iterations_before_ = iterations_before; }

 private:
  // Ipopt cannot change rows during a solve: of alternatives, those that need not hold at the start have no
  // bounds until the next restart.
  Bounds bounds(int row) const {
    if (waived_[static_cast<size_t>(row)]) return {-kUnbounded, kUnbounded};
    Bounds bounds = problem_.bounds(row);
    if (loosen_equations_ && bounds.low == bounds.high && row >= first_demand_row_) {
      bounds.low -= kLooseEquation;
      bounds.high += kLooseEquation;
    }
    return bounds;
  }

  // Ipopt refuses more equations than unknowns, also where some follow from others (beams of a closed dual).
  // Demanded ones then get a hair of room; the projection afterwards meets them exactly.
  static constexpr double kLooseEquation = 1e-10;
  void count_equations() {
    int equations = 0, unknowns = 0;
    for (int row = 0; row < problem_.rows(); ++row)
      equations += problem_.bounds(row).low == problem_.bounds(row).high;
    for (int v = 0; v < problem_.variables(); ++v) unknowns += problem_.layout().is_free(v);
    first_demand_row_ = problem_.unit_normal_rows().second;
    loosen_equations_ = problem_.has_demands() && equations > unknowns;
  }
  static bool all_finite(const Number* values, Index count) {
    return std::all_of(values, values + count, [](Number v) { return std::isfinite(v); });
  }
  static bool copy_pattern(const SparsePattern& pattern, Index* rows, Index* columns) {
    std::copy(pattern.rows.begin(), pattern.rows.end(), rows);
    std::copy(pattern.columns.begin(), pattern.columns.end(), columns);
    return true;
  }

  // Gauss-Newton steps leave the planes' own unknowns without curvature; a little keeps their turns moderate
  // (measured with otherwise equal options: the train station converged with it, and not in 500 steps
  // without).
  void damp_planes(Number* hessian) const {
    const auto& diagonal = problem_.hessian_diagonal();
    const double damping = curvature_.plane_damping();
    for (int v = problem_.layout().n(0); v < problem_.variables(); ++v) hessian[diagonal[v]] += damping;
  }

  // The current iterate in our order. Ipopt 3.14 has get_curr_iterate(); the way round over the adapter works
  // in 3.11 too. In the restoration phase the NLP is another one, the cast gives null, and nothing is known.
  bool recover(const Ipopt::IpoptData* data, Ipopt::IpoptCalculatedQuantities* quantities, Kept& kept) const {
    if (!data || !quantities || !Ipopt::IsValid(data->curr())) return false;
    auto* original = dynamic_cast<Ipopt::OrigIpoptNLP*>(Ipopt::GetRawPtr(quantities->GetIpoptNLP()));
    if (!original) return false;
    auto* adapter = dynamic_cast<Ipopt::TNLPAdapter*>(Ipopt::GetRawPtr(original->nlp()));
    if (!adapter) return false;
    kept.z.resize(problem_.variables());
    kept.multipliers.resize(problem_.rows());
    adapter->ResortX(*data->curr()->x(), kept.z.data());
    adapter->ResortG(*data->curr()->y_c(), *data->curr()->y_d(), kept.multipliers.data());
    kept.multipliers *= weight_;
    return kept.z.allFinite() && kept.multipliers.allFinite();
  }

  const Problem& problem_;
  std::vector<char> waived_;  // #rows
  Hold hold_;
  // Ipopt sees the weights relative to the largest one: its tolerances, and the damping, then mean the same
  // whatever unit the weights are thought in.
  double weight_;
  Vector start_;
  const SolveOptions& options_;
  bool own_termination_;
  const std::function<bool(const Vector&, const Vector&, double)>& stop_when_;
  SolveObserver* observer_;
  std::stop_token stop_;
  Clock::time_point begun_;
  // Our own test. Exact steps converge quadratically, so once below the tolerance they go on while each still
  // gains an order of magnitude: a step or two more, and the result no longer depends on where exactly the
  // test was met (the same design, moved or turned, gives the same points to 1e-6 edges).
  // barrier: what is left of every inequality's slack times its multiplier.
  bool is_converged(const Kept& now, double infeasibility, double first_order, double barrier) {
    const bool met = infeasibility <= kFeasible && first_order <= kStopShare * options_.tolerance &&
                     (!problem_.has_demands() || barrier <= kBarrierShare * options_.tolerance);
    const bool gains = met && first_order <= 0.1 * met_at_;
    if (!converged && !met) return false;
    if (gains || !converged) {
      best = now;
      met_at_ = first_order;
      converged = true;
      return !curvature_.exact() || first_order <= kFarBelow * options_.tolerance;
    }
    return true;  // keeps the step before
  }

  // Root mean square move of the points from the start, edges.
  double moved(const Vector& z) const {
    const Eigen::Index size = 3 * problem_.layout().points;
    return (z.head(size) - start_.head(size)).norm() /
           std::sqrt(std::max<double>(problem_.layout().points, 1.0));
  }

  double met_at_ =
      std::numeric_limits<double>::infinity();  // first-order residual when the test was last met
  Vector no_multipliers_;
  int gauss_newton_iterations_;
  int iterations_before_ = 0;
  int first_demand_row_ = 0;
  bool loosen_equations_ = false;
  CurvatureSchedule curvature_;
};

struct Outcome {
  SolveStatus status;
  std::string reason;
};

// Every way Ipopt can end, in words. "Converged" by Ipopt's own test counts only when ours agrees
// (finish_solve).
Outcome outcome_of(Ipopt::ApplicationReturnStatus status, const Adapter& adapter, bool stopped,
                   const SolveOptions& options) {
  using S = SolveStatus;
  if (adapter.converged) return {S::Converged, "feasible, and the energy is stationary to the tolerance"};
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return {S::Converged, "feasible, and the energy is stationary to the tolerance"};
    case Ipopt::Solved_To_Acceptable_Level:
      return {S::Planar, "no further progress at an accuracy short of the tolerance"};
    case Ipopt::Feasible_Point_Found:
      return {S::Converged, "a point on all planes was found; there was nothing to choose"};
    case Ipopt::Infeasible_Problem_Detected:
      return {S::Infeasible, "the demands contradict each other here: no step lessens their violation"};
    case Ipopt::User_Requested_Stop:
      return stopped ? Outcome{S::Stopped, "stopped by the user"} : Outcome{S::Planar, "stopped"};
    case Ipopt::Maximum_Iterations_Exceeded:
      return {S::Planar,
              "the limit of " + std::to_string(options.max_iterations) + " iterations was reached"};
    case Ipopt::Maximum_CpuTime_Exceeded:
      return {S::Planar, "the time limit was reached"};
    case Ipopt::Search_Direction_Becomes_Too_Small:
    case Ipopt::Error_In_Step_Computation:
      return {S::Planar, "no step gained anything any more at this accuracy"};
    case Ipopt::Restoration_Failed:
      return {S::Planar, "the solver found no way back to a feasible state"};
    case Ipopt::Diverging_Iterates:
      return {S::Failed, "the points ran away: the problem is unbounded"};
    case Ipopt::Not_Enough_Degrees_Of_Freedom:
      return {S::Failed, "there are more demands than unknowns; free the normals or the offsets"};
    case Ipopt::Invalid_Number_Detected:
      return {S::Failed, "a function could not be evaluated (not a finite number)"};
    case Ipopt::Insufficient_Memory:
      return {S::Failed, "out of memory"};
    default:
      return {S::Failed, "Ipopt ended with its status " + std::to_string(static_cast<int>(status))};
  }
}

class IpoptSolver final : public Solver {
 public:
  explicit IpoptSolver(IpoptOverrides overrides) : overrides_(std::move(overrides)) {}

  SolveReport solve(const Problem& problem, const State& start, const SolveOptions& options,
                    SolveObserver* observer, std::stop_token stop) override {
    try {
      return try_to_solve(problem, start, options, observer, stop);
    } catch (const std::bad_alloc&) {  // before Ipopt began, or in the measurements after it
      SolveReport report;
      report.solver = "ipopt";
      report.stop_reason = "out of memory; the state it began with is kept";
      report.first_order_residual = std::numeric_limits<double>::quiet_NaN();  // nothing was measured
      report.incidence_residual = std::numeric_limits<double>::quiet_NaN();
      report.state = start;
      return report;
    }
  }

 private:
  SolveReport try_to_solve(const Problem& problem, const State& start, const SolveOptions& options,
                           SolveObserver* observer, const std::stop_token& stop) {
    const auto begun = Clock::now();
    const auto gate = enter_mumps_gate();
    Vector z = problem.from_state(start);
    std::optional<DemandStart> demands;
    const bool warm = options.multipliers.size() == problem.rows() && overrides_.own_termination;
    if (problem.has_demands() && overrides_.own_termination && !warm) {
      demands =
          find_demand_start(problem, z, {options.max_iterations, options.near_solution}, observer, stop);
      // Not met, or nobody waits: Ipopt would only spend longer on the same.
      if (!demands->met || stop.stop_requested() || options.draft) {
        SolveReport report;
        report.solver = "ipopt";
        if (stop.stop_requested()) {
          report.status = SolveStatus::Stopped;
          report.stop_reason = "stopped by the user";
        } else if (demands->met) {
          report.status = SolveStatus::Planar;
          report.stop_reason = kDraftReason;
        } else if (demands->out_of_memory) {
          report.status = SolveStatus::Failed;
          report.stop_reason = "out of memory";
        } else {
          report.status = SolveStatus::Infeasible;
          report.stop_reason = "the demands could not be met together from here";
        }
        report.iterations = demands->steps;
        finish_solve(problem, demands->z, Vector::Zero(problem.rows()), options, report);
        report.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
        return report;
      }
      z = demands->z;
    }
    IpoptOverrides overrides = overrides_;
    if (warm) overrides.gauss_newton_iterations = 0;
    Ipopt::SmartPtr<Adapter> adapter = new Adapter(problem, z, options, overrides, observer, stop);
    adapter->best.z = z;
    adapter->best.multipliers = warm ? options.multipliers : Vector::Zero(problem.rows()).eval();
    adapter->may_start_elsewhere = overrides_.own_termination && !demands && !warm;
    if (demands) adapter->count_from(demands->steps);

    Outcome outcome;
    try {
      Ipopt::ApplicationReturnStatus status;
      for (int restarts = 0;;) {
        // False: no console output.
        Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
        set_options(*application, options, options.max_iterations - adapter->iterations, demands.has_value());
        if (warm) start_warm(*application, options);
        application->Initialize("");  // an empty name: no option file of the working directory is read
        status = application->OptimizeTNLP(Ipopt::GetRawPtr(adapter));
        if (adapter->start_elsewhere) {
          // Damped, the projection finds planar panels close by; from there the energies have an easier way.
          State projected = start;
          project_onto_incidences(problem.complex(), projected, problem.layout().freedom, kProjectionTarget,
                                  kProjectionSteps, stop);
          adapter->restart_from(problem.from_state(projected));
          continue;
        }
        if (!is_stuck(status) || restarts++ == kRestarts || !overrides_.own_termination ||
            stop.stop_requested())
          break;
        adapter->restart();
      }
      outcome = outcome_of(status, *adapter, stop.stop_requested(), options);
    } catch (const std::bad_alloc&) {
      outcome = {SolveStatus::Failed, "out of memory"};
    }

    const auto finished = [&](const Vector& at, const Vector& multipliers, const Outcome& end) {
      SolveReport report;
      report.solver = "ipopt";
      report.status = end.status;
      report.stop_reason = end.reason;
      report.iterations = adapter->iterations;
      finish_solve(problem, at, multipliers, options, report);
      return report;
    };
    SolveReport report = finished(adapter->best.z, adapter->best.multipliers, outcome);
    if (!warm && (report.status == SolveStatus::Planar || report.status == SolveStatus::NotPlanar ||
                  report.status == SolveStatus::Infeasible)) {
      // Of a solve that ended early all iterates may be so far from planar that the projection spoils them;
      // what it makes of the start is the least that a solve may give.
      SolveReport from_start = finished(
          z, Vector::Zero(problem.rows()),
          {SolveStatus::Planar, outcome.reason + "; the state it began with is kept, which was better"});
      if (from_start.status == SolveStatus::Planar &&
          (report.status != SolveStatus::Planar ||
           objective(from_start) < (1.0 - kClearlyBetter) * objective(report)))
        report = std::move(from_start);
    }
    report.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    return report;
  }

  static constexpr int kRestarts = 2;
  static constexpr double kClearlyBetter = 1e-3;  // of the energy

  static double objective(const SolveReport& report) {
    double sum = 0.0;
    for (const SolveReport::Energy& energy : report.energies) sum += energy.value;
    return sum;
  }

  // Ends from which a fresh start at the best state, with Gauss-Newton steps again, often goes on.
  static bool is_stuck(Ipopt::ApplicationReturnStatus status) {
    return status == Ipopt::Restoration_Failed || status == Ipopt::Search_Direction_Becomes_Too_Small ||
           status == Ipopt::Error_In_Step_Computation || status == Ipopt::Infeasible_Problem_Detected;
  }

  // The start is a solution already, multipliers and all: keep it, and every slack as small as it is.
  static void start_warm(Ipopt::IpoptApplication& application, const SolveOptions& options) {
    auto& list = *application.Options();
    list.SetStringValue("warm_start_init_point", "yes");
    for (const char* push : {"warm_start_bound_push", "warm_start_bound_frac", "warm_start_slack_bound_push",
                             "warm_start_slack_bound_frac", "warm_start_mult_bound_push"})
      list.SetNumericValue(push, kWarmPush);
    list.SetNumericValue("mu_init", kWarmBarrier * options.tolerance);
  }
  static constexpr double kWarmPush = 1e-9, kWarmBarrier = 0.1;

  // near_start: the start is close to a solution, bounds included.
  void set_options(Ipopt::IpoptApplication& application, const SolveOptions& options, int iterations,
                   bool near_start) const {
    auto& list = *application.Options();
    list.SetIntegerValue("print_level", 0);
    list.SetStringValue("sb", "yes");  // no banner
    list.SetStringValue("linear_solver", "mumps");
    // Our units are the scaling; Ipopt's depends on the directions of the axes.
    list.SetStringValue("nlp_scaling_method", "none");
    // MUMPS' matching step is most of its analysis time and gains nothing on these systems (measured).
    list.SetIntegerValue("mumps_permuting_scaling", 0);
    list.SetIntegerValue("mumps_scaling", 0);
    // Ipopt's 1000 % of extra workspace is zeroed at every factorisation; MUMPS asks again where 30 % is too
    // little.
    list.SetIntegerValue("mumps_mem_percent", 30);
    list.SetIntegerValue("mumps_pivot_order",
                         3);  // Scotch: the fastest here; deterministic with one thread (mumps_gate)
    list.SetNumericValue("constr_mult_init_max",
                         0.0);  // multipliers do not enter the first steps: save their solve
    list.SetIntegerValue("max_iter", std::max(iterations, 0));
    if (near_start) {
      // Ipopt's defaults push a start away from its bounds and begin with a barrier that undoes what the
      // start has gained (measured on four irregular cases: 42 to 81 iterations with 1e-2, one of them not
      // converged; 61 to 71, all converged, with 1e-3; 1e-4 gets stuck).
      list.SetNumericValue("mu_init", 1e-3);
      for (const char* push : {"bound_push", "bound_frac", "slack_bound_push", "slack_bound_frac"})
        list.SetNumericValue(push, 1e-6);
    }
    // The callback decides; Ipopt's own test, relative to the multipliers, stays behind it.
    list.SetNumericValue("tol", overrides_.own_termination ? 1e-3 * options.tolerance : options.tolerance);
    list.SetNumericValue("constr_viol_tol", kFeasible);
    list.SetNumericValue("dual_inf_tol", options.tolerance);
    list.SetIntegerValue("acceptable_iter", 0);
    for (const auto& [name, value] : overrides_.strings) list.SetStringValue(name, value);
    for (const auto& [name, value] : overrides_.numbers) list.SetNumericValue(name, value);
    for (const auto& [name, value] : overrides_.integers) list.SetIntegerValue(name, value);
  }

  IpoptOverrides overrides_;
};

}  // namespace

std::unique_ptr<Solver> make_ipopt_solver(IpoptOverrides overrides) {
  return std::make_unique<IpoptSolver>(std::move(overrides));
}

}  // namespace planewright
