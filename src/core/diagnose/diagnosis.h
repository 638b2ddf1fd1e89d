// Diagnosis: all bad places of a layer, found by the detectors of this folder, each in a file of its own.
//
// Threads: pure. No failure: what cannot be measured is not found.
#pragma once

#include <vector>

#include "core/complex/state.h"
#include "core/diagnose/finding.h"
#include "core/problem/frozen_geometry.h"

namespace planewright {

// All findings of the kinds that are on, of a state whose panels are planar. Kinds in the order of
// FindingKind; within a kind by falling severity, then worse measure, then element and second by index, so
// that equal states give equal lists. other: a layer that beams go to (TwistedBeam); null: none.
std::vector<Finding> find_all(const TangentComplex& complex, const State& state,
                              const FindingSettings& settings = {}, const NeighbourLayer* other = nullptr);

struct Diagnosis {
  // Whether every point lies on its planes; if not, the state is no result of a solve, its panels are not
  // what would be built, and there are no findings.
  bool solved = false;
  double off_planes = 0.0;  // farthest that a point lies from one of its planes, mean edges
  std::vector<Finding> findings;

  int count(FindingKind kind) const;
};
Diagnosis diagnose(const TangentComplex& complex, const State& state, const FindingSettings& settings = {},
                   const NeighbourLayer* other = nullptr);

}  // namespace planewright
