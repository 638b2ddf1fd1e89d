// Advisor: suggestions for the mesh, each with the gain that solving its neighbourhood predicts, ranked.
//
//     gain = B(as it is) - B(edited) - deviation - 1/2 given_up
//
// B: score.h, of the same region (patch_solver.h). Four rings predict the gain of a full re-solve with a rank
// correlation of 0.8 to 0.9, two with 0.7 (measured: planewright-bench advice); it is "about" until then.
// Threads: pure; call it from a thread of its own. Deterministic: equal input, equal list.
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/advise/candidates.h"

namespace planewright {

// What a gain is made of, each part weighted; their sum is the gain. Mean edges squared, larger is better.
struct GainParts {
  double energy = 0.0, crossing = 0.0, short_edges = 0.0, reversed = 0.0, far_points = 0.0;
  double deviation = 0.0, given_up = 0.0;  // never above 0
  double sum() const {
    return energy + crossing + short_edges + reversed + far_points + deviation + given_up;
  }
};

struct Suggestion {
  Candidate candidate;
  Score before, after;
  bool met = true;  // the local solve met every row; if not, the gain is a guess
  GainParts parts(const ScoreWeights& weights = {}) const;
  double gain(const ScoreWeights& weights = {}) const { return parts(weights).sum(); }
};

// Best first; ties by edge, then kind of edit.
void rank(std::vector<Suggestion>& suggestions, const ScoreWeights& weights = {});

struct AdviceOptions {
  int radius = 4;
  ScoreWeights weights = {};
  double least_gain = 0.1;                               // suggestions below are left out
  std::function<void(int rated, int of)> progress = {};  // candidates; may be empty
};

// Ranked. on_rated (may be empty) is told of each suggestion with enough gain as soon as it is rated, in the
// order of the candidates; candidates that cannot be tried are left out. A stop gives what was rated so far.
std::vector<Suggestion> rate(const PatchSolver& solver, const std::vector<Candidate>& candidates,
                             const AdviceOptions& options = {},
                             const std::function<void(const Suggestion&)>& on_rated = {},
                             std::stop_token stop = {});

// What a suggestion does, for a person: "Flip edge 1042".
std::string title(const Suggestion& suggestion);

}  // namespace planewright
