// named_choice: what an option of an enum takes, by name. Anything else is refused with the names that there
// are.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace planewright::cli {

template <class Value>
CLI::Validator named_choice(std::vector<std::pair<std::string, Value>> choices) {
  std::string names;
  for (const auto& [name, value] : choices) names += (names.empty() ? "" : ", ") + name;
  return CLI::Validator(
      [choices = std::move(choices), names](std::string& given) {
        for (const auto& [name, value] : choices)
          if (given == name) {
            given = std::to_string(static_cast<int>(value));  // as CLI11 reads an enum
            return std::string();
          }
        return "'" + given + "' is none of: " + names;
      },
      "", "named choice");
}

}  // namespace planewright::cli
