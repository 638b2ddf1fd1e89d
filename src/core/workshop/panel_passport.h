// PanelPassport: all that a workshop wants to know of one panel, measured on the panel itself.
//
// Units: mm, mm^2, kg, degrees. Threads: pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/mesh/closest_point.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

struct SidePassport {
  int neighbour = -1;   // panel; -1: border
  double length = 0.0;  // mm
  // Degrees, at the corner where the side begins, 0..360, more than 180 at a reflex corner. A side without
  // length begins at 180: the corner is told where the next side begins.
  double interior = 0.0;
  // Between the outsides of both panels, degrees: 180 flat, less than 180 a valley seen from outside, more a
  // ridge. Border: 180.
  double dihedral = 180.0;
  // By how much the mitred edge leans from square to the panel, degrees: half of what dihedral has over
  // 180. Positive (a ridge): the inner face is smaller than the outer. Border: 0 (cut square).
  double bevel = 0.0;
};

struct PanelPassport {
  int panel = -1;
  double area = 0.0;       // mm^2 (Newell)
  double perimeter = 0.0;  // mm
  double planarity = 0.0;  // mm, greatest distance of a corner from the panel's plane
  double width = 0.0;      // mm, sides of the smallest rectangle round it, width >= height
  double height = 0.0;
  std::optional<double> distance;  // mm, farthest corner from the reference surface, unsigned
  std::optional<double> weight;    // kg: area x thickness x density, where both are known
  bool crosses_itself = false;
  std::vector<SidePassport> sides;
};

struct PassportOptions {
  double thickness = 0.0;                       // mm; 0: unknown
  double density = 0.0;                         // kg/m^3; 0: unknown
  const ReferenceSurface* reference = nullptr;  // model units (model.model_unit)
};

// #P, in the order of the panels.
std::vector<PanelPassport> make_passports(const WorkshopModel& model, const PassportOptions& options = {});

}  // namespace planewright
