#include "contenders.h"

#include <algorithm>
#include <functional>
#include <string_view>

#include "baselines.h"
#include "core/design/design.h"
#include "core/solve/solver_choice.h"
#include "value_of.h"

namespace planewright::bench {
namespace {

// Counts what Ipopt alone tells.
class IpoptCounter final : public SolveObserver {
 public:
  void on_iteration(const Iteration& iteration, const State*) override {
    told_ += iteration.solver == std::string_view("ipopt");
  }
  // Frames for a window are no part of what is compared.
  bool wants_states() const override { return false; }
  int steps() const { return std::max(told_ - 1, 0); }  // it tells its start as well

 private:
  int told_ = 0;
};

// Ipopt's own tests out of the way: CommonStop decides. Without inequalities `tol` does nothing else.
IpoptOverrides until_told(IpoptOverrides frozen) {
  frozen.numbers["tol"] = 1e-10;
  return frozen;
}

}  // namespace

const std::vector<Contender>& all_contenders() {
  static const std::vector<Contender> all{Contender::Default, Contender::Tuned, Contender::Ipopt,
                                          Contender::Tangent, Contender::Auto};
  return all;
}

const char* name(Contender contender) {
  switch (contender) {
    case Contender::Default:
      return "default";
    case Contender::Tuned:
      return "tuned";
    case Contender::Ipopt:
      return "ipopt";
    case Contender::Tangent:
      return "tangent";
    case Contender::Auto:
      return "auto";
  }
  return "";
}

const char* label(Contender contender) {
  switch (contender) {
    case Contender::Default:
      return "Ipopt default";
    case Contender::Tuned:
      return "Ipopt tuned";
    case Contender::Ipopt:
      return "Ipopt shipped";
    case Contender::Tangent:
    case Contender::Auto:
      return name(contender);
  }
  return "";
}

Contender find_contender(const std::string& wanted) {
  std::string known;
  for (const Contender contender : all_contenders()) {
    if (wanted == name(contender)) return contender;
    known += (known.empty() ? "" : ", ") + std::string(name(contender));
  }
  throw std::runtime_error("--only " + wanted + ": there is no such solver. Known: " + known);
}

Measurement solve(Contender contender, std::shared_ptr<const TangentComplex> complex, const StopTest& test) {
  LayerSettings settings;
  settings.tolerance = test.tolerance;
  SolveOptions options = solve_options(settings);
  const auto judge = value_of(build_problem(complex, settings));
  const auto shown = contender == Contender::Default ? raw_coordinates(*complex) : complex;
  const bool baseline = contender == Contender::Default || contender == Contender::Tuned;
  // The baselines' verdict is CommonStop's; their reports' own would be in other units.
  if (baseline) options.tolerance = 1e3;

  Measurement row;
  IpoptCounter counter;
  const double wall = wall_seconds(), cpu = cpu_seconds();
  const auto problem = value_of(build_problem(shown, settings));
  const CommonStop stop(judge, problem, test);
  const auto solver = [&]() -> std::unique_ptr<Solver> {
    if (!baseline) return make_solver(value_of(find_solver(name(contender))));
    IpoptOverrides overrides =
        until_told(contender == Contender::Default ? default_options() : prototype_options());
    overrides.stop_when = [&](const Vector& z, const Vector& y, double) { return stop.met(z, y); };
    return make_ipopt_solver(std::move(overrides));
  }();
  const SolveReport report = solver->solve(*problem, start_state(*shown, settings), options, &counter, {});
  row.cpu = cpu_seconds() - cpu;
  row.wall = wall_seconds() - wall;
  row.ipopt_iterations = counter.steps();
  measure_report(row, report, *shown, complex->mean_edge);
  row.residual = stop.residual(report.state, report.multipliers);
  if (baseline && row.status == SolveStatus::Converged &&
      !(row.residual <= kAfterProjection * test.tolerance))
    row.status = SolveStatus::Planar;
  return row;
}

MeasuredRow measure(Contender contender, const Model& model, const std::filesystem::path& meshes,
                    const StopTest& test, int repeats, const ChildLimits& limits) {
  const auto work = [&] {
    LayerSettings settings;
    return solve(contender, complex_of(model, meshes, settings), test);
  };
  return best_of(repeats, work, limits);
}

}  // namespace planewright::bench
