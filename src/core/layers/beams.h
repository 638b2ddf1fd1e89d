// Beams: one quad per panel edge, between an edge of one layer and the same edge of another (its parallel
// offset, or a layer solved apart).
//
// Between a layer and its exact parallel offset edges are parallel and the quads planar to rounding. Between
// layers solved apart they twist, unless the demand "coplanar-beams" was met. Units: model units, relative to
// the origin of the first complex. Threads: pure.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/complex/state.h"

namespace planewright {

struct Beams {
  Points points;                  // 2 #X x 3: the points of both layers, one after the other
  Polygons quads;                 // one per panel edge that both layers have: a, b, b', a'
  std::vector<int> edge;          // the panel edge of each quad
  std::vector<double> planarity;  // largest distance of a corner from the quad's least-squares plane
  std::vector<double> twist;      // angle between the two edges, radians
};

// Refused: the layers' complexes do not have the same points and panels (other mesh, mode or border policy).
Result<Beams> make_beams(const TangentComplex& first, const State& first_state, const TangentComplex& second,
                         const State& second_state);

}  // namespace planewright
