#include "core/problem/energies/energy_catalogue.h"

#include "core/problem/energies/fairing_energy.h"
#include "core/problem/energies/position_energy.h"

namespace planewright {

const std::vector<EnergyInfo>& energy_catalogue() {
  static const std::vector<EnergyInfo> catalogue = {
      {"position", "Position", "Keeps every corner near its wanted place on the design surface.", "2.1", 1.0,
       make_position_energy},
      {"fairing", "Fairing", "Draws every corner to the mean of its neighbours: even, regular panels.", "4.3",
       0.0, make_fairing_energy},
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
