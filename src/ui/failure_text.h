// Failures of the tolerance sheet in the few words of a list. The whole sentence is describe() of
// tolerance_sheet.h.
//
// Threads: pure functions.
#pragma once

#include <string>

#include "core/workshop/tolerance_sheet.h"

namespace planewright::ui {

// "edge too short", "corner too wide"
std::string failure_title(ToleranceKind kind);
// "C-17 to C-18" (the side between), "C-17, border", "C-17 corner 2", "C-17"
std::string failure_place(const ToleranceFailure& failure, const WorkshopModel& model);
// "24.1 < 50 mm"; empty where there is nothing to measure.
std::string failure_measure(const ToleranceFailure& failure);

}  // namespace planewright::ui
