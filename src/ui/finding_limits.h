// Limits from which on a place is a finding, as the designer sets them and the window remembers them: those
// that differ from the kinds' own, by FindingKindInfo::name.
//
// Units: those of each kind (info(kind).unit). Threads: pure functions.
#pragma once

#include <map>
#include <string>

#include "core/diagnose/finding.h"

namespace planewright::ui {

using FindingLimits = std::map<std::string, double>;

// Names that are not known and numbers that are none, or negative, are left out.
FindingSettings with_limits(const FindingLimits& limits);
FindingLimits limits_of(const FindingSettings& settings);

// How a limit is shown: the number times `scale`, with a unit that fits into a field.
struct LimitLook {
  std::string unit;        // "edges", "°", "%"
  double scale = 1.0;      // 100 for "%"
  double per_pixel = 0.0;  // of a drag, as shown
  std::string tooltip;     // what it is about, and what resets it
};
LimitLook limit_look(FindingKind kind, double threshold);

}  // namespace planewright::ui
