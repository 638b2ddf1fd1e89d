// What CSV and JSON schedules have to say. Internal to certify/. Threads: pure.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/certify/certificate.h"
#include "core/certify/csv_reader.h"

namespace planewright {

std::vector<Check> check_panel_csv(const CsvTable& table, const ExportContent& content);
std::vector<Check> check_edge_csv(const CsvTable& table, const ExportContent& content);
// Fails with ErrorCode::Unreadable where the text is no JSON.
Result<std::vector<Check>> check_schedule_json(std::string_view text, const ExportContent& content,
                                               const std::string& name);

}  // namespace planewright
