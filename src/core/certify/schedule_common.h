// What the checks of both schedules have in common. Internal to certify/. Threads: pure.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/certify/certificate.h"

namespace planewright {

inline constexpr double kSquareMetresOfMm2 = 1e-6;

// Empty for -1.
std::string name_of_panel(const ExportContent& content, int panel);

std::map<std::string, const PanelPassport*> passports_by_name(const ExportContent& content);

// "3 rows for 3 panels"
Check row_count(size_t rows, size_t wanted, const char* of);

// Names in the first place of rows: each panel's exactly once.
Check names_once(const std::vector<std::string>& names, const ExportContent& content);

}  // namespace planewright
