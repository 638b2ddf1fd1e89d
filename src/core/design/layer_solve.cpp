#include "core/design/layer_solve.h"

#include "core/design/design.h"
#include "core/solve/ipopt_solver.h"

namespace planewright {

Result<SolveReport> solve_layer(const LayerProblem& layer, const State& start, const SolveOptions& options,
                                SolveObserver* observer, std::stop_token stop) {
  FrozenGeometry frozen;
  frozen.at = &start;
  frozen.reference = layer.reference;
  frozen.neighbour = layer.neighbour;
  const auto problem = build_problem(layer.complex, layer.settings, layer.selections, frozen);
  if (!problem) return tl::unexpected(problem.error());
  return make_ipopt_solver()->solve(**problem, start, options, observer, std::move(stop));
}

}  // namespace planewright
