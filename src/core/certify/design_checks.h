// Checks of the document itself, before any file: panels, patterns and solids. Internal to certify/. Threads:
// pure.
#pragma once

#include <vector>

#include "core/certify/certificate.h"

namespace planewright {

std::vector<Check> check_design(const ExportContent& content);

}  // namespace planewright
