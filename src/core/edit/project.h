// Project: everything of a document that is kept when the program ends: what `project_file.h` writes and
// reads, and Document::to_project() and open_project() hand over. Not the steps that can be undone.
//
// Units: model units (contract.unit says which). Indices: 0-based. Threads: plain values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/complex/state.h"
#include "core/design/clustered_mesh.h"
#include "core/design/layer_settings.h"
#include "core/edit/element_names.h"
#include "core/edit/given_names.h"
#include "core/mesh/polygon_mesh.h"
#include "core/workshop/contract.h"

namespace planewright {

struct Project {
  std::string name;  // as the title shows it
  PolygonMesh mesh;
  Design design;
  WorkshopContract contract;
  ElementNames names;
  GivenNames given_names;
  std::optional<ClusterRecord> clusters;  // the regions of panels of clusters; clusters_of() makes them of it
  // Of each layer, or empty: the solved panels, as a state of the complex that build_complex() makes of mesh
  // and settings.
  std::vector<std::optional<State>> solved;
};

// What a mesh and a design are as a document opens them: nothing edited, named or solved.
Project new_project(std::string name, PolygonMesh mesh, Design design);

}  // namespace planewright
