// What `planewright-cli export` tells at its end. Threads: one.
#pragma once

#include <string>

#include "core/fabricate/export_run.h"

namespace planewright::cli {

// Panels, verdicts, sheets and files on stdout; remarks and failures on stderr, the first of many.
void print_export(const WorkshopModel& model, const ExportPreparation& prepared,
                  const ExportOutcome& outcome);

}  // namespace planewright::cli
