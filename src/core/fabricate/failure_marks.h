// Marks on drawings where panels fail their tolerances, so that nobody cuts one unseen. Threads: pure.
#pragma once

#include "core/pattern/drawing.h"
#include "core/workshop/tolerance_sheet.h"

namespace planewright {

// Below the name of each failing panel: "FAILS: planarity, edge length" on the layer TEXT, along the name.
void mark_failures(Drawing& drawing, const ToleranceVerdicts& verdicts);

}  // namespace planewright
