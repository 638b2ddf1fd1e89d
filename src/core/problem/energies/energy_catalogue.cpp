#include "core/problem/energies/energy_catalogue.h"

#include "core/problem/energies/closeness_energy.h"
#include "core/problem/energies/corner_angle_energy.h"
#include "core/problem/energies/diagonal_length_energy.h"
#include "core/problem/energies/edge_direction_energy.h"
#include "core/problem/energies/edge_length_energy.h"
#include "core/problem/energies/fairing_energy.h"
#include "core/problem/energies/normal_smoothness_energy.h"
#include "core/problem/energies/offset_energy.h"
#include "core/problem/energies/position_energy.h"
#include "core/problem/energies/proxy_normal_energy.h"

namespace planewright {

const std::vector<EnergyInfo>& energy_catalogue() {
  static const std::vector<EnergyInfo> catalogue = {
      {"position", "Position", "Keeps every corner near its wanted place on the design surface.", "2.1", 1.0,
       make_position_energy},
      {"fairing", "Fairing", "Draws every corner to the mean of its neighbours: even, regular panels.", "4.3",
       0.0, make_fairing_energy},
      {"edge-length", "Edge length", "Keeps every panel edge as long as on the design surface.", "4.1", 0.0,
       make_edge_length_energy},
      {"diagonal-length", "Diagonal length",
       "Keeps the diagonals of every panel as long as on the design surface: with edge length, its shape.",
       "4.1", 0.0, make_diagonal_length_energy},
      {"edge-direction", "Edge direction", "Keeps every panel edge parallel to itself on the design surface.",
       "4.1", 0.0, make_edge_direction_energy},
      {"normal-smoothness", "Normal smoothness",
       "Turns neighbouring panels alike: a rounder shell without sharp creases.", "4.3", 0.0,
       make_normal_smoothness_energy},
      {"proxy-normal", "Proxy normal", "Keeps every panel facing the way the design surface does there.",
       "4.2", 0.0, make_proxy_normal_energy},
      {"offset", "Offset", "Keeps every panel at the layer's offset from the design surface.", "2.4", 0.0,
       make_offset_energy},
      {"closeness", "Closeness",
       "Keeps every corner at the layer's offset from the reference surface, but lets it slide along it.", "",
       0.0, make_closeness_energy},
      {"corner-angle", "Corner angle",
       "Blunts corners of panels that are sharper than 45 degrees, and lengthens edges next to no length.",
       "", 0.0, make_corner_angle_energy},
  };
  return catalogue;
}

Result<const EnergyInfo*> find_energy(const std::string& name) {
  std::string known;
  for (const EnergyInfo& info : energy_catalogue()) {
    if (info.name == name) return &info;
    known += (known.empty() ? "" : ", ") + info.name;
  }
  return fail(ErrorCode::Usage, "there is no energy of the name '" + name + "'", "weights",
              "Known: " + known);
}

}  // namespace planewright
