// DesignSettings: everything a designer sets that decides what the panels of a mesh will be. A plain value:
// what the window edits, undo stores, the command line parses and a solve takes.
#pragma once

#include <map>
#include <string>

#include "core/complex/dual.h"
#include "core/complex/tangent_complex.h"
#include "core/problem/layout.h"

namespace planewright {

struct DesignSettings {
  ComplexKind mode = ComplexKind::Dual;
  double offset = 0.0;  // model units
  BorderPolicy border = BorderPolicy::Closed;
  Freedom freedom = Freedom::NormalsAndOffsets;
  // Weight of each energy by name (problem/energies.h lists them); one that is missing is 0.
  std::map<std::string, double> weights = {{"position", 1.0}, {"fairing", 0.0}};
  int max_iterations = 500;
  double tolerance = 3e-4;  // first-order residual at which a solve counts as converged

  bool operator==(const DesignSettings&) const = default;
};

}  // namespace planewright
