// Schedules: all passports as a table (CSV) and as JSON. Threads: pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/flat_pattern.h"
#include "core/pattern/nesting.h"
#include "core/workshop/congruence.h"
#include "core/workshop/panel_passport.h"
#include "core/workshop/tolerance_sheet.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

struct ScheduleSources {
  const WorkshopModel* model;  // none may be null but where said
  const std::vector<PanelPassport>* passports;
  const ToleranceVerdicts* verdicts;
  const std::vector<CongruenceClass>* classes;
  const std::vector<FlatPattern>* patterns = nullptr;
  const Nesting* nesting = nullptr;
  const ThickPanels* solids = nullptr;
  double thickness = 0.0, gap = 0.0;  // mm
};

// RFC 4180, comma, CRLF, UTF-8 without mark, a header line; units in the column names ("area_m2"). One line
// per panel: name, number, class, mirrored, corners, area_m2, perimeter_mm, width_mm, height_mm,
// planarity_mm, distance_mm, weight_kg, sheet (1-based), verdict, failures.
std::string format_panel_csv(const ScheduleSources& sources);
// One line per panel and side: panel, side (1-based), neighbour, length_mm, interior_deg, dihedral_deg,
// bevel_deg.
std::string format_edge_csv(const ScheduleSources& sources);
// Everything, with corners in mm (17 digits), and what names were given to which panel number.
std::string format_schedule_json(const ScheduleSources& sources);

// The names of an earlier schedule: WorkshopOptions::kept_names. Fails with ErrorCode::Unreadable.
Result<std::vector<std::pair<int, std::string>>> read_kept_names(std::string_view json,
                                                                 const std::string& name);

}  // namespace planewright
