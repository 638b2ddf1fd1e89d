#include "core/writers/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace planewright {
namespace {

// As far as this a fixed number is no longer than one with an exponent would be, by much.
constexpr double kSmallestFixed = 1e-9, kLargestFixed = 1e15;

void require_finite(double value) {
  if (!std::isfinite(value))
    throw std::invalid_argument("a number that is not finite is on its way to a file");
}

}  // namespace

void append_number(std::string& out, int value) {
  std::array<char, 16> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  out.append(buffer.data(), end.ptr);
}

void append_number(std::string& out, double value) {
  require_finite(value);
  if (value == 0.0) value = 0.0;  // no -0
  const double size = std::abs(value);
  const bool fixed = size == 0.0 || (size >= kSmallestFixed && size < kLargestFixed);
  std::array<char, 64> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 fixed ? std::chars_format::fixed : std::chars_format::scientific);
  out.append(buffer.data(), end.ptr);
}

void append_rounded(std::string& out, double value, int decimals) {
  require_finite(value);
  std::array<char, 400> buffer;  // 1e308 has 309 digits
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  std::string text(buffer.data(), end.ptr);
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  out += text;
}

std::string number_text(double value) {
  std::string out;
  append_number(out, value);
  return out;
}

std::string rounded_text(double value, int decimals) {
  std::string out;
  append_rounded(out, value, decimals);
  return out;
}

}  // namespace planewright
