// DemandContext: what the constraints of a demand are made of. Normalised units (layout.h): lengths in mean
// edges. The complex must outlive the constraints; everything else is there only while they are made.
#pragma once

#include <span>
#include <vector>

#include "core/complex/state.h"
#include "core/problem/demand.h"
#include "core/problem/frozen_geometry.h"
#include "core/problem/layout.h"

namespace planewright {

// Which points and panels of a complex a Selection means. Points of selected panels are in; so are panels all
// of whose points are selected. An edge is in if both its points are.
struct SelectedElements {
  std::vector<char> points;  // #X
  std::vector<char> panels;  // #P
  bool has_edge(const PanelEdge& edge) const { return points[edge.a] && points[edge.b]; }
};

// selection null: everything.
SelectedElements selected_elements(const TangentComplex& complex, const Selection* selection);

struct DemandContext {
  const TangentComplex& complex;  // normalised
  const Layout& layout;
  const SelectedElements& where;
  std::span<const double> values;  // complete; lengths in mean edges
  double margin = 1e-4;            // mean edges
  double side = 1.0;               // +1: the layer lies outside the mesh (along its normals), -1: inside
  const State* at = nullptr;       // normalised; where geometry is frozen; null: wanted points
  const NeighbourLayer* neighbour = nullptr;  // normalised like the complex; null: none
};

}  // namespace planewright
