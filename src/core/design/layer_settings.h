// LayerSettings: everything a designer sets that decides what the panels of one layer will be, and Design: all
// layers of a document. Plain values: what the window edits, undo stores, the command line parses and a solve
// takes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/complex/dual.h"
#include "core/complex/tangent_complex.h"
#include "core/problem/demand.h"
#include "core/problem/layout.h"

namespace planewright {

// On which side of the mesh a layer lies: what "in front" means for its demands.
enum class Side { ByOffset, Outside, Inside };

struct LayerSettings {
  ComplexKind mode = ComplexKind::Dual;
  double offset = 0.0;  // model units
  BorderPolicy border = BorderPolicy::Closed;
  Freedom freedom = Freedom::NormalsAndOffsets;
  Side side = Side::ByOffset;  // ByOffset: inside where the offset is negative
  // Weight of each energy by name (problem/energies lists them); one that is missing is 0.
  std::map<std::string, double> weights = {{"position", 1.0}, {"fairing", 0.0}};
  Demands demands;
  // Solve until an independent test finds no panel that crosses the mesh (design/layer_solve.h).
  bool no_penetration = false;
  int max_iterations = 500;
  double tolerance = 3e-4;  // first-order residual at which a solve counts as converged

  double side_sign() const {
    if (side == Side::ByOffset) return offset < 0.0 ? -1.0 : 1.0;
    return side == Side::Inside ? -1.0 : 1.0;
  }
  bool operator==(const LayerSettings&) const = default;
};

struct Layer {
  std::string name = "panels";
  LayerSettings settings;
  bool visible = true;
  double thickness = 0.0;  // model units: a parallel offset of the finished panels (core/layers); 0: none
  // Index of an earlier layer that this one's panel edges are made coplanar with, so that straight beams join
  // them; -1: none.
  int coplanar_with = -1;
  bool operator==(const Layer&) const = default;
};

struct Design {
  std::vector<Layer> layers{Layer{}};  // at least one
  std::vector<Selection> selections;   // shared by all layers; names are unique
  std::string reference;               // path of the surface that closeness refers to; empty: the mesh itself
  bool operator==(const Design&) const = default;
};

}  // namespace planewright
