// The catalogue of energies: one entry per energy file, in the order in which the window and reports list
// them. A new energy is its own small file and one line here.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

struct EnergyInfo {
  std::string name;         // "position": the key of weights, reports and the command line
  std::string label;        // "Position"
  std::string description;  // one sentence for a designer
  std::string source;       // paper section; empty: not from the paper
  double default_weight;
  std::unique_ptr<Energy> (*make)(const EnergyContext& context);
};

const std::vector<EnergyInfo>& energy_catalogue();

// Fails with ErrorCode::Usage and the known names.
Result<const EnergyInfo*> find_energy(const std::string& name);

}  // namespace planewright
