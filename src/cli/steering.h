// Steering: what a user says about how panels are wanted, on the command line for all layers or in a file of
// layers for one, and its way into a layer's settings.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/design/layer_settings.h"

namespace planewright::cli {

struct Steering {
  std::string preset;                     // empty: none
  std::map<std::string, double> weights;  // over the preset's
  // Besides those that are there; of the same name and selection: instead. Among themselves all hold, so that
  // two that contradict each other are found out.
  std::vector<Demand> demands;
  std::optional<bool> no_penetration;  // none: as for all layers
  std::optional<double> margin;
  std::optional<Side> side;
};

// Puts steering onto settings, whose mode is decided. Fails with ErrorCode::Usage: an unknown preset or one
// that does not fit the mode (the ones that do are listed), --no-penetration when planarizing. What it is to
// switch off must not be switched on before: demands stay where they are.
Result<void> steer(const Steering& steering, LayerSettings& settings);

}  // namespace planewright::cli
