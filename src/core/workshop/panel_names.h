// Names of panels for people: stable, short, sortable, each once.
//
// Rows are bands of height: panels are sorted by the height of their middle along `up`, and bands are as high
// as a panel is (the mean extent of panels along `up`; flat models, where that is less than half a panel's
// size, are cut into rows along the longer horizontal axis instead). Inside a row panels are numbered 1, 2,
// ... : round the vertical axis through the model's middle where the row goes round it, else along its
// longer horizontal direction. Numbers have as many digits as the longest row needs ("C-07"). Threads: pure.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

// #P names. points: #X x 3 and up: mm. numbers: #P. kept: names by panel number, which win; the others get
// names that are not among them. Fails as make_workshop_model says.
Result<std::vector<std::string>> name_panels(const Points& points, const Polygons& panels, const Vector3d& up,
                                             NameStyle style, const std::vector<int>& numbers,
                                             const std::vector<std::pair<int, std::string>>& kept);

}  // namespace planewright
