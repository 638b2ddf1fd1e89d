// Score: how good the panels of a region are, as one number that edits of the mesh are compared by.
//
//     B = E + 2 #crossing + 1/2 sum (1 - |s| / 0.15)+ + 1/2 sum min(1, (-s)+) + sum min(4, (|x - f| - 1)+)
//
// E: the layer's energy, every weight included; #crossing: panels that cross themselves or have no positive
// area; s: signed length of a panel edge (diagnose/reversed_edges.h); x, f: a point and where it was wanted.
// All but the crossings is continuous, so that nearly bad counts nearly as much. Weights are taste: the parts
// are kept, so that others rank anew without a solve.
//
// Units: mean edges of the whole design (E: squared). Indices of the complex, 0-based. Threads: pure.
#pragma once

#include <vector>

#include "core/complex/state.h"

namespace planewright {

struct Score {
  double energy = 0.0;
  double crossing = 0.0;
  double short_edges = 0.0;
  double reversed = 0.0;
  double far_points = 0.0;
  bool operator==(const Score&) const = default;
};

struct ScoreWeights {
  double energy = 1.0, crossing = 2.0, short_edges = 0.5, reversed = 0.5, far_points = 1.0;
  double given_up = 0.5;  // what a corner of the design is worth (Candidate::given_up)
  bool operator==(const ScoreWeights&) const = default;
};

// B, lower is better.
double total(const Score& score, const ScoreWeights& weights = {});

// What a score looks at; each list ascending.
struct Region {
  std::vector<int> points, panels, panel_edges;
};
Region whole_region(const TangentComplex& complex);

// All parts but the energy, which is a problem's.
Score defects_of(const TangentComplex& complex, const State& state, const Region& region);

}  // namespace planewright
