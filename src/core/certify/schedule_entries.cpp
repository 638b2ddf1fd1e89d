#include "core/certify/schedule_entries.h"

#include <cmath>
#include <limits>

namespace planewright {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// As docs/workshop-files.md lists them.
std::string_view kind_word(ToleranceKind kind) {
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
      return "crosses_itself";
  }
  return {};
}

std::optional<WrittenFailure> failure_in(std::string_view text) {
  WrittenFailure failure;
  if (const size_t colon = text.find(": "); colon != std::string_view::npos) {
    const std::string_view numbers = text.substr(colon + 2);
    const size_t sign = numbers.find_first_of("<>");
    if (sign == std::string_view::npos || sign == 0 || sign + 2 > numbers.size()) return {};
    failure.measured = number_in(numbers.substr(0, sign - 1));
    failure.limit = number_in(numbers.substr(sign + 2));
    if (!failure.measured || !failure.limit) return {};
    if ((*failure.measured < *failure.limit) != (numbers[sign] == '<')) return {};
    text = text.substr(0, colon);
  }
  constexpr std::string_view kSide = " side ";
  if (const size_t side = text.find(kSide); side != std::string_view::npos) {
    failure.side = number_in(text.substr(side + kSide.size()));
    if (!failure.side) return {};
    text = text.substr(0, side);
  }
  failure.kind = text;
  return failure;
}

std::optional<double> unless_none(double number) {
  return number != 0.0 ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<std::vector<WrittenFailure>> failures_in(std::string_view text) {
  std::vector<WrittenFailure> all;
  while (!text.empty()) {
    const size_t end = text.find("; ");
    auto failure = failure_in(text.substr(0, end));
    if (!failure) return {};
    all.push_back(std::move(*failure));
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 2);
  }
  return all;
}

EntryChecks::EntryChecks(const ExportContent& content) : content_(content) {
  const auto count = static_cast<size_t>(content.model->panel_count());
  member_.resize(count);
  class_.assign(count, 0.0);
  sheet_.assign(count, 0.0);
  failures_.resize(count);
  if (content.classes)
    for (size_t c = 0; c < content.classes->size(); ++c)
      for (const CongruenceMember& m : (*content.classes)[c].members) {
        member_[static_cast<size_t>(m.panel)] = m;
        class_[static_cast<size_t>(m.panel)] = static_cast<double>(c + 1);
      }
  // The drawing that has the panel's name is its sheet, whatever the nesting had in mind.
  for (size_t d = 0; content.nesting && d < content.drawings.size(); ++d)
    for (const DrawingText& text : content.drawings[d].texts) {
      if (!text.is_name || text.panel < 0) continue;
      double& sheet = sheet_[static_cast<size_t>(text.panel)];
      sheet = sheet == 0.0 ? static_cast<double>(d + 1) : kNoNumber;
    }
  for (const ToleranceFailure& f : content.verdicts->failures)
    failures_[static_cast<size_t>(f.panel)].push_back(&f);
}

void EntryChecks::compare(int panel, const WrittenEntry& written) {
  const auto p = static_cast<size_t>(panel);
  const std::string& name = content_.model->names[p];
  classes_.compare(name, "class", written.group, unless_none(class_[p]));
  classes_.compare(name, "mirrored", written.mirrored,
                   !member_[p]            ? ""
                   : member_[p]->mirrored ? "yes"
                                          : "no");
  if (std::isnan(sheet_[p]))
    sheets_.compare(name, "on one sheet alone", "no", "yes");
  else
    sheets_.compare(name, "sheet", written.sheet, unless_none(sheet_[p]));
  compare_failures(panel, written);
}

void EntryChecks::compare_failures(int panel, const WrittenEntry& written) {
  const auto p = static_cast<size_t>(panel);
  const std::string& name = content_.model->names[p];
  const auto& wanted = failures_[p];
  const bool pass = content_.verdicts->pass[p];
  verdicts_.compare(name, "verdict", written.verdict, pass ? "pass" : "fail");
  verdicts_.compare(name, "verdict and failures", pass ? "none" : "some", wanted.empty() ? "none" : "some");
  if (!written.failures || written.failures->size() != wanted.size()) {
    verdicts_.compare(name, "failures", "wrong", "right");
    return;
  }
  for (size_t i = 0; i < wanted.size(); ++i) {
    const ToleranceFailure& should = *wanted[i];
    const WrittenFailure& is = (*written.failures)[i];
    const std::string what = "failure " + std::to_string(i + 1);
    verdicts_.compare(name, what, is.kind, kind_word(should.kind));
    verdicts_.compare(name, what + " side", is.side,
                      should.side >= 0 ? std::optional(should.side + 1.0) : std::nullopt);
    // A table has no numbers where they tell nothing, or there are none.
    const bool silent = should.kind == ToleranceKind::CrossesItself || !std::isfinite(should.measured) ||
                        !std::isfinite(should.limit);
    if (silent && !is.measured && !is.limit) continue;
    verdicts_.compare(name, what + " measured", is.measured, should.measured);
    verdicts_.compare(name, what + " limit", is.limit, should.limit);
  }
}

void EntryChecks::append_to(std::vector<Check>& checks) const {
  checks.push_back(classes_.check("classes"));
  checks.push_back(sheets_.check("sheets"));
  checks.push_back(verdicts_.check("verdicts and failures"));
}

}  // namespace planewright
