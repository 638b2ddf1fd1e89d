// Parsing of --layers: "outer=0.3,inner=-0.2", or a .json file with settings for each layer:
//
//   {"layers": [{"name": "outer", "offset": 0.3, "preset": "smooth-shell", "weights": {"fairing": 0.2},
//                "constraints": ["vertex", "offset-band=0.1:0.4@roof"], "no_penetration": true, "margin":
//                1e-3, "side": "outside", "thickness": 0.05},
//               {"name": "inner", "offset": -0.2, "coplanar_with": "outer"}]}
//
// Everything but the name may be missing and is then what the other options say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/steering.h"
#include "core/base/result.h"

namespace planewright::cli {

struct LayerRequest {
  std::string name;
  std::optional<double> offset, thickness;  // model units
  Steering steering;                        // over that of all layers
  int coplanar_with = -1;                   // index of an earlier layer; -1: none
};

// Fails with ErrorCode::Usage (the list) or ErrorCode::Unreadable (the file): not of that form, a name that
// stands there twice or would not do in a file's name, an unknown key, preset, energy or constraint, a value
// that makes no sense, coplanar_with no earlier layer.
Result<std::vector<LayerRequest>> parse_layers(const std::string& spec);

}  // namespace planewright::cli
