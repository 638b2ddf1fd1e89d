#include "core/advise/advisor.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace planewright {
GainParts Suggestion::parts(const ScoreWeights& weights) const {
  GainParts parts;
  parts.energy = weights.energy * (before.energy - after.energy);
  parts.crossing = weights.crossing * (before.crossing - after.crossing);
  parts.short_edges = weights.short_edges * (before.short_edges - after.short_edges);
  parts.reversed = weights.reversed * (before.reversed - after.reversed);
  parts.far_points = weights.far_points * (before.far_points - after.far_points);
  parts.deviation = -candidate.deviation;
  parts.given_up = -weights.given_up * candidate.given_up;
  return parts;
}

void rank(std::vector<Suggestion>& suggestions, const ScoreWeights& weights) {
  std::stable_sort(suggestions.begin(), suggestions.end(), [&](const Suggestion& a, const Suggestion& b) {
    return std::tuple(-a.gain(weights), a.candidate.mesh_edge, a.candidate.edit.kind) <
           std::tuple(-b.gain(weights), b.candidate.mesh_edge, b.candidate.edit.kind);
  });
}

std::vector<Suggestion> rate(const PatchSolver& solver, const std::vector<Candidate>& candidates,
                             const AdviceOptions& options,
                             const std::function<void(const Suggestion&)>& on_rated, std::stop_token stop) {
  std::vector<Suggestion> suggestions;
  std::optional<PatchSolver::Ground> ground;
  std::vector<int> centre;  // of the ground
  int rated = 0;
  for (const Candidate& candidate : candidates) {
    if (stop.stop_requested()) break;
    if (options.progress) options.progress(rated++, static_cast<int>(candidates.size()));
    if (!ground || candidate.centre != centre) {
      ground.reset();
      auto prepared = solver.prepare(candidate.centre, options.radius, stop);
      if (!prepared) continue;
      ground = std::move(*prepared);
      centre = candidate.centre;
    }
    const auto trial = solver.attempt(*ground, candidate.edit, stop);
    if (!trial || stop.stop_requested()) continue;
    Suggestion suggestion{candidate, ground->as_it_is.score, trial->score,
                          trial->met && ground->as_it_is.met};
    if (suggestion.gain(options.weights) < options.least_gain) continue;
    if (on_rated) on_rated(suggestion);
    suggestions.push_back(std::move(suggestion));
  }
  rank(suggestions, options.weights);
  return suggestions;
}

std::string title(const Suggestion& suggestion) {
  return describe(suggestion.candidate.edit);
}

}  // namespace planewright
