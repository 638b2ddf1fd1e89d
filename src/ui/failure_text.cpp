#include "ui/failure_text.h"

#include "ui/format.h"

namespace planewright::ui {
namespace {

bool is_corner(ToleranceKind kind) {
  return kind == ToleranceKind::InteriorMin || kind == ToleranceKind::InteriorMax;
}

}  // namespace

std::string failure_title(ToleranceKind kind) {
  switch (kind) {
    case ToleranceKind::Planarity:
      return "not planar";
    case ToleranceKind::Distance:
      return "far from reference";
    case ToleranceKind::EdgeMin:
      return "edge too short";
    case ToleranceKind::EdgeMax:
      return "edge too long";
    case ToleranceKind::AreaMin:
      return "too small";
    case ToleranceKind::AreaMax:
      return "too large";
    case ToleranceKind::InteriorMin:
      return "corner too sharp";
    case ToleranceKind::InteriorMax:
      return "corner too wide";
    case ToleranceKind::DihedralMin:
      return "valley too deep";
    case ToleranceKind::DihedralMax:
      return "ridge too steep";
    case ToleranceKind::StockSize:
      return "fits no sheet";
    case ToleranceKind::CrossesItself:
      break;
  }
  return "crosses itself";
}

std::string failure_place(const ToleranceFailure& failure, const WorkshopModel& model) {
  std::string text = model.names[static_cast<std::size_t>(failure.panel)];
  if (failure.side < 0) return text;
  if (is_corner(failure.kind)) return text + " corner " + std::to_string(failure.side + 1);
  const int neighbour = model.neighbour(failure.panel, failure.side);
  return text + (neighbour < 0 ? ", border" : " to " + model.names[static_cast<std::size_t>(neighbour)]);
}

std::string failure_measure(const ToleranceFailure& failure) {
  if (failure.kind == ToleranceKind::CrossesItself) return {};
  const std::string unit(tolerance_unit(failure.kind));
  std::string measured = format_number(failure.measured), limit = format_number(failure.limit);
  if (measured == limit) measured = "hardly";  // three digits do not tell them apart; the sentence does
  const char* sign = failure.measured < failure.limit ? " < " : " > ";
  return measured + sign + limit + (unit == "°" ? "" : " ") + unit;
}

}  // namespace planewright::ui
