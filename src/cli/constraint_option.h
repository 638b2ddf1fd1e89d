// Parsing of --constraint NAME[=VALUE[:VALUE...]][@SELECTION].
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/problem/demand.h"

namespace planewright::cli {

// Values in the order of DemandInfo::parameters; an empty one, or one that is not there, takes its default.
// Fails with ErrorCode::Usage: an unknown demand (the known ones are listed), not a number, more values than
// the demand has (they are listed), an empty selection.
Result<Demand> parse_constraint(const std::string& text);

}  // namespace planewright::cli
