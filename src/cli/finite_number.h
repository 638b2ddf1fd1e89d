// Checks for options that take a number: CLI11's own ones are comparisons, which let "nan" pass, and name the
// largest double in their messages.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace planewright::cli {

// Refuses nan, infinities and what overflows to them. Text that is no number at all is left to the option's
// own conversion. Without a name, so that --help stays short.
inline CLI::Validator finite_number() {
  return CLI::Validator(
      [](const std::string& text) {
        double value = 0.0;
        return CLI::detail::lexical_cast(text, value) && !std::isfinite(value)
                   ? "'" + text + "' is not a finite number"
                   : std::string();
      },
      std::string());
}

// Refuse -1, and 0 too. Not for what is no finite number.
inline CLI::Validator not_negative() {
  return CLI::Validator(
      [](const std::string& text) {
        double value = 0.0;
        return CLI::detail::lexical_cast(text, value) && value < 0.0 ? "'" + text + "' is negative"
                                                                     : std::string();
      },
      std::string());
}
inline CLI::Validator positive_number() {
  return CLI::Validator(
      [](const std::string& text) {
        double value = 0.0;
        return CLI::detail::lexical_cast(text, value) && value <= 0.0 ? "'" + text + "' is not positive"
                                                                      : std::string();
      },
      std::string());
}

}  // namespace planewright::cli
