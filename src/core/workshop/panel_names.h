// Names of panels for people: stable, short, sortable, each once.
//
// Rows are bands of height: panels are sorted by the height of their middle along `up`, and bands are as high
// as the panels that they begin among are; a gap of more than half of that between the middles parts rows,
// too, so that regular rows stay rows. Flat models (their panels' mean slope, by area, is below 30 degrees)
// are cut into rows along the longer horizontal axis instead. Inside a row panels are numbered 1, 2, ... :
// where the row goes round the vertical axis through the model's middle, round it, anticlockwise seen from
// above (so to the right, seen from outside), of rings inside one another the outer first; else along the
// longer horizontal direction, for a facade from left to right seen from outside. Numbers have as many digits
// as the longest row needs ("C-07"). Names are the same in every unit of length. Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

// #P names. points: #X x 3 and up: mm. numbers: #P, each once. kept: names by panel number, which win; the
// others get names that are not among them: their own if it is free, else the next of their row. Names that
// differ in case alone count as the same, because blocks of drawings and files do. Kept names of panels that
// are no longer there are not given again. Fails as make_workshop_model says.
Result<std::vector<std::string>> name_panels(const Points& points, const Polygons& panels, const Vector3d& up,
                                             NameStyle style, const std::vector<int>& numbers,
                                             const std::vector<std::pair<int, std::string>>& kept);

// "A", "B", ... "Z", "AA", ... of row 0, 1, ...
std::string row_letters(int row);

// The order of a schedule: "A-2" before "A-10", "Z-1" before "AA-1". Runs of digits count as numbers, of runs
// of letters the shorter is first. Strict and total: of names that are equal so far, by characters.
bool natural_name_less(std::string_view a, std::string_view b);

}  // namespace planewright
