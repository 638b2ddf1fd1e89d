// Parallel offset of finished panels: every plane moved by a thickness t along its own normal, corners where
// the moved planes meet. What a panel of that thickness needs on its other side; edges stay parallel, so the
// beams between both sides are planar (beams.h).
//
// The move m of a corner solves n_i . m = t for its planes i (singular value decomposition; singular values
// below kSingular of the largest count as 0: planes that differ by less are one plane, or share a line). So a
// corner keeps to rounding whatever distance it had from its planes.
//   valence 3: the planes meet exactly.
//   higher: they need not; the corner takes the least-squares point, and its residual is reported.
//   fewer, or planes that are one or share a line (outline, flat and ruled places): the corner may slide
//     within its planes. It takes the smallest move that keeps its panel edges parallel as well: least norm
//     of the slides subject to (m_a - m_b) . (n_i x (x_a - x_b)) = 0 over the panel edges ab with such a
//     corner. Where that has no solution (an outline that closes on itself may have none) or only one with
//     far slides, edges there are not parallel; beams.h reports how far their beams are from planar.
// A corner that would move more than kMostMove thicknesses (nearly parallel planes) is named and blunted. If
// its slide is what takes it so far, it slides less and only its edges are no longer parallel; else it is put
// at kMostMove thicknesses along the way, and its panels are no longer exactly planar there. Units: model
// units, relative to the complex's origin. Threads: pure.
#pragma once

#include <vector>

#include "core/complex/state.h"

namespace planewright {

inline constexpr double kMostMove = 3.0;   // thicknesses
inline constexpr double kSingular = 1e-8;  // of the largest singular value of a corner's normals

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
  // Ascending by point: corners, not blunted, whose moved planes do not meet to 1e-9 thicknesses.
  std::vector<Residual> residuals;
};

// thickness: along the normals, negative to the inside, finite; 0 gives the state itself.
ParallelOffset parallel_offset(const TangentComplex& complex, const State& state, double thickness);

}  // namespace planewright
