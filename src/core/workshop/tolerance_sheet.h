// ToleranceSheet: the contract, in millimetres: what a panel must keep to be built, and the verdict on each.
//
// A limit that is not set is not checked; nor is the distance of passports without one, nor the dihedral
// angle of a border. A measure on the limit passes, in whatever unit the document is: limits give way by what
// rounding makes of it (measure_slack.h). Units: mm, m^2, degrees. Threads: pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/workshop/panel_passport.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

struct SheetSize {
  double width = 0.0, height = 0.0;  // mm, either may be the longer
  bool operator==(const SheetSize&) const = default;
};

struct ToleranceSheet {
  std::optional<double> planarity = 0.5;             // mm, at most
  std::optional<double> distance;                    // mm from the reference surface, at most
  std::optional<double> edge_min, edge_max;          // mm
  std::optional<double> area_min, area_max;          // m^2
  std::optional<double> interior_min, interior_max;  // degrees
  std::optional<double> dihedral_min, dihedral_max;  // degrees, 180 is flat
  std::optional<SheetSize> stock;                    // the panel, turned as it likes, has to fit on it
  bool operator==(const ToleranceSheet&) const = default;
};

enum class ToleranceKind {
  Planarity,
  Distance,
  EdgeMin,
  EdgeMax,
  AreaMin,
  AreaMax,
  InteriorMin,
  InteriorMax,
  DihedralMin,
  DihedralMax,
  StockSize,
  CrossesItself,  // no panel may, whatever the sheet says
};

struct ToleranceFailure {
  int panel;
  ToleranceKind kind;
  int side = -1;  // of the panel (edges, dihedral) or the corner where it begins (interior); -1: panel
  // In the sheet's units of that kind. StockSize: the side of the panel's smallest rectangle that is too big
  // by more, and that side of the stock. CrossesItself: 1 and 0.
  double measured = 0.0, limit = 0.0;
};

struct ToleranceVerdicts {
  std::vector<ToleranceFailure>
      failures;                // by panel, then kind, then side; each side of each panel by itself
  std::vector<bool> pass;      // #P
  int passed = 0, failed = 0;  // panels
};

ToleranceVerdicts check_tolerances(const WorkshopModel& model, const std::vector<PanelPassport>& passports,
                                   const ToleranceSheet& sheet);

// "planarity", "edge length", ...: what a table calls it, and its unit ("mm", "m²", "°"; empty: none).
std::string_view tolerance_name(ToleranceKind kind);
std::string_view tolerance_unit(ToleranceKind kind);
// "C-17, side 3 (to C-18): edge length 24.1 mm is below 50 mm"
std::string describe(const ToleranceFailure& failure, const WorkshopModel& model);

// A sheet as JSON text ("planewright tolerances", keys with their units, absent: not checked), and back:
//   {"format": "planewright tolerances", "version": 1, "planarity_mm": 0.5, "edge_min_mm": 50,
//    "area_max_m2": 4, "interior_min_deg": 30, "dihedral_max_deg": 270, "stock_mm": [3210, 6000]}
// Fails with ErrorCode::Unreadable, naming `name`, the key and what is wrong with it: unknown keys (the
// nearest is named), keys that come twice, minimum above maximum, negative numbers, angles above 360.
std::string to_json(const ToleranceSheet& sheet);
Result<ToleranceSheet> read_tolerance_sheet(std::string_view json, const std::string& name);

}  // namespace planewright
