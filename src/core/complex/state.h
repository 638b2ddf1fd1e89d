// State: the unknowns of a complex, and Panels: the polygon mesh that a state means.
//
// Units: model units, relative to the complex's origin, for x and h; n is unit. Threads: plain values.
#pragma once

#include "core/complex/tangent_complex.h"
#include "core/mesh/element_map.h"

namespace planewright {

struct State {
  Points x;  // #X x 3, the points
  Points n;  // #P x 3, the planes' unit normals
  Vector h;  // #P, signed offsets along n from the anchors
};

// The state at which a solve starts when nothing better is known: x = f, n and h as the builder set them.
State initial_state(const TangentComplex& complex);

// A start for `to` from a state of `from`: planes and points with the same origin are taken over; new ones,
// and points whose planes changed (an edge was flipped), start where `to` prefers them. A plane whose vertex
// or face moved stays where it was in space. Planes of clusters are taken over by the corners that they
// share. Works for any two complexes of one mesh, or (edited not null) of a mesh and what edits made of it;
// `edited` maps from the mesh of `from` to that of `to`.
State transfer(const TangentComplex& from, const State& state, const TangentComplex& to,
               const ElementMap* edited = nullptr);

// n_i . (x_j - v_i) - h_i for each incidence, points in order, each point's planes ascending (#incidences),
// model units: how far each point is from each of its planes.
Vector incidence_residuals(const TangentComplex& complex, const State& state);

struct Panels {
  Points points;      // #X x 3, model units, absolute
  Polygons polygons;  // #P lists of points
};
Panels panels_of(const TangentComplex& complex, const State& state);

}  // namespace planewright
