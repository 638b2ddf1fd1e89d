// Numbers as the window prints them: short, aligned, with the unit that the designer chose.
//
// Locale-independent. Threads: pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace planewright::ui {

// Three significant digits: "0", "0.125", "12.3", "1,753", "2.1e-10".
std::string format_number(double value);
// "0.125 m"; just the number when there is no unit.
std::string format_with_unit(double value, std::string_view unit);
// "1,753"
std::string format_count(std::int64_t count);
// "1 panel", "162 panels"
std::string format_count(std::int64_t count, std::string_view singular, std::string_view plural);
// "340 ms", "1.2 s", "2 min 05 s"
std::string format_duration(double seconds);
// The text with its first letter upper case (ASCII).
std::string capitalised(std::string text);
// "12 KB"
std::string format_bytes(std::uintmax_t bytes);

}  // namespace planewright::ui
