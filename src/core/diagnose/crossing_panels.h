// Panels that penetrate others of their own layer ([Z 3], inset: "intersections of the dual structure with
// itself"), and panels that lie over a neighbour.
//
// A pair that crosses, by the exact test of crossings.h, is FoldedOver if the two have a corner in common,
// else CrossingPanels; measure: the smallest move that parts their triangles, mean edges. A panel that is
// turned over (its outline runs clockwise, or its plane faces the design's other side) lies over its
// neighbours even where no two penetrate: FoldedOver without a second; measure: the side of a square of its
// area, mean edges. Panels that cross themselves are another finding.
//
// Threads: pure.
#pragma once

#include <vector>

#include "core/diagnose/finding.h"
#include "core/diagnose/subject.h"

namespace planewright {

// Of pairs, those deeper than `threshold` mean edges of its kind, settings[FoldedOver] and
// settings[CrossingPanels]; kinds that are off are left out. settings.planar: how exact the planes are.
// Ascending by pair; panels that are turned over come first.
std::vector<Finding> find_crossing_panels(const Subject& subject, const FindingSettings& settings);

}  // namespace planewright
