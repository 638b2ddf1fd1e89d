// Which findings to look for and beyond which thresholds: --only KIND,... and --threshold KIND=VALUE.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/diagnose/finding.h"

namespace planewright::cli {

void declare_thresholds(CLI::App& command, std::vector<std::string>& thresholds);

// only: empty for all kinds. Fails with ErrorCode::Usage: no such kind (the known ones are listed), no number
// of at least 0, a kind twice.
Result<FindingSettings> parse_finding_settings(const std::vector<std::string>& only,
                                               const std::vector<std::string>& thresholds);

}  // namespace planewright::cli
