// Beams: one quad per panel edge, between an edge of one layer and the same edge of another (its parallel
// offset, or a layer solved apart).
//
// Between a layer and its exact parallel offset edges are parallel and the quads planar to rounding. Between
// layers solved apart they twist, unless the demand "coplanar-beams" was met. Units: model units, relative to
// the origin of the first complex. Indices 0-based. Threads: pure.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/complex/state.h"

namespace planewright {

struct Beams {
  Points points;                  // 2 #X x 3: the points of both layers, one after the other
  Polygons quads;                 // one per panel edge, in their order: a, b, b', a'
  std::vector<int> edge;          // the panel edge of each quad
  std::vector<double> planarity;  // largest distance of a corner from the quad's least-squares plane
  std::vector<double> twist;      // angle between the two edges, radians, 0..pi; 0 if one has no length
};

// Refused: the layers' complexes do not have the same points and panels (other mesh, mode or border policy),
// or a state has not the points of its complex.
Result<Beams> make_beams(const TangentComplex& first, const State& first_state, const TangentComplex& second,
                         const State& second_state);

struct BeamSummary {
  int beams = 0;
  double max_planarity = 0.0;       // model units
  double planarity_relative = 0.0;  // to the diagonal of the box round both layers; 0 if that is 0
  int least_planar_edge = -1;       // panel edge; -1: no beams
  double max_twist = 0.0;           // radians
  int most_twisted_edge = -1;
};
// Ties: the first edge.
BeamSummary summarise(const Beams& beams);

}  // namespace planewright
