#include "ui/finding_limits.h"

#include <cmath>

#include "ui/finding_text.h"
#include "ui/format.h"

namespace planewright::ui {

FindingSettings with_limits(const FindingLimits& limits) {
  FindingSettings settings;
  for (const auto& [name, limit] : limits) {
    const auto kind = find_finding_kind(name);
    if (kind && std::isfinite(limit) && limit >= 0.0) settings[*kind].threshold = limit;
  }
  return settings;
}

FindingLimits limits_of(const FindingSettings& settings) {
  FindingLimits limits;
  for (const FindingKind kind : all_finding_kinds()) {
    if (settings[kind].threshold != info(kind).threshold) limits[info(kind).name] = settings[kind].threshold;
  }
  return limits;
}

LimitLook limit_look(FindingKind kind, double threshold) {
  LimitLook look;
  const std::string unit = info(kind).unit;
  std::string own = format_number(info(kind).threshold);
  if (unit == "edges") {
    look.unit = "edges";
    look.per_pixel = 0.005;
    look.tooltip = "in mean panel edges";
    own += " edges";
  } else if (unit == "edges per degree") {
    // 0 stands for what the design's own corners have.
    look.unit = threshold == 0.0 ? "design's own" : "edges/°";
    look.per_pixel = 0.1;
    look.tooltip =
        "how far a corner moves per degree of tilt of a panel, in mean panel edges; 0: from the "
        "design's own corners on";
  } else if (unit == "degrees") {
    look.unit = "°";
    look.per_pixel = 0.1;
    look.tooltip = "in degrees";
    own += "°";
  } else {
    look.unit = "%";
    look.scale = 100.0;
    look.per_pixel = 0.5;
    look.tooltip = "in percent " + unit;
    own = format_number(100.0 * info(kind).threshold) + " %";
  }
  look.tooltip = kind_title(kind) + ": the limit, " + look.tooltip + ". Double click: back to " + own + ".";
  return look;
}

}  // namespace planewright::ui
