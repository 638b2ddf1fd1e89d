// JSON as the text of a project file, and back. Internal to edit/.
//
// Written so that people and version control can read it: a row of numbers is a line. Numbers have as many
// digits as it takes to read the very same double again (17 at most). Threads: pure.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace planewright {

// Keys in the order in which they were added. Refused, naming the place ("design.layers[0].settings.offset"):
// a number that is not finite, which JSON has no word for, and text that is not UTF-8.
Result<std::string> json_text(const nlohmann::ordered_json& json);

// Fails with ErrorCode::Unreadable and the line ("roof.planewright:14"). name: what errors call the file.
Result<nlohmann::json> parse_json(std::string_view text, const std::string& name);

}  // namespace planewright
