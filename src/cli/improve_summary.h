// What `improve` did, as text on stdout.
#pragma once

#include <string>

#include "core/export/improve_record.h"

namespace planewright::cli {

void print_improvement(const ImproveRecord& record, const std::string& unit);

}  // namespace planewright::cli
