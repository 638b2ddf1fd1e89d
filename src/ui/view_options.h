// What the designer chose to see, and what the left button does. Threads: plain values.
#pragma once

#include <optional>

#include "ui/failure_list.h"
#include "ui/prepared_findings.h"
#include "ui/suggestion_list.h"

namespace planewright::ui {

enum class ColourMap { None, Planarity, Displacement, Findings, Tolerances };
const char* name(ColourMap map);  // "none", "planarity", "displacement", "findings", "tolerances"

// Of a design of clusters: the input in its regions' colours, the panels, both side by side, or the panels as
// glass over the input.
enum class ClusterSight { Regions, Panels, Beside, Over };
const char* name(ClusterSight sight);  // "regions", "panels", "beside", "over"

// What the designer chose to see.
struct ViewOptions {
  ClusterSight cluster_sight = ClusterSight::Beside;
  bool ghost = true;
  bool markers = true;
  bool lock_range = false;  // keep the colour map's range as it is
  ColourMap colours = ColourMap::None;
  HiddenFindings hidden_findings;  // kinds that are neither listed nor marked
  HiddenEdits hidden_edits;        // kinds of suggestions that are neither listed nor applied together
  bool names = false;              // of the panels, on them
  std::optional<ToleranceKind> tolerance;  // that ColourMap::Tolerances is about; none: all of the sheet
  HiddenFailures hidden_failures;          // kinds that are not listed

  bool operator==(const ViewOptions&) const = default;
};

// What the left button does over the model: orbit and select; draw a box that selects; on regions: split the
// one that is clicked; merge the two beside a border, or what is clicked into the selected one; paint faces
// over to the region where a drag begins.
enum class Tool { Look, Box, Split, Merge, Paint };
const char* name(Tool tool);  // "look", "box", "split", "merge", "paint"
inline bool changes_regions(Tool tool) {
  return tool == Tool::Split || tool == Tool::Merge || tool == Tool::Paint;
}

}  // namespace planewright::ui
