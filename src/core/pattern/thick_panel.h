// ThickPanel: a panel with thickness, mitred against its neighbours, as a closed solid.
//
// The outer face lies in the panel's plane, the inner face `thickness` behind it (against the normal). Each
// side lies in a mitre plane: through the panel edge, halving the angle between both panels, moved by half
// the joint gap into the panel; border sides are square to the panel and not moved. So solids of neighbours
// are parted by the mitre plane of their edge, whatever the valence of its ends; at a corner of valence 3 the
// mitre planes share a line and inner corners of the three solids meet exactly ([Z 3]: what a hexagonal dual
// is good for).
//
// Inner corners are where the mitre planes of two sides meet the inner plane. Blunted, and named:
//   Spike: the inner corner lies farther than kBluntAt thicknesses from its outer corner: it is cut off, a
//          triangle goes from the outer corner to the two points where the cut meets the mitre planes (the
//          feet of the outer corner on both inner sides, which neighbours share). Only what sticks out is
//          cut: a corner that lies so far *inside* the panel, and a notch, are named and stay, as every
//          blunting may only take away from what the mitre planes enclose. A reflex corner that moves along
//          one of its sides is cut as well, at the border and where more than three panels meet however near
//          it lies: else the other side would run on beyond that side's mitre plane.
//   LostSide: a side has no length left on the inner face (short edge, steep bevel): the sides beside it meet
//          in one point and the side's face is a triangle. With a gap that can be the outer face's, too.
// Refused, and named: Collapsed: nothing simple is left of the inner or the outer face, or a neighbour is
// folded onto the panel; Crosses: the outline crosses itself. Those have no solid. Units: mm, relative to the
// model's origin. Indices 0-based. Threads: pure.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/workshop/workshop_model.h"

namespace planewright {

inline constexpr double kBluntAt = 3.0;  // thicknesses

struct ThicknessSettings {
  double thickness = 0.0;  // mm, > 0
  double gap = 0.0;        // mm, between neighbours, square to the mitre plane, >= 0
};

enum class ThicknessTrouble { Spike, LostSide, Collapsed, Crosses };

struct ThicknessFinding {
  int panel;
  ThicknessTrouble trouble;
  int corner = -1;         // Spike: the corner; LostSide: where the side begins; else -1
  double wanted = 0.0;     // Spike: how far the inner corner would be, mm
  bool cut = true;         // Spike: false: it stays where it is, inside the panel
  double thickness = 0.0;  // mm, of the settings
};

struct ThickPanel {
  int panel = -1;
  Points points;  // outer corners first, then inner, mm; both counter-clockwise seen from outside the panel
  int outer = 0;  // number of outer corners
  // Faces, counter-clockwise seen from outside the solid: [0] the outer face, [1] the inner, then the sides.
  // Closed: each directed edge once, its reverse once. Empty: the panel has no solid.
  Polygons faces;
  // #faces: the side of the panel that a face belongs to; -1: outer, inner, or cut off a spike.
  std::vector<int> side_of_face;
  bool empty() const { return faces.empty(); }
};

struct ThickPanels {
  std::vector<ThickPanel> panels;          // #P
  std::vector<ThicknessFinding> findings;  // by panel
};

// Refused (ErrorCode::Refused, with the remedy): thickness not above 0 or not finite, gap negative.
Result<ThickPanels> thicken(const WorkshopModel& model, const ThicknessSettings& settings);

// "C-17: the inner corner 3 would lie 81 mm away (thickness 20 mm) and is cut off"
std::string describe(const ThicknessFinding& finding, const WorkshopModel& model);

// Pairs of panels (first < second, ascending) whose solids penetrate each other by more than `tolerance` mm;
// touching is none. Depth: by how far their hulls overlap, at least, and, where those overlap, how far two of
// their triangles have to move apart (diagnose/crossings.h) or how deep one solid lies within the other.
std::vector<std::pair<int, int>> penetrating_solids(const ThickPanels& solids, double tolerance = 1e-6);

}  // namespace planewright
