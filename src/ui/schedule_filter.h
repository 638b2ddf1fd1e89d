// ScheduleFilter: a line of words that says which panels of a schedule are wanted. All of them have to hold:
//
//   C-1          in the name           to:C-17    beside that panel
//   fails        passes                class:12   of that class
//   area>2       edge<300      corners=6      planarity>=0.2      width!=1200 mm
//
// Capitals make no difference, nor do blanks round an operator. "edge" is any edge of the panel, "shortest"
// and "longest" are the columns. Two numbers are equal if they read the same in the table. Units: as the
// columns have them. Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/schedule.h"

namespace planewright::ui {

struct ScheduleTerm {
  enum class Kind { Name, Beside, Fails, Passes, Class, Compare };
  enum class Op { Less, LessEqual, Greater, GreaterEqual, Equal, Unequal };
  Kind kind = Kind::Name;
  std::string word;       // lower case: Name, Beside
  bool whole = false;     // Beside: the word is a whole name
  int class_index = -1;   // Class
  std::size_t measure{};  // Compare: which
  Op op{};
  double value = 0;
};

struct ScheduleFilter {
  std::vector<ScheduleTerm> terms;
  // Of the first word that could not be understood, why: "'edgy<3': columns are corners, area, ...". That
  // word is left aside, the others hold.
  std::string error;
};

ScheduleFilter parse_schedule_filter(std::string_view text, const Schedule& schedule);
bool matches(const ScheduleFilter& filter, const Schedule& schedule, int panel);

}  // namespace planewright::ui
