#include "cli/explicit_solve.h"

#include <chrono>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/complex/explicit_intersection.h"
#include "core/design/design.h"

namespace planewright::cli {
namespace {

std::vector<SolveReport::Energy> energies_at(const State& state,
                                             const std::shared_ptr<const TangentComplex>& complex,
                                             const LayerSettings& settings) {
  std::vector<SolveReport::Energy> energies;
  const auto problem = build_problem(complex, settings);
  if (!problem) return energies;
  const Vector z = (*problem)->from_state(state);
  for (const auto& share : (*problem)->energy_shares(z.data()))
    energies.push_back({share.name, share.weight, share.value});
  return energies;
}

std::string describe(const std::vector<TpiResult::Failed>& failed) {
  std::map<TpiFailure, int> counts;
  for (const auto& point : failed) ++counts[point.why];
  std::string text = std::to_string(failed.size()) + " points could not be computed:";
  for (const auto& [why, count] : counts)
    text.append(" ").append(std::to_string(count)) += std::string(" have ") + name(why) + ",";
  text.back() = ';';
  return text + " the first is point " + std::to_string(failed.front().point);
}

}  // namespace

SolveReport solve_explicitly(const std::shared_ptr<const TangentComplex>& complex,
                             const LayerSettings& settings) {
  const auto begun = std::chrono::steady_clock::now();
  TpiResult result = explicit_intersection(*complex);
  SolveReport report;
  report.solver = "explicit";
  report.state = std::move(result.state);
  report.incidence_residual =
      incidence_residuals(*complex, report.state).cwiseAbs().maxCoeff() / complex->mean_edge;
  report.status = result.failed.empty() ? SolveStatus::Converged : SolveStatus::NotPlanar;
  report.stop_reason =
      result.failed.empty() ? "every point was computed from its planes" : describe(result.failed);
  // Nothing was minimised, so there are no multipliers to measure a slope with; 0 would claim a stationary
  // state.
  report.first_order_residual = std::numeric_limits<double>::quiet_NaN();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  report.energies = energies_at(report.state, complex, settings);
  return report;
}

}  // namespace planewright::cli
