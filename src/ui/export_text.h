// What the export dialog says of stages, results and troubles. Threads: pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/fabricate/export_run.h"

namespace planewright::ui {

// "Laying parts on sheets" of "nesting".
std::string stage_text(std::string_view stage);
// "Certified: 24 files, 3.1 MB, every check passed", or "The certificate says no: 2 of 310 checks fail".
std::string outcome_line(const ExportOutcome& outcome);
// "sheets/sheet-03.dxf: closed: ...", of every check that fails.
std::vector<std::string> failed_checks(const Certificate& certificate);
// The core's error in the window's words: no options of the command line.
Error readable(Error error);
// "Sheet 3 of 17, 63 % filled, 21 parts"; "All panels in rows, 378 parts".
std::string sheet_line(const ExportPreparation& made, int sheet);
// "14 of 360 panels fail", "360 panels keep the tolerances"
std::string verdict_line(const ToleranceVerdicts& verdicts);

}  // namespace planewright::ui
