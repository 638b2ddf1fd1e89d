// Laying patterns on stock sheets, by the no-fit polygons of libnest2d. Deterministic.
//
// Sheets are filled one after another with the parts that come next, so that neighbours lie near together; a
// part that does not fit the sheet any more waits for the next. Each sheet is filled in several ways (along
// its width, its height; parts turned by quarters from where their box is smallest), and the fullest is kept.
// Parts count as their convex hulls, so none lies in another's notch.
//
// Units: mm. The sheet's corner is (0, 0). Threads: pure.
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/pattern/flat_pattern.h"
#include "core/workshop/tolerance_sheet.h"

namespace planewright {

struct NestingOptions {
  SheetSize sheet{3210.0, 6000.0};
  double spacing = 10.0;  // between parts
  double margin = 10.0;   // along the sheet's border
  bool rotate = true;     // parts may be turned; false: up stays up (grain, coating, print)
};

struct PlacedPart {
  int panel;
  double rotation = 0.0;  // radians, counter-clockwise, first
  Eigen::Vector2d shift;  // mm, then
};
struct NestedSheet {
  std::vector<PlacedPart> parts;  // ascending by panel
  double filled = 0.0;            // area of the parts / area of the sheet, 0..1
};
struct Nesting {
  SheetSize sheet;
  std::vector<NestedSheet> sheets;
  std::vector<int> unplaced;  // panels that fit no sheet, ascending
  double filled = 0.0;        // over all sheets
  bool stopped = false;
};

// `cut` of each pattern that is not empty. progress(placed, total) may be null; when stopped, parts that
// were not placed are then neither on a sheet nor unplaced. Refused: a sheet without area, or whose margins
// leave nothing.
Result<Nesting> nest(const std::vector<FlatPattern>& patterns, const NestingOptions& options,
                     const std::function<void(int, int)>& progress = {}, const std::stop_token& stop = {});

}  // namespace planewright
