// FrozenGeometry: what a Problem takes from outside its complex and holds still while it is solved. Rounds of
// solves (design/layer_solve.h) renew it: foot points follow the state, crossing pairs get separating planes.
#pragma once

#include <memory>
#include <vector>

#include "core/complex/state.h"
#include "core/mesh/closest_point.h"

namespace planewright {

// A half space that a point has to stay in, because a panel it belongs to crossed something:
// normal . x >= low. Model units, relative to the complex's origin.
struct Separation {
  int point;
  Vector3d normal;  // unit
  double low;
  int panel;  // whose crossing asked for it
};

// Another layer of the same mesh, with the same points and panels, that this one is made to fit.
struct NeighbourLayer {
  std::shared_ptr<const TangentComplex> complex;
  State state;
};

struct FrozenGeometry {
  // The state at which foot points are taken and points are given their piece of the border; null: the
  // complex's wanted points and planes.
  const State* at = nullptr;
  std::shared_ptr<const ReferenceSurface> reference;  // null: the mesh itself
  std::shared_ptr<const NeighbourLayer> neighbour;    // null: none
  std::vector<Separation> separations;
};

}  // namespace planewright
