#include "core/solve/auto_solver.h"

#include "core/solve/ipopt_solver.h"
#include "core/solve/tangent_solver.h"

namespace planewright {
namespace {

// Tells Ipopt's iterations as numbers that count on after the tangent solver's.
class NumbersOnly final : public SolveObserver {
 public:
  NumbersOnly(SolveObserver* next, int before, double seconds_before)
      : next_(next), before_(before), seconds_before_(seconds_before) {}
  void on_iteration(const Iteration& iteration, const State*) override {
    if (!next_) return;
    Iteration counted = iteration;
    counted.number += before_;
    counted.seconds += seconds_before_;
    counted.planar = false;
    next_->on_iteration(counted, nullptr);
  }
  bool wants_states() const override { return false; }

 private:
  SolveObserver* next_;
  int before_;
  double seconds_before_;
};

constexpr const char* kUnconfirmed = "; stopped before Ipopt had confirmed it";

double energy_of(const SolveReport& report) {
  double sum = 0.0;
  for (const auto& energy : report.energies) sum += energy.value;
  return sum;
}

class AutoSolver final : public Solver {
 public:
  SolveReport solve(const Problem& problem, const State& start, const SolveOptions& options,
                    SolveObserver* observer, std::stop_token stop) override {
    SolveReport begun = tangent_->solve(problem, start, options, observer, stop);
    if (begun.status == SolveStatus::Stopped) return begun;
    const bool usable = begun.status == SolveStatus::Converged || begun.status == SolveStatus::Planar;
    // Demands that the tangent solver could not meet, Ipopt, which begins in the same way, cannot either.
    if (begun.status == SolveStatus::Infeasible || (usable && options.draft && problem.has_demands()))
      return begun;
    if (usable && stop.stop_requested()) {
      begun.stop_reason += kUnconfirmed;
      return begun;
    }

    SolveOptions confirming = options;
    confirming.max_iterations -= begun.iterations;
    if (confirming.max_iterations <= 0) return begun;
    if (usable) confirming.multipliers = begun.multipliers;
    NumbersOnly numbers(observer, begun.iterations + 1, begun.seconds);
    SolveReport confirmed = ipopt_->solve(problem, usable ? begun.state : start, confirming, &numbers, stop);
    confirmed.iterations += begun.iterations;
    confirmed.seconds += begun.seconds;
    if (!usable) return confirmed;
    if (keeps(begun, confirmed)) {
      begun.iterations = confirmed.iterations;
      begun.seconds = confirmed.seconds;
      begun.stop_reason += confirmed.status == SolveStatus::Stopped
                               ? kUnconfirmed
                               : "; Ipopt found nothing better from there (" + confirmed.stop_reason + ")";
      return begun;
    }
    confirmed.solver = "tangent, ipopt";
    return confirmed;
  }

 private:
  // Whether the tangent solver's state is the better one.
  static bool keeps(const SolveReport& begun, const SolveReport& confirmed) {
    if (confirmed.status == SolveStatus::Converged) return false;
    if (confirmed.status != SolveStatus::Planar || begun.status == SolveStatus::Converged) return true;
    return energy_of(begun) <= energy_of(confirmed);
  }

  std::unique_ptr<Solver> tangent_ = make_tangent_solver(), ipopt_ = make_ipopt_solver();
};

}  // namespace

std::unique_ptr<Solver> make_auto_solver() {
  return std::make_unique<AutoSolver>();
}

}  // namespace planewright
