// Demands: what a designer insists on, as opposed to energies, which are wishes. Plain values, as stored in a
// document, parsed by the command line and refused or turned into constraints by Problem::create.
//
// Elements are those of the designer's mesh (vertices, edges, faces), so that they outlive the complex; model
// units, absolute coordinates.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/complex/tangent_complex.h"
#include "core/problem/element.h"

namespace planewright {

// A named set of elements of the mesh; lists ascend. Dual: vertices mean panels, faces their points, edges
// the points of border edges. Planarize: faces mean panels, vertices points. Edges of a planarized mesh mean
// the points at both ends.
struct Selection {
  std::string name;
  std::vector<int> vertices, edges, faces;
  bool empty() const { return vertices.empty() && edges.empty() && faces.empty(); }
  bool operator==(const Selection&) const = default;
};

// One demand of demands/demand_catalogue.h.
struct Demand {
  std::string name;
  bool on = true;
  std::string selection = {};       // name of a Selection; empty: the whole model
  std::vector<double> values = {};  // as DemandInfo::parameters lists them; missing ones take their defaults
  bool operator==(const Demand&) const = default;
};

// A point held at given coordinates; one that is not given stays free.
struct Pin {
  PointOrigin point;
  std::array<std::optional<double>, 3> at;
  bool operator==(const Pin&) const = default;
};

// A panel held in a given plane { x : normal . x = distance }; no equation: in the plane it starts in.
struct PlanePin {
  struct Equation {
    std::array<double, 3> normal;  // any length but 0; made unit
    double distance;               // of the unit normal
    bool operator==(const Equation&) const = default;
  };
  int panel_origin;  // TangentComplex::plane_origin: vertex (dual) or face (planarize)
  std::optional<Equation> plane;
  bool operator==(const PlanePin&) const = default;
};

// A demand that is given up at one element, because it cannot be met there together with the others.
struct Waiver {
  std::string demand;
  ElementRef element;
  auto operator<=>(const Waiver&) const = default;
};

struct Demands {
  std::vector<Demand> list;
  std::vector<Pin> pins;
  std::vector<PlanePin> plane_pins;
  std::vector<Waiver> waived;
  double margin = 1e-4;  // mean edges by which inequalities are to be met, so that nothing touches
  bool operator==(const Demands&) const = default;
};

}  // namespace planewright
