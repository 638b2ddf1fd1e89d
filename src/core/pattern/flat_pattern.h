// FlatPattern: a panel laid flat, isometrically, seen from outside: what is cut from a sheet.
//
// Frame: x, y in the panel's plane, y as near to "up" as the plane allows (panels that lie flat: the model's
// +y, then +x), so that the up mark points to +y; the box of `cut` begins at (0, 0). Units: mm. Threads:
// pure.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/pattern/thick_panel.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

// One point per row, mm; closed, counter-clockwise.
using Contour = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

double signed_area(const Contour& contour);  // mm^2, > 0 counter-clockwise

struct FlatPattern {
  int panel = -1;
  Contour nominal;  // the panel's own corners, no gap: its lengths and area are those of the model
  Contour outer;    // the outer face with the gap; as nominal without thickness or gap
  Contour inner;    // the inner face of a mitred panel; empty without thickness
  // What a square cut has to leave, so that outer and inner can be made of it both. Without thickness: outer.
  // With: the outline of their union; where neither contains the other its corners are rounded to 1e-6 mm,
  // except those of outer and inner themselves.
  Contour cut;
  // The side of the panel that each segment of outer begins (segment k runs from its point k to k+1); -1: a
  // cut.
  std::vector<int> side_of_segment;
  Eigen::Vector2d up = Eigen::Vector2d::UnitY();  // unit, the projection of the model's up
  bool lies_flat = false;                         // up is square to the panel: no up mark means anything
  // The point inside outer and inner that is farthest from both (pole of inaccessibility), to 1 % of its
  // distance; where outer and inner have nothing in common: that of outer alone.
  Eigen::Vector2d label = Eigen::Vector2d::Zero();
  double label_room = 0.0;  // mm, its distance from the nearest contour
  // From flat to model coordinates (mm, relative to model.origin): p = frame * (x, y, 0).
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  bool empty() const { return cut.rows() == 0; }  // the panel crosses itself or collapsed: no pattern
};

// #P. solids: of the same model, or null for sheets without thickness, where gap (mm) is halved along each
// inner side. Panels without solid (findings of `solids`), that cross themselves or of which the gap leaves
// nothing have `nominal` alone.
std::vector<FlatPattern> flatten(const WorkshopModel& model, const ThickPanels* solids, double gap = 0.0);

}  // namespace planewright
