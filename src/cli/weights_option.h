// Parsing of --weights name=value,name=value.
#pragma once

#include <map>
#include <string>

#include "core/base/result.h"

namespace planewright::cli {

// Fails with ErrorCode::Usage: no '=', not a number, a name twice, an unknown energy (the known ones are
// listed).
Result<std::map<std::string, double>> parse_weights(const std::string& text);

}  // namespace planewright::cli
