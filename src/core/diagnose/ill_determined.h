// Ill-determined points: places where the planes through a point are nearly parallel, so that a small change
// of a plane throws the point far away. [Z 4.3] lights them up and advises to flip an edge there.
//
// Measure: sigma, the third singular value of N_j (#planes x 3, unit rows), i.e. the square root of the
// smallest eigenvalue of N_j^T N_j; 1 for three perpendicular planes, 0 for a flat place. Unit-free.
//
// In lengths: a plane i that tilts by d about its anchor v_i (its offset kept) moves away from a point x on
// it by up to d a_i, with the lever arm a_i = |x - v_i - h_i n_i|. The point follows by N_j^+ times that,
// which is at most d a_i / sigma. So it moves by up to (pi / 180) max_i a_i / sigma per degree of tilt of one
// plane; exactly so far where the tilt is the worst one and the others hold the point in the other two
// directions.
#pragma once

#include <vector>

#include "core/complex/state.h"

namespace planewright {

// #X values; 0 for points on fewer than three planes that are meant so (border points) is NOT reported by the
// list below, but stands here.
Vector determinacy(const TangentComplex& complex, const State& state);

// How far a point may move per degree of tilt of one of its planes, as above, mean edges (#X); 0 for points
// on fewer than three planes. sigma counts as 1e-8 at least, below which rounding hides it.
Vector tilt_moves(const TangentComplex& complex, const State& state);

struct IllDetermined {
  int point;
  double singular_value;
};
// Below which measure a point of this design is worth a mark. On a fine or gently curved design neighbouring
// planes are nearly parallel everywhere, as it should be; what stands out is a point far below the others: a
// quarter of the median over points on at least three planes, kept within 0.001 (always ill) and 0.05
// (never).
double notable_threshold(const TangentComplex& complex, const State& state);

// The same for tilt_moves(): 32 times the median of those that are not 0, kept within 2 (never ill) and 100
// (always) edges per degree. On real meshes that marks 1 to 2 % of the points.
double notable_tilt_move(const Vector& moves);

// Points on at least three planes whose measure is below the threshold; worst first, ties by index.
std::vector<IllDetermined> find_ill_determined(const TangentComplex& complex, const State& state,
                                               double threshold);
// The same with the design's notable_threshold().
std::vector<IllDetermined> find_ill_determined(const TangentComplex& complex, const State& state);

}  // namespace planewright
