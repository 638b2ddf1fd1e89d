#include "ui/schedule.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "core/workshop/panel_names.h"
#include "ui/format.h"
#include "ui/schedule_filter.h"

namespace planewright::ui {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kSquareMetres = 1e-6;  // of a square millimetre
constexpr double kLeastShown = 1e-3;    // below it, numbers are of no interest to a workshop
constexpr double kEqual = 1e-6;         // what rounding makes of equal panels is no order

const std::array<ScheduleColumnInfo, kScheduleColumns>& columns() {
  static const std::array<ScheduleColumnInfo, kScheduleColumns> all = {{
      {"name", "Panel", "", "name", "The panel's name, in natural order: C-2 before C-17."},
      {"corners", "Corners", "", "corners", "How many corners, and sides, the panel has."},
      {"area", "Area", "m²", "area_m2", "The panel's area."},
      {"shortest edge", "Shortest", "mm", "edge_min_mm", "The panel's shortest edge."},
      {"longest edge", "Longest", "mm", "edge_max_mm", "The panel's longest edge."},
      {"smallest angle", "Angle", "°", "interior_min_deg", "The smallest interior angle at a corner."},
      {"largest bevel", "Bevel", "°", "bevel_max_deg",
       "By how much the most slanting edge leans from square to the panel, ridge or valley."},
      {"planarity", "Planarity", "mm", "planarity_mm",
       "The greatest distance of a corner from the panel's plane."},
      {"distance", "Distance", "mm", "distance_mm",
       "The farthest corner's distance from the design surface. Known when a solve has ended."},
      {"weight", "Weight", "kg", "weight_kg", "Area times thickness times density."},
      {"size", "Size", "mm", "width_mm\theight_mm",
       "Width and height of the smallest rectangle round the panel; ordered by the width."},
      {"class", "Class", "", "class",
       "Panels of one class are congruent: one pattern serves them all. How many there are stands beside. "
       "Known when a solve has ended. Files number the classes: A is 1."},
      {"verdict", "Verdict", "", "verdict",
       "Whether the panel keeps the tolerance sheet, and what it fails."},
  }};
  return all;
}

ScheduleRow row_of(const PreparedWorkshop& from, int panel) {
  const PanelPassport& passport = from.passports[static_cast<std::size_t>(panel)];
  ScheduleRow row;
  row.corners = static_cast<int>(passport.sides.size());
  row.area = passport.area * kSquareMetres;
  row.edge_min = row.interior_min = passport.sides.empty() ? kUnknown : std::numeric_limits<double>::max();
  row.edge_max = passport.sides.empty() ? kUnknown : 0.0;
  for (const SidePassport& side : passport.sides) {
    row.edge_min = std::min(row.edge_min, side.length);
    row.edge_max = std::max(row.edge_max, side.length);
    row.interior_min = std::min(row.interior_min, side.interior);
    row.bevel_max = std::max(row.bevel_max, std::abs(side.bevel));
  }
  row.planarity = passport.planarity;
  row.distance = passport.distance.value_or(kUnknown);
  row.weight = passport.weight.value_or(kUnknown);
  row.width = passport.width;
  row.height = passport.height;
  if (!from.class_of_panel.empty()) {
    row.class_index = from.class_of_panel[static_cast<std::size_t>(panel)];
    if (row.class_index >= 0)
      row.class_size =
          static_cast<int>(from.classes[static_cast<std::size_t>(row.class_index)].members.size());
  }
  return row;
}

void rank_names(Schedule& schedule, const Schedule* before) {
  const std::vector<std::string>& names = schedule.from->model->names;
  if (before != nullptr && before->from &&
      (before->from->model == schedule.from->model || before->from->model->names == names)) {
    for (std::size_t p = 0; p < names.size(); ++p) schedule.rows[p].name_rank = before->rows[p].name_rank;
    return;
  }
  std::vector<int> order(names.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return natural_name_less(names[static_cast<std::size_t>(a)], names[static_cast<std::size_t>(b)]);
  });
  for (std::size_t k = 0; k < order.size(); ++k)
    schedule.rows[static_cast<std::size_t>(order[k])].name_rank = static_cast<int>(k);
}

// What a column is ordered by.
double sort_value(const Schedule& schedule, const ScheduleRow& row, ScheduleColumn column) {
  switch (column) {
    case ScheduleColumn::Name:
      return row.name_rank;
    case ScheduleColumn::Corners:
      return row.corners;
    case ScheduleColumn::Area:
      return row.area;
    case ScheduleColumn::EdgeMin:
      return row.edge_min;
    case ScheduleColumn::EdgeMax:
      return row.edge_max;
    case ScheduleColumn::InteriorMin:
      return row.interior_min;
    case ScheduleColumn::BevelMax:
      return row.bevel_max;
    case ScheduleColumn::Planarity:
      return row.planarity;
    case ScheduleColumn::Distance:
      return row.distance;
    case ScheduleColumn::Weight:
      return row.weight;
    case ScheduleColumn::Size:
      return row.width;
    case ScheduleColumn::Class:
      return row.class_index < 0 ? kUnknown : row.class_index;
    case ScheduleColumn::Verdict:  // what passes first, then by the kind of the first failure
      break;
  }
  if (row.failure < 0) return -1;
  return static_cast<double>(schedule.from->verdicts.failures[static_cast<std::size_t>(row.failure)].kind);
}

void sort_panels(const Schedule& schedule, const ScheduleQuery& query, std::vector<int>& panels) {
  struct Key {
    double value;
    int rank, panel;
  };
  std::vector<Key> keys;
  keys.reserve(panels.size());
  for (const int panel : panels) {
    const ScheduleRow& row = schedule.row(panel);
    const double value = std::round(sort_value(schedule, row, query.sort) / kEqual) * kEqual;
    keys.push_back({std::isnan(value)  ? std::numeric_limits<double>::infinity()
                    : query.descending ? -value
                                       : value,
                    row.name_rank, panel});
  }
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return a.value != b.value ? a.value < b.value : a.rank < b.rank;
  });
  std::transform(keys.begin(), keys.end(), panels.begin(), [](const Key& key) { return key.panel; });
}

std::string measure_text(double value) {
  if (value > 0 && value < kLeastShown) return "<0.001";
  return format_number(value);
}

// Both so that they read as different.
std::pair<std::string, std::string> told_apart(double measured, double limit) {
  std::string m = format_number(measured), l = format_number(limit);
  for (int digits = 4; m == l && digits < 17; ++digits) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, measured);
    m = text.data();
    std::snprintf(text.data(), text.size(), "%.*g", digits, limit);
    l = text.data();
  }
  return {m, l};
}

std::string verdict_text(const Schedule& schedule, const ScheduleRow& row) {
  if (row.failure < 0) return "pass";
  const ToleranceFailure& failure = schedule.from->verdicts.failures[static_cast<std::size_t>(row.failure)];
  std::string text(tolerance_name(failure.kind));
  if (failure.kind != ToleranceKind::CrossesItself) {
    const auto [measured, limit] = told_apart(failure.measured, failure.limit);
    const std::string unit(tolerance_unit(failure.kind));
    text += " " + measured + (failure.measured < failure.limit ? " < " : " > ") + limit +
            (unit == "°" ? "" : " ") + unit;
  }
  if (row.failures > 1) text += ", and " + format_count(row.failures - 1) + " more";
  return text;
}

// For a spreadsheet: no thousands' separators, no more digits than anyone can make.
std::string plain_number(double value) {
  if (!std::isfinite(value)) return "";
  std::array<char, 400> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 6);
  if (error != std::errc()) return "";
  std::string text(buffer.data(), end);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string copied_cell(const Schedule& schedule, int panel, ScheduleColumn column) {
  const ScheduleRow& row = schedule.row(panel);
  if (column == ScheduleColumn::Size) return plain_number(row.width) + '\t' + plain_number(row.height);
  if (column == ScheduleColumn::Class) return row.class_index < 0 ? "" : class_label(row.class_index);
  if (is_number(column)) return plain_number(sort_value(schedule, row, column));
  return cell_text(schedule, panel, column);
}

}  // namespace

const ScheduleColumnInfo& info(ScheduleColumn column) {
  return columns()[static_cast<std::size_t>(column)];
}

std::optional<ScheduleColumn> find_schedule_column(std::string_view name) {
  for (int c = 0; c < kScheduleColumns; ++c)
    if (const auto column = static_cast<ScheduleColumn>(c); info(column).name == name) return column;
  return std::nullopt;
}

bool is_number(ScheduleColumn column) {
  return column != ScheduleColumn::Name && column != ScheduleColumn::Class &&
         column != ScheduleColumn::Verdict;
}

Schedule make_schedule(std::shared_ptr<const PreparedWorkshop> from, const Schedule* before) {
  Schedule schedule;
  schedule.from = std::move(from);
  if (!schedule.from) return schedule;
  const auto count = static_cast<int>(schedule.from->passports.size());
  schedule.rows.reserve(static_cast<std::size_t>(count));
  for (int panel = 0; panel < count; ++panel) schedule.rows.push_back(row_of(*schedule.from, panel));
  const std::vector<ToleranceFailure>& failures = schedule.from->verdicts.failures;
  for (std::size_t i = 0; i < failures.size(); ++i) {
    ScheduleRow& row = schedule.rows[static_cast<std::size_t>(failures[i].panel)];
    if (row.failure < 0) row.failure = static_cast<int>(i);
    ++row.failures;
  }
  const auto known = [&](double ScheduleRow::*measure) {
    return std::any_of(schedule.rows.begin(), schedule.rows.end(),
                       [&](const ScheduleRow& row) { return !std::isnan(row.*measure); });
  };
  schedule.distances = known(&ScheduleRow::distance);
  schedule.weights = known(&ScheduleRow::weight);
  schedule.classes = !schedule.from->class_of_panel.empty();
  rank_names(schedule, before);
  return schedule;
}

std::string class_label(int class_index) {
  return std::to_string(class_index + 1);
}

std::string cell_text(const Schedule& schedule, int panel, ScheduleColumn column) {
  const ScheduleRow& row = schedule.row(panel);
  switch (column) {
    case ScheduleColumn::Name:
      return schedule.name(panel);
    case ScheduleColumn::Corners:
      return format_count(row.corners);
    case ScheduleColumn::Size:
      return format_number(row.width) + " × " + format_number(row.height);
    case ScheduleColumn::Class:
      return row.class_index < 0 ? "–" : class_label(row.class_index) + " ×" + format_count(row.class_size);
    case ScheduleColumn::Verdict:
      return verdict_text(schedule, row);
    default:
      return measure_text(sort_value(schedule, row, column));
  }
}

ScheduleList make_schedule_list(const Schedule& schedule, const ScheduleQuery& query,
                                const std::vector<bool>& selected) {
  ScheduleList list;
  if (!schedule.from) return list;
  ScheduleFilter filter = parse_schedule_filter(query.filter, schedule);
  list.filter_error = std::move(filter.error);
  list.panels.reserve(schedule.rows.size());
  std::vector<bool> class_seen(schedule.from->classes.size(), false);
  double weight = 0;
  for (int panel = 0; panel < schedule.size(); ++panel) {
    const ScheduleRow& row = schedule.row(panel);
    if (query.only_failing && row.failure < 0) continue;
    const auto p = static_cast<std::size_t>(panel);
    if (query.only_selected && (p >= selected.size() || !selected[p])) continue;
    if (!matches(filter, schedule, panel)) continue;
    list.panels.push_back(panel);
    list.area += row.area;
    weight += row.weight;
    if (row.class_index < 0) continue;
    const auto c = static_cast<std::size_t>(row.class_index);
    if (!class_seen[c]) ++list.classes;
    class_seen[c] = true;
  }
  if (schedule.weights && !std::isnan(weight)) list.weight = weight;
  sort_panels(schedule, query, list.panels);
  return list;
}

std::string sum_text(const Schedule& schedule, const ScheduleList& list) {
  const std::string between = "  ·  ";
  std::string text = list.size() == schedule.size() ? format_count(list.size(), "panel", "panels")
                                                    : format_count(list.size()) + " of " +
                                                          format_count(schedule.size(), "panel", "panels");
  text += between + format_with_unit(list.area, "m²");
  if (list.weight) text += between + format_with_unit(*list.weight, "kg");
  if (schedule.classes) text += between + format_count(list.classes, "class", "classes");
  return text;
}

std::string copied_text(const Schedule& schedule, const ScheduleList& list) {
  std::string text;
  const auto line = [&](const auto& cell) {
    for (int c = 0; c < kScheduleColumns; ++c) {
      const auto column = static_cast<ScheduleColumn>(c);
      if (column == ScheduleColumn::Weight && !schedule.weights) continue;
      if (c > 0) text += '\t';
      text += cell(column);
    }
    text += '\n';
  };
  line([](ScheduleColumn column) { return info(column).key; });
  for (const int panel : list.panels)
    line([&](ScheduleColumn column) { return copied_cell(schedule, panel, column); });
  return text;
}

}  // namespace planewright::ui
