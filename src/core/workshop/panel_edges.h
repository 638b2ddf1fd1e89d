// Who is whose neighbour: edges of panels that share corners. Internal to workshop/. Threads: pure.
#pragma once

#include <string>
#include <vector>

#include "core/workshop/workshop_model.h"

namespace planewright {

struct PanelEdges {
  std::vector<WorkshopEdge> edges;  // as WorkshopModel has them
  Polygons of_panel;
  std::vector<std::string> warnings;
};

// names: #P, for the warnings.
PanelEdges find_panel_edges(const Polygons& panels, const std::vector<std::string>& names);

}  // namespace planewright
