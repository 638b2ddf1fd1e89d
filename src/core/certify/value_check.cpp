#include "core/certify/value_check.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/certify/check_text.h"

namespace planewright {
namespace {

// Relative, and absolute below 1: what a table of twelve digits keeps.
constexpr double kLimit = 1e-9;

}  // namespace

std::optional<double> number_in(std::string_view text) {
  double value = 0.0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || end.ec != std::errc() || end.ptr != text.data() + text.size()) return {};
  return value;
}

void ValueCheck::compare(const std::string& who, std::string_view what, const std::optional<double>& written,
                         const std::optional<double>& wanted) {
  ++compared_;
  // What is no finite number cannot be written.
  const bool should = wanted && std::isfinite(*wanted);
  if (written.has_value() != should) {
    wrong_.push_back(who + " " + std::string(what));
    return;
  }
  if (!should) return;
  const double difference = std::abs(*written - *wanted) / std::max(1.0, std::abs(*wanted));
  // Not the other way round: what is not a number is wrong, too.
  if (!(difference <= kLimit)) wrong_.push_back(who + " " + std::string(what));
  largest_ = std::max(largest_, difference);
}

void ValueCheck::compare(const std::string& who, std::string_view what, std::string_view written,
                         std::string_view wanted) {
  ++compared_;
  if (written != wanted) wrong_.push_back(who + " " + std::string(what));
}

Check ValueCheck::check(std::string name) const {
  std::string detail = counted(compared_) + " values, " + against_limit(largest_, kLimit, "") + ", relative";
  if (!wrong_.empty()) detail += "; wrong: " + listed(wrong_);
  return {std::move(name), wrong_.empty(), detail};
}

}  // namespace planewright
