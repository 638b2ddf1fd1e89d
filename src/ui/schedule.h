// Schedule: the panels as a table, one row per panel, for people who make them.
//
// The window's table is drawn from this: what each column holds, how it reads, in which order, which panels a
// filter leaves, and what they sum up to. Words and units are those of the schedules that are written as
// files (core/writers/schedule_writers.h).
// Units: mm, m², kg, degrees. What is not known is NaN, and reads "–". Indices: panels of the workshop model.
// Threads: plain values and pure functions.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/prepared_workshop.h"

namespace planewright::ui {

enum class ScheduleColumn {
  Name,
  Corners,
  Area,
  EdgeMin,
  EdgeMax,
  InteriorMin,
  BevelMax,
  Planarity,
  Distance,
  Weight,
  Size,
  Class,
  Verdict,
};
inline constexpr int kScheduleColumns = static_cast<int>(ScheduleColumn::Verdict) + 1;

struct ScheduleColumnInfo {
  std::string name;     // "shortest edge": in sentences and records
  std::string title;    // "Shortest": over the column
  std::string unit;     // "mm"; empty: none
  std::string key;      // "edge_min_mm": as a file's column is called
  std::string tooltip;  // what it is, in a sentence
};
const ScheduleColumnInfo& info(ScheduleColumn column);
std::optional<ScheduleColumn> find_schedule_column(std::string_view name);
bool is_number(ScheduleColumn column);

struct ScheduleRow {
  int corners = 0;
  double area = 0;                    // m²
  double edge_min = 0, edge_max = 0;  // mm
  double interior_min = 0;            // degrees
  double bevel_max = 0;               // degrees, the size of the largest
  double planarity = 0;               // mm
  double distance = 0;                // mm
  double weight = 0;                  // kg
  double width = 0, height = 0;       // mm
  int class_index = -1;               // -1: not known
  int class_size = 0;
  int failure = -1;   // the first of the sheet's verdicts on it; -1: passes
  int failures = 0;   // how many there are
  int name_rank = 0;  // in the natural order of all names
};

struct Schedule {
  std::shared_ptr<const PreparedWorkshop> from;              // null: nothing is known, and there are no rows
  std::vector<ScheduleRow> rows;                             // #P
  bool distances = false, weights = false, classes = false;  // known

  int size() const { return static_cast<int>(rows.size()); }
  const ScheduleRow& row(int panel) const { return rows[static_cast<std::size_t>(panel)]; }
  const std::string& name(int panel) const { return from->model->names[static_cast<std::size_t>(panel)]; }
};

// before: an earlier one, whose order of names is kept if they are the same; may be null.
Schedule make_schedule(std::shared_ptr<const PreparedWorkshop> from, const Schedule* before = nullptr);

// "1", "2", ...: as files have it.
std::string class_label(int class_index);

// A cell as the table shows it: "C-17", "1,753", "2.31", "12 ×3", "planarity 0.71 > 0.5 mm, and 2 more".
std::string cell_text(const Schedule& schedule, int panel, ScheduleColumn column);

// What is asked of the table.
struct ScheduleQuery {
  ScheduleColumn sort = ScheduleColumn::Name;
  bool descending = false;
  std::string filter;  // schedule_filter.h
  bool only_selected = false, only_failing = false;
  bool operator==(const ScheduleQuery&) const = default;
};

// The answer: panels in their order, and what these sum up to.
struct ScheduleList {
  std::vector<int> panels;
  double area = 0;               // m²
  std::optional<double> weight;  // kg; none: not known
  int classes = 0;
  std::string filter_error;  // what of the filter was not understood, and left aside; empty: nothing

  int size() const { return static_cast<int>(panels.size()); }
};

// selected: #P, or empty: none is. By the column, panels with equal values (to a millionth of the unit) by
// name; unknown values come last in either direction.
ScheduleList make_schedule_list(const Schedule& schedule, const ScheduleQuery& query,
                                const std::vector<bool>& selected);

// "12 of 162 panels  ·  30.4 m²  ·  912 kg  ·  7 classes"
std::string sum_text(const Schedule& schedule, const ScheduleList& list);
// The listed panels for a spreadsheet: columns parted by tabs, a header with units, numbers without
// thousands' separators. Weights are left out where they are not known.
std::string copied_text(const Schedule& schedule, const ScheduleList& list);

}  // namespace planewright::ui
