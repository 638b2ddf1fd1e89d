#include "ui/format.h"

#include <array>
#include <charconv>
#include <cmath>

namespace planewright::ui {
namespace {

std::string to_text(double value, std::chars_format format, int precision) {
  std::array<char, 64> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  return error == std::errc() ? std::string(buffer.data(), end) : std::string("?");
}

// "2.10e-10" -> "2.1e-10"
std::string without_trailing_zeros(std::string text) {
  const auto exponent = text.find('e');
  std::string mantissa = text.substr(0, exponent);
  if (mantissa.find('.') != std::string::npos) {
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.back() == '.') mantissa.pop_back();
  }
  return exponent == std::string::npos ? mantissa : mantissa + text.substr(exponent);
}

}  // namespace

std::string format_number(double value) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  const double size = std::abs(value);
  if (size == 0) return "0";
  if (size < 1e-3 || size >= 1e6)
    return without_trailing_zeros(to_text(value, std::chars_format::scientific, 1));
  if (size >= 999.5) return format_count(static_cast<std::int64_t>(std::llround(value)));
  const int before_point = size < 1 ? 0 : static_cast<int>(std::log10(size)) + 1;
  const int after_point = size < 1 ? (size < 0.0995 ? 4 : 3) : 3 - before_point;
  return without_trailing_zeros(to_text(value, std::chars_format::fixed, after_point));
}

std::string format_with_unit(double value, std::string_view unit) {
  std::string text = format_number(value);
  if (!unit.empty()) text.append(1, ' ').append(unit);
  return text;
}

std::string format_count(std::int64_t count) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t left = digits.size() - i;
    if (i > 0 && left % 3 == 0 && digits[i - 1] != '-') text.append(1, ',');
    text.append(1, digits[i]);
  }
  return text;
}

std::string format_count(std::int64_t count, std::string_view singular, std::string_view plural) {
  return format_count(count) + " " + std::string(count == 1 ? singular : plural);
}

std::string format_duration(double seconds) {
  if (!(seconds >= 0)) return "–";
  if (seconds < 0.01) return to_text(seconds * 1000, std::chars_format::fixed, 1) + " ms";
  if (seconds < 1) return to_text(seconds * 1000, std::chars_format::fixed, 0) + " ms";
  if (seconds < 100) return to_text(seconds, std::chars_format::fixed, 1) + " s";
  const auto whole = static_cast<std::int64_t>(seconds);
  const std::int64_t rest = whole % 60;
  return std::to_string(whole / 60) + " min " + (rest < 10 ? "0" : "") + std::to_string(rest) + " s";
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string format_bytes(std::uintmax_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " B";
  const double kilo = static_cast<double>(bytes) / 1000.0;
  if (kilo < 1000) return format_number(kilo) + " KB";
  if (kilo < 1e6) return format_number(kilo / 1e3) + " MB";
  return format_number(kilo / 1e6) + " GB";
}

}  // namespace planewright::ui
