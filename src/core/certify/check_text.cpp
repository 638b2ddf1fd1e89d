#include "core/certify/check_text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace planewright {

std::string counted(long long n) {
  std::string digits = std::to_string(n);
  for (int at = static_cast<int>(digits.size()) - 3; at > (n < 0 ? 1 : 0); at -= 3)
    digits.insert(static_cast<size_t>(at), ",");
  return digits;
}

std::string brief(double value) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3);
  return std::string(text.data(), end.ptr);
}

std::string listed(const std::vector<std::string>& names) {
  constexpr size_t kShown = 5;
  std::string text;
  for (size_t i = 0; i < std::min(names.size(), kShown); ++i) text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > kShown)
    text += " and " + counted(static_cast<long long>(names.size() - kShown)) + " more";
  return text;
}

std::string against_limit(double difference, double limit, std::string_view unit) {
  const std::string of = unit.empty() ? "" : " " + std::string(unit);
  return "largest difference " + brief(difference) + of + " (limit " + brief(limit) + of + ")";
}

}  // namespace planewright
