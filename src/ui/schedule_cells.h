// The cells of the schedule's table: how wide columns are at first, their titles, and what stands in a row.
//
// Threads: the window's, inside a Dear ImGui frame and an open table. Units: pixels.
#pragma once

#include "ui/layout.h"
#include "ui/schedule.h"
#include "ui/widgets.h"

namespace planewright::ui {

float cell_padding(const Ui& ui);  // left and right of a cell's text
float column_width(const Ui& ui, ScheduleColumn column);
float title_height(const Ui& ui);  // two lines: title, unit

// A column's title in the present cell; true when it is clicked.
bool draw_column_title(Ui& ui, ScheduleColumn column, bool sorted, bool descending);
// The text of a cell; `cell` without its padding.
void draw_cell(const Ui& ui, const Schedule& schedule, int panel, ScheduleColumn column, const Rect& cell);

}  // namespace planewright::ui
