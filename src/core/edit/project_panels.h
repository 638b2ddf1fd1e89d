// The solved panels of one layer of a project, as the workshop takes them. Units: model units. Threads: pure.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/complex/state.h"
#include "core/edit/project.h"

namespace planewright {

struct ProjectPanels {
  int layer = 0;
  Panels panels;
  std::vector<int> numbers;                              // #P, as Document::panel_number() tells them
  std::vector<std::pair<int, std::string>> given_names;  // by number
};

// layer: its name; empty: the first one. Fails with ErrorCode::Usage for a name that no layer has (those that
// there are are listed), ErrorCode::Refused for a layer that is not solved, and as clusters_of() and
// build_complex() do.
Result<ProjectPanels> solved_panels(const Project& project, const std::string& layer);

}  // namespace planewright
