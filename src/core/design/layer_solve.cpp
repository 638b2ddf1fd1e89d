#include "core/design/layer_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/design/design.h"
#include "core/diagnose/crossings.h"
#include "core/problem/foot_points.h"

namespace planewright {
namespace {

// Lets the iterations of all rounds count on, and remembers how far they got.
class CountingOn final : public SolveObserver {
 public:
  explicit CountingOn(SolveObserver* next) : next_(next) {}
  void on_iteration(const Iteration& iteration, const State* state) override {
    Iteration counted = iteration;
    counted.number += before_;
    counted.seconds += seconds_before_;
    last_ = counted.number;
    seconds_ = counted.seconds;
    if (next_) next_->on_iteration(counted, state);
  }
  bool wants_states() const override { return next_ && next_->wants_states(); }
  void next_round() {
    before_ = last_ + 1;
    seconds_before_ = seconds_;
  }

 private:
  SolveObserver* next_;
  int before_ = 0, last_ = -1;
  double seconds_ = 0.0, seconds_before_ = 0.0;
};

bool is_equation_of_every_problem(std::string_view row) {
  return row == "incidence" || row == "unit normal";
}

double objective(const SolveReport& report) {
  double sum = 0.0;
  for (const auto& energy : report.energies) sum += energy.value;
  return sum;
}

class LayerSolver {
 public:
  LayerSolver(Solver& solver, const LayerProblem& layer, const State& start, const SolveOptions& options,
              SolveObserver* observer, std::stop_token stop)
      : solver_(solver),
        layer_(layer),
        settings_(layer.settings),
        start_(start),
        options_(options),
        observer_(observer),
        stop_(std::move(stop)),
        asked_(settings_.demands.waived.begin(), settings_.demands.waived.end()) {
    const auto weight = settings_.weights.find("closeness");
    follows_surface_ = weight != settings_.weights.end() && weight->second > 0.0;
    for (const Demand& demand : settings_.demands.list)
      follows_border_ = follows_border_ || (demand.on && demand.name == "border");
  }

  Result<SolveReport> run() {
    auto report = solve_giving_up();
    if (!report || conflicts_.empty() || !usable(*report) || stop_.stop_requested())
      return concluded(std::move(report));
    // Where the others pulled hardest the rest may be met by itself: keep only what is really violated, if
    // that is enough.
    const std::set<Waiver> needed = still_violated(*report);
    if (needed.size() == conflicts_.size()) return concluded(std::move(report));
    const std::set<Waiver> enough = std::exchange(conflicts_, needed);
    settings_ = layer_.settings;
    for (const Waiver& waiver : conflicts_) settings_.demands.waived.push_back(waiver);
    gives_up_ = false;
    auto leaner = solve_giving_up();
    if (leaner && usable(*leaner)) return concluded(std::move(leaner));
    conflicts_ = enough;
    return concluded(std::move(report));
  }

 private:
  static bool usable(const SolveReport& report) {
    return report.status == SolveStatus::Converged || report.status == SolveStatus::Planar;
  }

  // Rounds from the start until everything but conflicts_ is met, or nothing more can be done.
  Result<SolveReport> solve_giving_up() {
    State at = start_;
    separations_.clear();
    best_ = std::numeric_limits<double>::infinity();
    best_report_.reset();
    draft_ = settings_.no_penetration;
    for (int attempt = 1;; ++attempt) {
      FrozenGeometry frozen{&at, layer_.reference, layer_.neighbour, separations_};
      const auto problem = build_problem(layer_.complex, settings_, layer_.selections, frozen);
      if (!problem) return tl::unexpected(problem.error());
      frozen_at_ = at;
      SolveOptions options = options_;
      options.near_solution = attempt > 1 ? fresh_ : options_.near_solution;
      options.draft = draft_ && (*problem)->has_demands();
      fresh_ = false;
      SolveReport report = solver_.solve(**problem, at, options, &observer_, stop_);
      // Demands that there was no time to meet need not contradict each other.
      const bool out_of_steps = report.iterations >= options.max_iterations;
      observer_.next_round();
      report.iterations = iterations_ += report.iterations;
      report.seconds = seconds_ += report.seconds;
      report.rounds = ++rounds_;
      const bool last = attempt >= kMostRounds || stop_.stop_requested();

      if (report.status == SolveStatus::Infeasible && !last && gives_up_ && !out_of_steps &&
          give_up_violated(**problem, report)) {
        at = start_;  // so that the same solve without the conflicts gives the same result
        separations_.clear();
        draft_ = settings_.no_penetration;
        continue;
      }
      const bool still_moves = usable(report) && ((follows_surface_ && follows_on(at, report)) ||
                                                  (!follows_surface_ && follows_border_ && gains(report)));
      if (still_moves && !last) {
        at = report.state;
        fresh_ = true;
        continue;
      }
      if (still_moves && report.status == SolveStatus::Converged) {
        report.status = SolveStatus::Planar;
        report.stop_reason = "foot points or points of the border still moved after " +
                             std::to_string(kMostRounds) + " rounds";
      }
      if (!settings_.no_penetration || report.status == SolveStatus::Failed) return report;
      std::vector<Crossing> crossings = crossings_of(report.state);
      report.crossings = static_cast<int>(crossings.size());
      report.crossings_waived = static_cast<int>(leave_out_waived(crossings));
      if (!usable(report)) return report;
      if (crossings.empty()) {
        if (!options.draft || stop_.stop_requested()) return report;
        draft_ = false;
        at = report.state;
        fresh_ = true;
        continue;
      }
      if (!last && attempt < kMostRounds - kRoundsForConflicts) {
        separate(crossings);
        at = report.state;
        fresh_ = true;
      } else if (!last && gives_up_) {
        give_up_crossing(crossings);
        at = start_;
        separations_.clear();
        draft_ = true;
      } else {
        report.status = SolveStatus::Infeasible;
        report.stop_reason =
            std::to_string(crossings.size()) + " pairs of a panel and a mesh face still cross";
        return report;
      }
    }
  }

  // Those of the conflicts that are violated at the result.
  std::set<Waiver> still_violated(const SolveReport& report) const {
    std::set<Waiver> violated;
    FrozenGeometry frozen{&frozen_at_, layer_.reference, layer_.neighbour, {}};
    if (const auto whole = build_problem(layer_.complex, layer_.settings, layer_.selections, frozen)) {
      const Vector z = (*whole)->from_state(report.state);
      for (const auto& v : (*whole)->violated_rows(z.data(), options_.planarity_tolerance))
        violated.insert({std::string((*whole)->row_name(v.row)), (*whole)->row_element(v.row)});
    }
    std::set<Waiver> needed;
    for (const Waiver& conflict : conflicts_)
      if (violated.contains(conflict) || conflict.demand == "no-penetration") needed.insert(conflict);
    return needed;
  }

  Result<SolveReport> concluded(Result<SolveReport> report) {
    if (report) conclude(*report);
    return report;
  }

  // Elements at which demands are violated join what is given up. False if there is nothing new to give up.
  bool give_up_violated(const Problem& problem, const SolveReport& report) {
    const Vector z = problem.from_state(report.state);
    auto rows = problem.violated_rows(z.data(), options_.planarity_tolerance);
    std::erase_if(rows, [&](const auto& v) { return is_equation_of_every_problem(problem.row_name(v.row)); });
    // What is violated by far first: a stalled projection drags its surroundings along.
    double worst = 0.0;
    for (const auto& v : rows) worst = std::max(worst, v.amount);
    bool grown = false;
    for (const auto& v : rows) {
      if (v.amount < kShareOfWorst * worst) continue;
      grown = give_up({std::string(problem.row_name(v.row)), problem.row_element(v.row)}) || grown;
    }
    return grown;
  }

  void give_up_crossing(const std::vector<Crossing>& crossings) {
    for (const Crossing& crossing : crossings)
      give_up({"no-penetration", {ElementKind::Panel, crossing.first}});
  }

  bool give_up(const Waiver& waiver) {
    if (asked_.contains(waiver) || !conflicts_.insert(waiver).second) return false;
    settings_.demands.waived.push_back(waiver);
    return true;
  }

  // Largest move of a foot point, mean edges.
  double feet_moved(const State& before, const State& after) const {
    const auto old_feet = foot_points(*layer_.complex, before.x, layer_.reference.get());
    const auto new_feet = foot_points(*layer_.complex, after.x, layer_.reference.get());
    if (!old_feet || !new_feet) return 0.0;  // Problem::create has told why
    return (old_feet->foot - new_feet->foot).rowwise().norm().maxCoeff() / layer_.complex->mean_edge;
  }

  // Whether another round with renewed foot points is worth it. Where two places of the surface are equally
  // near, a foot point may jump to and fro for ever: then the energy with renewed feet no longer falls, and
  // the best round is kept.
  bool follows_on(const State& at, SolveReport& report) {
    const double moved = feet_moved(at, report.state);
    if (moved <= kFootSettled) return false;
    const FrozenGeometry renewed{&report.state, layer_.reference, layer_.neighbour, separations_};
    const auto problem = build_problem(layer_.complex, settings_, layer_.selections, renewed);
    if (!problem) return false;
    const double energy = (*problem)->objective((*problem)->from_state(report.state).data());
    if (energy < (1.0 - kGain) * best_) {
      best_ = energy;
      best_report_ = report;
      return true;
    }
    if (best_report_ && energy > best_) {
      const int iterations = report.iterations, rounds = report.rounds;
      const double seconds = report.seconds;
      report = *best_report_;
      report.iterations = iterations;
      report.rounds = rounds;
      report.seconds = seconds;
    }
    report.stop_reason += "; some foot points go to and fro between places that are equally near";
    return false;
  }

  // A point that has slid to the end of its piece of the border goes on along the next one; worth another
  // round while that lowers the energy.
  bool gains(const SolveReport& report) {
    const double now = objective(report), before = best_;
    best_ = std::min(best_, now);
    return now < before - kGain * std::max(std::abs(before), 1e-9);
  }

  std::vector<Crossing> crossings_of(const State& state) const {
    const TangentComplex& complex = *layer_.complex;
    const Surface panels{state.x, complex.panels}, mesh{complex.input.vertices, complex.input.faces};
    return find_crossings(panels, mesh, settings_.demands.margin * complex.mean_edge);
  }
  // How many there were.
  size_t leave_out_waived(std::vector<Crossing>& crossings) const {
    const std::set<Waiver> waived(settings_.demands.waived.begin(), settings_.demands.waived.end());
    return std::erase_if(crossings, [&](const Crossing& c) {
      return waived.contains({"no-penetration", {ElementKind::Panel, c.first}});
    });
  }

  // A plane between the two triangles of each crossing pair, for the panel's three corners to stay behind.
  // Usually the one that parts them with the least move; where that would push a panel sideways or through,
  // the mesh face's own plane.
  void separate(const std::vector<Crossing>& crossings) {
    const TangentComplex& complex = *layer_.complex;
    const double margin = settings_.demands.margin * complex.mean_edge;
    for (const Crossing& crossing : crossings) {
      const Vector3d out =
          settings_.side_sign() * complex.input.face_normals.row(crossing.second).transpose();
      const Vector3d direction = crossing.apart.dot(out) > kOutwards ? crossing.apart : out;
      double low = -std::numeric_limits<double>::infinity();
      for (int v : crossing.second_corners) low = std::max(low, direction.dot(complex.input.vertices.row(v)));
      // Touching within the margin is no crossing, so half of it on top keeps clear of the test's threshold.
      for (int j : crossing.first_corners)
        separations_.push_back({j, direction, low + 0.5 * margin, crossing.first});
    }
  }

  void conclude(SolveReport& report) {
    if (conflicts_.empty()) return;
    if (report.status == SolveStatus::Stopped) {
      report.stop_reason += " while demands that contradict the others were looked for";
      return;
    }
    if (!usable(report)) {
      report.stop_reason += "; giving up " + std::to_string(conflicts_.size()) + " demands was not enough";
      return;
    }
    report.conflicts.assign(conflicts_.begin(), conflicts_.end());
    report.stop_reason = "some demands cannot be met together with the others; without " +
                         std::to_string(conflicts_.size()) + " of them: " + report.stop_reason;
    report.status = SolveStatus::Infeasible;
    measure_all_demands(report);
  }

  // Violations are those of everything that was asked for, not of what was left.
  void measure_all_demands(SolveReport& report) const {
    FrozenGeometry frozen{&frozen_at_, layer_.reference, layer_.neighbour, {}};
    const auto whole = build_problem(layer_.complex, layer_.settings, layer_.selections, frozen);
    if (!whole) return;  // it was built before from the same settings
    const Vector z = (*whole)->from_state(report.state);
    report.constraints.clear();
    for (const auto& v : (*whole)->violations(z.data(), options_.planarity_tolerance))
      report.constraints.push_back({v.name, v.max_violation, v.violated, v.unit, v.rows, v.worst, v.waived});
  }

  static constexpr int kMostRounds = 16, kRoundsForConflicts = 6;
  static constexpr double kFootSettled = 1e-3;  // mean edges
  static constexpr double kGain = 1e-4;         // of the energy
  static constexpr double kShareOfWorst = 0.05;
  static constexpr double kOutwards = 0.3;  // cosine

  Solver& solver_;
  const LayerProblem& layer_;
  LayerSettings settings_;  // with what had to be given up
  const State& start_;
  const SolveOptions& options_;
  CountingOn observer_;
  std::stop_token stop_;
  std::set<Waiver> asked_, conflicts_;
  std::vector<Separation> separations_;
  State frozen_at_;  // where the last round's geometry was taken
  // What crosses the mesh is found and parted by drafts; the energy is brought down once nothing crosses.
  bool draft_ = false;
  bool fresh_ = false;  // the round begins at the result of the one before
  bool follows_surface_ = false, follows_border_ = false, gives_up_ = true;
  int rounds_ = 0, iterations_ = 0;
  double seconds_ = 0.0;
  double best_ = std::numeric_limits<double>::infinity();  // energy of the best round so far
  std::optional<SolveReport> best_report_;
};

}  // namespace

Result<SolveReport> solve_layer(Solver& solver, const LayerProblem& layer, const State& start,
                                const SolveOptions& options, SolveObserver* observer, std::stop_token stop) {
  return LayerSolver(solver, layer, start, options, observer, std::move(stop)).run();
}

}  // namespace planewright
