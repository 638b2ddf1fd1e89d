#include "core/writers/schedule_parts.h"

#include <cmath>

#include "core/writers/number_text.h"

namespace planewright {

const char* failure_key(ToleranceKind kind) {
  switch (kind) {
    case ToleranceKind::Planarity:
      return "planarity";
    case ToleranceKind::Distance:
      return "distance";
    case ToleranceKind::EdgeMin:
      return "edge_min";
    case ToleranceKind::EdgeMax:
      return "edge_max";
    case ToleranceKind::AreaMin:
      return "area_min";
    case ToleranceKind::AreaMax:
      return "area_max";
    case ToleranceKind::InteriorMin:
      return "interior_min";
    case ToleranceKind::InteriorMax:
      return "interior_max";
    case ToleranceKind::DihedralMin:
      return "dihedral_min";
    case ToleranceKind::DihedralMax:
      return "dihedral_max";
    case ToleranceKind::StockSize:
      return "stock_size";
    case ToleranceKind::CrossesItself:
      break;
  }
  return "crosses_itself";
}

ScheduleIndex::ScheduleIndex(const ScheduleSources& sources) : verdicts_(*sources.verdicts) {
  const auto count = static_cast<size_t>(sources.model->panel_count());
  class_of_.assign(count, -1);
  sheet_of_.assign(count, -1);
  mirrored_.assign(count, false);
  failures_.resize(count);
  for (size_t c = 0; c < sources.classes->size(); ++c) {
    for (const CongruenceMember& member : (*sources.classes)[c].members) {
      class_of_.at(member.panel) = static_cast<int>(c);
      mirrored_.at(member.panel) = member.mirrored;
    }
  }
  if (sources.nesting)
    for (size_t s = 0; s < sources.nesting->sheets.size(); ++s)
      for (const PlacedPart& part : sources.nesting->sheets[s].parts)
        sheet_of_.at(part.panel) = static_cast<int>(s);
  for (const ToleranceFailure& failure : verdicts_.failures) failures_.at(failure.panel).push_back(&failure);
}

const char* ScheduleIndex::verdict(int panel) const {
  return verdicts_.pass.at(panel) ? "pass" : "fail";
}

std::string ScheduleIndex::failures_text(int panel) const {
  std::string text;
  for (const ToleranceFailure* failure : failures_[panel]) {
    if (!text.empty()) text += "; ";
    text += failure_key(failure->kind);
    if (failure->side >= 0) text += " side " + std::to_string(failure->side + 1);
    if (failure->kind == ToleranceKind::CrossesItself) continue;
    if (!std::isfinite(failure->measured) || !std::isfinite(failure->limit)) continue;
    text += ": " + number_text(failure->measured) + (failure->measured < failure->limit ? " < " : " > ") +
            number_text(failure->limit);
  }
  return text;
}

}  // namespace planewright
