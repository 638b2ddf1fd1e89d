// WorkshopModel: finished panels as a workshop sees them: millimetres, names, and who is whose neighbour.
// What tolerances, passports, flat patterns, files and their certificate are all made from.
//
// Made once from panels (of a solve, or of a file) and immutable; share it as shared_ptr<const>.
// Units: mm, relative to `origin`, so that a model far from 0 loses no digits. Angles in degrees where a name
// says so, else radians. Indices: 0-based; side k of a panel runs from its corner k to its corner k+1.
// "Outside" is where a panel's normal points. Threads: plain data.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/workshop/length_unit.h"

namespace planewright {

enum class NameStyle {
  RowLetter,  // "C-17": rows by height from below (A, B, ... Z, AA, ...), numbered round each row
  Plain,      // "17": the panel's number, 1-based
};

// An edge of the structure. `left` has its sides a -> b, `right` b -> a; -1: none there (border).
struct WorkshopEdge {
  int a, b;
  int left, right;
  int left_side, right_side;  // which side of that panel; -1: none
  bool border() const { return left < 0 || right < 0; }
};

struct WorkshopModel {
  std::string title;                          // of the design: "train-station"
  LengthUnit model_unit = LengthUnit::Metre;  // of the document that it came from
  // mm: the middle of the panels, rounded so that taking it off costs no digits.
  Vector3d origin = Vector3d::Zero();
  Vector3d up = Vector3d::UnitZ();    // unit
  Points points;                      // #X x 3, mm
  Polygons panels;                    // #P lists of points
  Points normals;                     // #P x 3, unit, outside; a panel without area: its neighbours' mean
  Vector plane_offsets;               // #P: plane i is { x : normals_i . x = plane_offsets_i }, mm
  std::vector<int> numbers;           // #P, the document's number of each panel (PanelNumbers)
  std::vector<std::string> names;     // #P, unique; ours: letters, digits, '-'; kept: '_', '.', too
  std::vector<WorkshopEdge> edges;    // ordered by their first panel and side
  Polygons edges_of_panel;            // #P lists, the edge of each side
  std::vector<std::string> warnings;  // what was odd about the panels (edges of three panels, ...)

  int panel_count() const { return panels.size(); }
  // The panel on the other side of side k; -1: border.
  int neighbour(int panel, int side) const;
};

struct WorkshopOptions {
  std::string title;
  LengthUnit unit = LengthUnit::Metre;  // of the points given
  NameStyle names = NameStyle::RowLetter;
  Vector3d up = Vector3d::UnitZ();
  // #P or empty (0, 1, ...): the document's panel numbers.
  std::vector<int> numbers;
  // Names that are kept, by panel number (an earlier export's schedule); others get names that none of these
  // has.
  std::vector<std::pair<int, std::string>> kept_names;
};

// points: #X x 3, model units; panels: lists into them, counter-clockwise seen from outside. Planes are the
// panels' own least-squares planes. An edge of more than two panels, or of two that run the same way, becomes
// border for each of them, with a warning. Refused: no panels, a panel of fewer than three corners, with a
// corner twice or one that there is not, coordinates that are not finite or beyond 1e100 mm, an `up` without
// direction, numbers that are not #P, negative or not each once, two kept names that are the same (case
// apart; both numbers are named) or of the same number, a kept name that is empty or has other characters
// than letters, digits, '-', '_' and '.'. Errors say "panel N" with the document's number.
Result<std::shared_ptr<const WorkshopModel>> make_workshop_model(const Points& points, const Polygons& panels,
                                                                 const WorkshopOptions& options);

}  // namespace planewright
