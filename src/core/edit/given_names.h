// GivenNames: what panels were called when they left for the workshop. A name that stands on a drawing, or on
// a cut panel, stays that panel's for ever; so it is kept by panel number, and undo does not take it back.
//
// Panels are numbered per series: layers of one kind share their numbers (PanelNumbers), so panel 17 of the
// outer and of the inner layer have the same name. Threads: plain values.
#pragma once

#include <compare>
#include <map>
#include <string>

#include "core/base/result.h"
#include "core/design/layer_settings.h"

namespace planewright {

struct PanelSeries {
  ComplexKind kind = ComplexKind::Dual;
  BorderPolicy border = BorderPolicy::Closed;  // Closed unless a dual: only there it decides the numbers
  auto operator<=>(const PanelSeries&) const = default;
};
PanelSeries panel_series(const LayerSettings& settings);

using GivenNames = std::map<PanelSeries, std::map<int, std::string>>;  // by panel number

// Refuses what no drawing can bear: a negative number, a name that is empty, has other characters than
// letters, digits, '-', '_' and '.', or stands there twice.
Result<void> check_names(const std::map<int, std::string>& names);

// Adds names, over earlier ones of the same numbers. Refused, with nothing changed: as check_names() of what
// results.
Result<void> add_names(GivenNames& given, const PanelSeries& series, const std::map<int, std::string>& names);

}  // namespace planewright
