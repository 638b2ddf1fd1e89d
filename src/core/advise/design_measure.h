// DesignMeasure: what a solved design is worth as a whole: how many bad places of each kind, and the score B
// that edits are judged by (score.h).
//
// Units: mean panel edges, those that the complex names. Threads: pure.
#pragma once

#include <array>

#include "core/advise/patch_solver.h"
#include "core/advise/score.h"
#include "core/diagnose/diagnosis.h"

namespace planewright {

// Panels that cross themselves or others or fold over, and points too close: what no workshop can build.
bool is_unbuildable(FindingKind kind);

struct DesignMeasure {
  int panels = 0, points = 0;
  std::array<int, kFindingKinds> findings{};  // how many, by kind
  Score score;                                // of the whole
  int unbuildable() const;                    // findings
};

// diagnosis: of the design. Fails as build_problem() does.
Result<DesignMeasure> measure_design(const Advised& design, const Diagnosis& diagnosis);

}  // namespace planewright
