// The files of an export: which there are for the formats wanted, and the bytes of each. Internal to
// fabricate/. Threads: pure.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/fabricate/export_run.h"

namespace planewright {

struct PlannedFile {
  ExportedFile file;
  std::function<Result<std::string>()> bytes;  // refers to what it was planned from
};

// In the order in which they are told: sheets, schedules, panels, solids. All arguments have to outlive it.
std::vector<PlannedFile> plan_files(const WorkshopModel& model, const ExportPreparation& prepared,
                                    const ExportSettings& settings);

}  // namespace planewright
