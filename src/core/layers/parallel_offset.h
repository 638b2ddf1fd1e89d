// Parallel offset of finished panels: every plane moved by a thickness along its own normal, corners where
// the moved planes meet. What a panel of that thickness needs on its other side; edges stay parallel.
//
// At a corner of valence 3 the planes meet exactly. At higher valence they need not: the corner takes the
// least-squares point and its residual is reported. At valence 1 and 2 (borders) the corner takes the
// smallest move. A corner that would move more than kMostMove thicknesses (nearly parallel planes) is named
// and blunted: it is put at kMostMove thicknesses along the way, so its panels are no longer exactly planar
// there. Units: model units, relative to the complex's origin. Threads: pure.
#pragma once

#include <vector>

#include "core/complex/state.h"

namespace planewright {

inline constexpr double kMostMove = 3.0;  // thicknesses

struct ParallelOffset {
  State state;  // of the same complex: points x + move, normals as they were, offsets h + thickness
  struct Blunted {
    int point;
    double wanted_move;  // model units
  };
  std::vector<Blunted> blunted;  // ascending by point
  struct Residual {
    int point;
    double residual;  // farthest of its moved planes, model units
  };
  std::vector<Residual>
      residuals;  // points of valence > 3 whose planes do not meet to 1e-9 thicknesses, unblunted ones
};

// thickness: along the normals, negative to the inside; 0 gives the state itself.
ParallelOffset parallel_offset(const TangentComplex& complex, const State& state, double thickness);

}  // namespace planewright
