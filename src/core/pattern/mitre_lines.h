// Where the planes that bound a panel's sides meet planes parallel to the panel: lines, in the panel's frame.
//
// Units: mm. Threads: pure.
#pragma once

#include <optional>
#include <vector>

#include "core/pattern/panel_frame.h"

namespace planewright {

// { s : normal . s = offset }; normal: unit, out of the panel. A side without length has no line: normal 0.
struct SideLine {
  Vector2d normal;
  double offset;

  bool exists() const { return normal.squaredNorm() > 0.5; }
  Vector2d along() const { return {-normal.y(), normal.x()}; }  // as the side runs
  Vector2d foot(const Vector2d& of) const { return of - (normal.dot(of) - offset) * normal; }
};

// The lines of the panel's outline. Sides shorter than 1e-9 of it have none.
std::vector<SideLine> outline_lines(const std::vector<Vector2d>& corners);

// Each inner side's outline line moved into the panel by half the gap; border sides stay.
std::vector<SideLine> gap_lines(const WorkshopModel& model, int panel, const std::vector<Vector2d>& corners,
                                double gap);

// Mitre planes of the panel's sides (thick_panel.h), moved by half the gap, at `depth` behind the panel.
// None: a neighbour is folded onto the panel, so that their mitre plane is that of the panel and meets no
// other one.
std::optional<std::vector<SideLine>> mitre_lines(const WorkshopModel& model, int panel,
                                                 const PanelFrame& frame,
                                                 const std::vector<Vector2d>& corners, double gap,
                                                 double depth);

}  // namespace planewright
