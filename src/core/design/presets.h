// Presets: sets of weights and demands for one purpose, named by what they do, so that a designer begins with
// a result and not with a row of sliders. Weights: unit-free (problem/energy.h), only their ratios matter.
// Threads: constant data.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/design/layer_settings.h"

namespace planewright {

struct Preset {
  std::string name;         // "smooth-shell": the key of the command line and of reports
  std::string label;        // "Smooth shell"
  std::string description;  // one sentence for a designer
  std::string source;       // paper section or figure; "ours"
  bool for_dual, for_planarize, for_cluster;
  std::map<std::string, double> weights;  // of all energies: one that is missing is 0
  std::vector<Demand> demands;            // switched on; others stay as they are
  bool fits(ComplexKind mode) const {
    return mode == ComplexKind::Dual        ? for_dual
           : mode == ComplexKind::Planarize ? for_planarize
                                            : for_cluster;
  }
};

// In the order in which the window and messages list them.
const std::vector<Preset>& presets();

// Fails with ErrorCode::Usage and the known names.
Result<const Preset*> find_preset(const std::string& name);

// Replaces the weights by the preset's, and switches its demands on. Fails with ErrorCode::Usage, with
// nothing changed, where the preset does not fit settings.mode; the ones that do are listed.
Result<void> apply(const Preset& preset, LayerSettings& settings);

// Adds a demand, or replaces the one of the same name and selection.
void set_demand(std::vector<Demand>& list, Demand demand);

}  // namespace planewright
