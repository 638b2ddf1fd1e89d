// What tolerances are called, and failures of them in words.
#include <array>
#include <cmath>
#include <cstdio>

#include "core/workshop/tolerance_sheet.h"

namespace planewright {
namespace {

std::string digits(double value, int count) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", count, value);
  return text.data();
}

// Both as short as they can be and still read as different.
std::pair<std::string, std::string> told_apart(double measured, double limit) {
  for (int count = 4; count < 17; ++count) {
    const std::string m = digits(measured, count), l = digits(limit, std::max(count, 6));
    if (std::stod(m) != std::stod(l) && (std::stod(m) < std::stod(l)) == (measured < limit)) return {m, l};
  }
  return {digits(measured, 17), digits(limit, 17)};
}

bool is_minimum(ToleranceKind kind) {
  return kind == ToleranceKind::EdgeMin || kind == ToleranceKind::AreaMin ||
         kind == ToleranceKind::InteriorMin || kind == ToleranceKind::DihedralMin;
}

std::string with_unit(const std::string& number, ToleranceKind kind) {
  const std::string unit(tolerance_unit(kind));
  return number + (unit.empty() || unit == "°" ? "" : " ") + unit;
}

}  // namespace

std::string_view tolerance_name(ToleranceKind kind) {
  switch (kind) {
    case ToleranceKind::Planarity:
      return "planarity";
    case ToleranceKind::Distance:
      return "distance to reference";
    case ToleranceKind::EdgeMin:
    case ToleranceKind::EdgeMax:
      return "edge length";
    case ToleranceKind::AreaMin:
    case ToleranceKind::AreaMax:
      return "area";
    case ToleranceKind::InteriorMin:
    case ToleranceKind::InteriorMax:
      return "interior angle";
    case ToleranceKind::DihedralMin:
    case ToleranceKind::DihedralMax:
      return "dihedral angle";
    case ToleranceKind::StockSize:
      return "stock size";
    case ToleranceKind::CrossesItself:
      break;
  }
  return "crosses itself";
}

std::string_view tolerance_unit(ToleranceKind kind) {
  switch (kind) {
    case ToleranceKind::Planarity:
    case ToleranceKind::Distance:
    case ToleranceKind::EdgeMin:
    case ToleranceKind::EdgeMax:
    case ToleranceKind::StockSize:
      return "mm";
    case ToleranceKind::AreaMin:
    case ToleranceKind::AreaMax:
      return "m²";
    case ToleranceKind::InteriorMin:
    case ToleranceKind::InteriorMax:
    case ToleranceKind::DihedralMin:
    case ToleranceKind::DihedralMax:
      return "°";
    case ToleranceKind::CrossesItself:
      break;
  }
  return "";
}

std::string describe(const ToleranceFailure& failure, const WorkshopModel& model) {
  std::string text = model.names[static_cast<size_t>(failure.panel)];
  if (failure.kind == ToleranceKind::CrossesItself) return text + ": its outline crosses itself";
  const bool corner =
      failure.kind == ToleranceKind::InteriorMin || failure.kind == ToleranceKind::InteriorMax;
  if (failure.side >= 0) {
    text += (corner ? ", corner " : ", side ") + std::to_string(failure.side + 1);
    if (!corner) {
      const int neighbour = model.neighbour(failure.panel, failure.side);
      text += neighbour < 0 ? " (border)" : " (to " + model.names[static_cast<size_t>(neighbour)] + ")";
    }
  }
  const auto [measured, limit] = told_apart(failure.measured, failure.limit);
  if (failure.kind == ToleranceKind::StockSize)
    return text + ": does not fit the stock, turned as it likes: its smallest rectangle has " +
           with_unit(measured, failure.kind) + " where the stock has " + with_unit(limit, failure.kind);
  return text + ": " + std::string(tolerance_name(failure.kind)) + " " + with_unit(measured, failure.kind) +
         (is_minimum(failure.kind) ? " is below " : " is above ") + with_unit(limit, failure.kind);
}

}  // namespace planewright
