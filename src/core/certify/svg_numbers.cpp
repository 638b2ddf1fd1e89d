#include "core/certify/svg_numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace planewright {
namespace {

using Eigen::Vector2d;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',';
}
void skip_blanks(std::string_view& text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
}

// The number that text begins with, which is taken off.
std::optional<double> take_number(std::string_view& text) {
  skip_blanks(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end.ec != std::errc() || !std::isfinite(value)) return {};
  text.remove_prefix(static_cast<size_t>(end.ptr - text.data()));
  return value;
}

// One function of a transform list.
std::optional<Eigen::Affine2d> function(std::string_view name, const std::vector<double>& v) {
  Eigen::Affine2d t = Eigen::Affine2d::Identity();
  if (name == "matrix" && v.size() == 6) {
    t.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0.0, 0.0, 1.0;
  } else if (name == "translate" && (v.size() == 1 || v.size() == 2)) {
    t.translate(Vector2d(v[0], v.size() == 2 ? v[1] : 0.0));
  } else if (name == "scale" && (v.size() == 1 || v.size() == 2)) {
    t.scale(Vector2d(v[0], v.back()));
  } else if (name == "rotate" && (v.size() == 1 || v.size() == 3)) {
    const Vector2d middle = v.size() == 3 ? Vector2d(v[1], v[2]) : Vector2d(Vector2d::Zero());
    t.translate(middle);
    t.rotate(v[0] * std::numbers::pi / 180.0);
    t.translate(-middle);
  } else {
    return {};
  }
  return t;
}

}  // namespace

std::optional<std::vector<double>> svg_numbers(std::string_view text) {
  std::vector<double> values;
  skip_blanks(text);
  while (!text.empty()) {
    const auto value = take_number(text);
    if (!value) return {};
    values.push_back(*value);
    skip_blanks(text);
  }
  return values;
}

std::optional<double> svg_length(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, double>, 7> kUnits{{{"mm", 1.0},
                                                                              {"cm", 10.0},
                                                                              {"in", 25.4},
                                                                              {"pt", 25.4 / 72.0},
                                                                              {"pc", 25.4 / 6.0},
                                                                              {"px", 25.4 / 96.0},
                                                                              {"", 25.4 / 96.0}}};
  const auto value = take_number(text);
  if (!value) return {};
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  for (const auto& [unit, mm] : kUnits)
    if (text == unit) return *value * mm;
  return {};
}

std::optional<Eigen::Affine2d> svg_transform(std::string_view text) {
  Eigen::Affine2d all = Eigen::Affine2d::Identity();
  skip_blanks(text);
  while (!text.empty()) {
    const size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
    std::string_view name = text.substr(0, open);
    while (!name.empty() && is_blank(name.back())) name.remove_suffix(1);
    const auto values = svg_numbers(text.substr(open + 1, close - open - 1));
    const auto t = values ? function(name, *values) : std::nullopt;
    if (!t) return {};
    all = all * *t;
    text.remove_prefix(close + 1);
    skip_blanks(text);
  }
  return all;
}

std::optional<std::vector<SvgPiece>> svg_path(std::string_view text) {
  std::vector<SvgPiece> pieces;
  Vector2d at = Vector2d::Zero(), start = at;
  bool open = false;
  char command = 0;
  skip_blanks(text);
  while (!text.empty()) {
    const char c = text.front();
    if ((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')) {
      command = c;
      text.remove_prefix(1);
    } else if (command == 0 || command == 'Z' || command == 'z') {
      return {};  // numbers of no command
    }
    const bool relative = command >= 'a';
    const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
    if (kind == 'Z') {
      if (!open) return {};
      pieces.back().closed = true;
      open = false;
      at = start;
    } else {
      if (kind != 'M' && kind != 'L' && kind != 'H' && kind != 'V') return {};
      const auto first = take_number(text);
      const auto second = kind == 'M' || kind == 'L' ? take_number(text) : first;
      if (!first || !second) return {};
      const Vector2d from = relative ? at : Vector2d(Vector2d::Zero());
      if (kind == 'H') {
        at.x() = from.x() + *first;
      } else if (kind == 'V') {
        at.y() = from.y() + *first;
      } else {
        at = from + Vector2d(*first, *second);
      }
      if (kind == 'M') {
        pieces.push_back({{at}, false});
        start = at;
        open = true;
        command = relative ? 'l' : 'L';  // pairs that follow are lines
      } else {
        // After Z a line starts a new piece where the last one did.
        if (!open && pieces.empty()) return {};
        if (!open) pieces.push_back({{start}, false});
        open = true;
        pieces.back().points.push_back(at);
      }
    }
    skip_blanks(text);
  }
  return pieces;
}

}  // namespace planewright
