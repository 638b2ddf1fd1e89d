// Solids that penetrate each other, found without the code that made them. Internal to certify/.
//
// A pair is apart if a plane has one on either side, decided by exact predicates: the mitre plane of an edge
// that both share, or a face's plane of either, moved by the tolerance. What no plane parts has its triangles
// tested against each other (find_crossings) and, if none cross, the middles of faces for being inside the
// other. Units:
// mm. Threads: pure.
#pragma once

#include <utility>
#include <vector>

#include "core/pattern/thick_panel.h"

namespace planewright {

struct SolidPairs {
  std::vector<std::pair<int, int>> penetrating;  // panels, ascending
  long long parted_by_mitre = 0, parted_by_face = 0, tested = 0;
};

SolidPairs examine_pairs(const WorkshopModel& model, const ThickPanels& solids, double tolerance);

}  // namespace planewright
