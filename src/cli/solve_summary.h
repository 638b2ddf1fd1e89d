// What a person is told of a solved layer: the summary on stdout, and warnings on stderr.
#pragma once

#include <string>

#include "cli/exit_status.h"
#include "core/export/solve_record.h"

namespace planewright::cli {

// output: the file of the panels.
void print_summary(const SolveRecord& record, const std::string& output, const std::string& unit);

// The exit status that a layer earns; warns of whatever keeps it from success.
ExitStatus judge(const SolveRecord& record);

}  // namespace planewright::cli
