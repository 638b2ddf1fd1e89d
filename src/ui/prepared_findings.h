// PreparedFindings: the bad places of one view of the panels, and what of them the window colours.
//
// Threads: plain values; made by the view preparer's worker.
#pragma once

#include <cstdint>

#include "core/base/geometry.h"
#include "core/diagnose/diagnosis.h"

namespace planewright::ui {

struct PrepareJob;

struct PreparedFindings {
  std::uint64_t layer = 0, number = 0;  // of the job, as in PreparedView
  Diagnosis diagnosis;                  // of the job's iterate; indices are of its complex
  Vector severity;                      // #panels, of the worst finding that touches each; not a number: none
  double milliseconds = 0.0;            // spent looking
};

PreparedFindings prepare_findings(const PrepareJob& job);

}  // namespace planewright::ui
