// PreparedFindings: the bad places of one view of the panels, and how bad they make each panel.
//
// Threads: plain values; made by the view preparer's worker.
#pragma once

#include <bitset>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/geometry.h"
#include "core/design/solve_session.h"
#include "core/diagnose/diagnosis.h"

namespace planewright::ui {

struct PrepareJob;

using HiddenFindings = std::bitset<kFindingKinds>;  // by FindingKind
inline bool is_hidden(const HiddenFindings& hidden, FindingKind kind) {
  return hidden[static_cast<std::size_t>(kind)];
}

struct PreparedFindings {
  std::uint64_t layer = 0, number = 0;     // of the job, as in PreparedView
  std::shared_ptr<const Iterate> iterate;  // the job's
  FindingSettings thresholds;              // likewise
  Diagnosis diagnosis;                     // of that iterate; indices are of its complex
  double milliseconds = 0.0;               // spent looking
};

PreparedFindings prepare_findings(const PrepareJob& job);

// Severity of the worst finding that touches each panel (#panels); not a number: none does.
Vector panel_severity(const TangentComplex& complex, const std::vector<Finding>& findings,
                      const HiddenFindings& hidden = {});

}  // namespace planewright::ui
