// WorkshopContract: what a document knows of the workshop: its unit, the tolerance sheet, and what panels are
// made of. Part of what undo goes back over and what a project file holds.
//
// Units: mm, kg/m^3. Threads: plain values.
#pragma once

#include "core/workshop/length_unit.h"
#include "core/workshop/tolerance_sheet.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

struct WorkshopContract {
  LengthUnit unit = LengthUnit::Metre;  // of the model's coordinates
  ToleranceSheet tolerances;
  double thickness = 0.0;  // mm; 0: sheets without thickness
  double gap = 0.0;        // mm, between neighbours
  double density = 0.0;    // kg/m^3; 0: unknown
  NameStyle names = NameStyle::RowLetter;
  bool operator==(const WorkshopContract&) const = default;
};

}  // namespace planewright
