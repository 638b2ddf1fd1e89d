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
  Vector3d origin = Vector3d::Zero();         // mm
  Vector3d up = Vector3d::UnitZ();            // unit
  Points points;                              // #X x 3, mm
  Polygons panels;                            // #P lists of points
  Points normals;                     // #P x 3, unit, outside; a panel without area: its neighbours' mean
  Vector plane_offsets;               // #P: plane i is { x : normals_i . x = plane_offsets_i }, mm
  std::vector<int> numbers;           // #P, the document's number of each panel (PanelNumbers)
  std::vector<std::string> names;     // #P, unique, letters, digits and '-' alone
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
// border for each of them, with a warning. Refused: no panels, a panel of fewer than three corners or with a
// corner twice, coordinates that are not finite, two kept names that are the same (both numbers are named), a
// kept name with other characters than letters, digits, '-', '_' and '.'.
Result<std::shared_ptr<const WorkshopModel>> make_workshop_model(const Points& points, const Polygons& panels,
                                                                 const WorkshopOptions& options);

}  // namespace planewright
