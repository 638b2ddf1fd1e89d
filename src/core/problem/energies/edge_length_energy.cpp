#include "core/problem/energies/edge_length_energy.h"

#include "core/problem/energies/length_rows.h"

namespace planewright {

std::unique_ptr<Energy> make_edge_length_energy(const EnergyContext& context) {
  std::vector<std::array<int, 2>> edges;
  for (const PanelEdge& edge : context.complex.panel_edges) edges.push_back({edge.a, edge.b});
  return std::make_unique<LengthRows>("edge-length", context, edges);
}

}  // namespace planewright
