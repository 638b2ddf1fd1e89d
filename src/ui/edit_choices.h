// EditChoices: the edits of the mesh that can be made at a place, and why others cannot.
//
// Indices: of the present mesh. Threads: the window's; plain values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/edit/document.h"

namespace planewright::ui {

class AppState;

struct EditTarget {
  std::optional<int> edge, face, vertex;
};

struct EditChoice {
  std::string name;              // "flip": in records, scripts
  std::string label;             // "Flip edge 12"
  std::optional<MeshEdit> edit;  // none: refused
  std::string refused;           // why, a sentence
};

// Every kind of edit, always in the same order. A vertex moves to the middle of its neighbours, one on the
// border to the middle of its neighbours along that: what undoes a dent or a crowded place. Any other place
// is a matter of the panels: a corner that is pinned can be dragged there.
std::vector<EditChoice> edit_choices(const Document& document, const EditTarget& target);

// What the selection means: an edge that was pointed at, or the one between two selected elements; a single
// face, or the face of the corner that was pointed at; a single vertex.
EditTarget target_of_selection(const AppState& state);

}  // namespace planewright::ui
