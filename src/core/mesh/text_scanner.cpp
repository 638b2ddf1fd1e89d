#include "core/mesh/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace planewright {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
bool is_newline(char c) {
  return c == '\n' || c == '\r';
}
char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// std::from_chars knows no leading '+'.
std::string_view without_plus(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+') token.remove_prefix(1);
  return token;
}

}  // namespace

bool TextScanner::at_line_end() const {
  return position_ >= content_.size() || is_newline(content_[position_]);
}

void TextScanner::skip_blanks() {
  while (position_ < content_.size()) {
    const char c = content_[position_];
    if (is_blank(c)) {
      ++position_;
    } else if (rules_.continuation && c == '\\' && position_ + 1 < content_.size() &&
               is_newline(content_[position_ + 1])) {
      ++position_;
      skip_line();
    } else if (rules_.hash_comments && c == '#') {
      position_ = std::min(content_.find_first_of("\r\n", position_), content_.size());
      return;
    } else {
      return;
    }
  }
}

std::string_view TextScanner::token_in_line() {
  skip_blanks();
  const size_t begin = position_;
  while (position_ < content_.size()) {
    const char c = content_[position_];
    if (is_blank(c) || is_newline(c)) break;
    if (rules_.continuation && c == '\\' && position_ + 1 < content_.size() &&
        is_newline(content_[position_ + 1]))
      break;
    ++position_;
  }
  if (position_ > begin) token_line_ = line_;
  return content_.substr(begin, position_ - begin);
}

std::string_view TextScanner::token() {
  while (true) {
    const std::string_view found = token_in_line();
    if (!found.empty() || position_ >= content_.size()) return found;
    skip_line();
  }
}

void TextScanner::skip_line() {
  position_ = std::min(content_.find_first_of("\r\n", position_), content_.size());
  if (position_ == content_.size()) return;
  const bool carriage_return = content_[position_] == '\r';
  ++position_;
  if (carriage_return && position_ < content_.size() && content_[position_] == '\n') ++position_;
  ++line_;
}

bool TextScanner::at_end() {
  skip_blanks();
  while (position_ < content_.size() && at_line_end()) {
    skip_line();
    skip_blanks();
  }
  return position_ >= content_.size();
}

std::optional<double> to_number(std::string_view token) {
  token = without_plus(token);
  const char* end = token.data() + token.size();
  double value = 0.0;
  auto result = std::from_chars(token.data(), end, value);
  if (result.ec == std::errc() && result.ptr == end) return value;
  if (result.ec != std::errc::result_out_of_range || result.ptr != end) return {};
  // Too large or too small for a double, and from_chars does not say which: a wider type does.
  long double wide = 0.0L;
  result = std::from_chars(token.data(), end, wide);
  if (result.ec != std::errc()) return std::numeric_limits<double>::infinity();
  return static_cast<double>(wide);
}

std::optional<long long> to_integer(std::string_view token) {
  token = without_plus(token);
  const char* end = token.data() + token.size();
  long long value = 0;
  const auto result = std::from_chars(token.data(), end, value);
  if (result.ptr != end || token.empty() || result.ec == std::errc::invalid_argument) return {};
  if (result.ec == std::errc::result_out_of_range)
    return token[0] == '-' ? std::numeric_limits<long long>::min() : std::numeric_limits<long long>::max();
  return value;
}

Result<double> read_coordinate(const TextScanner& scanner, std::string_view token) {
  const auto value = to_number(token);
  if (!value)
    return scanner.error(in_quotes(token) + " is not a number", "Correct the line or export the file again");
  if (!std::isfinite(*value))
    return scanner.error("the coordinate " + in_quotes(token) + " is not a finite number",
                         "Correct or remove the vertex");
  return *value;
}

std::string in_quotes(std::string_view token) {
  constexpr size_t kLongest = 24;
  std::string text = "\"";
  for (char c : token.substr(0, kLongest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (token.size() > kLongest ? "...\"" : "\"");
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace planewright
