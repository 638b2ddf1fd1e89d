// Suggestions in words: what an edit is near, what it gains and of what that is made, and why there are none.
//
// Threads: pure functions.
#pragma once

#include <string>
#include <vector>

#include "ui/app_state.h"

namespace planewright::ui {

// Why nothing is listed, a sentence or two; empty: there is a list, or it is being made.
std::string why_no_suggestions(const AppState& state);

// Short, by numbers that outlive edits: "Flip edge 1,042", "Join at edge 12", "Move vertex 3".
std::string edit_label(const AppState& state, const MeshEdit& edit);

// The panels at an edit of the present mesh: "panels 12 and 47"; empty where they have no name.
std::string panels_at(const AppState& state, const Candidate& candidate);

// "0.83": in mean panel edges squared.
std::string gain_text(double gain);

// What the gain is made of, but for parts that are next to nothing.
struct GainPart {
  std::string what;    // "Short edges"
  std::string change;  // "1.2 → 0.1": as it is counted, without the weight
  double gain = 0.0;
};
std::vector<GainPart> gain_parts(const Suggestion& suggestion);

// One kind of edit, for a switch: "flip"
const char* kind_word(EditKind kind);

}  // namespace planewright::ui
