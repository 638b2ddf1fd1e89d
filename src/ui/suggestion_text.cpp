#include "ui/suggestion_text.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/format.h"

namespace planewright::ui {
namespace {

// What is less is not worth a line.
constexpr double kNothing = 5e-3;

}  // namespace

std::string why_no_suggestions(const AppState& state) {
  if (state.document().empty()) return "Nothing to edit yet.";
  const auto advice = state.advice();
  if (advice) {
    if (advice->refused) return "Edits cannot be rated: " + advice->refused->what + ".";
    if (!advice->done || !advice->ranked.empty()) return {};
    if (advice->candidates == 0) return "Nothing to suggest: no finding calls for an edit of the mesh.";
    return "Nothing to suggest: of " + format_count(advice->candidates, "edit", "edits") +
           " near findings none gains enough.";
  }
  if (state.solving() || state.loading()) return "Edits are rated when the solve has come to a result.";
  if (!state.shown()) return "Not solved yet. Edits are rated once there are panels.";
  if (!state.up_to_date()) return "The design has changed since. Space solves, and edits are rated.";
  const auto findings = state.findings();
  if (findings && !findings->diagnosis.solved)
    return "Not solved yet: edits are rated once the panels are planar.";
  return state.report() == nullptr ? "Not solved yet. Space solves, and edits are rated."
                                   : "Edits are rated once findings are known.";
}

std::string edit_label(const AppState& state, const MeshEdit& edit) {
  const bool of_vertex = edit.kind == EditKind::MoveVertex;
  const bool of_face = edit.kind == EditKind::SplitFace || edit.kind == EditKind::DeleteFace;
  const char* what = of_vertex                     ? " vertex "
                     : of_face                     ? " face "
                     : edit.kind == EditKind::Join ? " at edge "
                                                   : " edge ";
  return capitalised(kind_word(edit.kind)) + what + format_count(state.element_number(edit));
}

std::string panels_at(const AppState& state, const Candidate& candidate) {
  const auto& mesh = state.document().mesh();
  if (!mesh || candidate.mesh_edge < 0 || candidate.mesh_edge >= mesh->edge_count()) return {};
  if (candidate.edit.kind == EditKind::MoveVertex) return {};
  const MeshEdge edge = mesh->edge(candidate.mesh_edge);
  const bool dual = state.document().settings().mode == ComplexKind::Dual;
  std::string names;
  for (const int origin : dual ? std::array{edge.a, edge.b} : std::array{edge.left, edge.right}) {
    const int number = origin < 0 ? -1 : state.document().panel_number(state.active_layer(), origin);
    if (number < 0) continue;
    if (!names.empty()) names.append(" and ");
    names.append(format_count(number));
  }
  if (names.empty()) return {};
  return std::string(names.find(' ') == std::string::npos ? "panel " : "panels ").append(names);
}

std::string gain_text(double gain) {
  char text[32];
  std::snprintf(text, sizeof text, std::abs(gain) < 99.95 ? "%.2f" : "%.0f", std::abs(gain));
  return (gain < 0 ? "−" : "") + std::string(text);
}

std::vector<GainPart> gain_parts(const Suggestion& suggestion) {
  std::vector<GainPart> parts;
  const Score &before = suggestion.before, &after = suggestion.after;
  const GainParts gain = suggestion.parts();
  const auto add = [&](const char* what, double part, std::string change) {
    if (std::abs(part) >= kNothing) parts.push_back({what, std::move(change), part});
  };
  const auto from_to = [](double from, double to) { return format_number(from) + " → " + format_number(to); };
  add("Energy", gain.energy, from_to(before.energy, after.energy));
  add("Crossing panels", gain.crossing, from_to(before.crossing, after.crossing));
  add("Short edges", gain.short_edges, from_to(before.short_edges, after.short_edges));
  add("Reversed edges", gain.reversed, from_to(before.reversed, after.reversed));
  add("Corners far off", gain.far_points, from_to(before.far_points, after.far_points));
  add("The surface moves", gain.deviation, format_with_unit(suggestion.candidate.deviation, "edges"));
  add("Design given up", gain.given_up, "");
  return parts;
}

const char* kind_word(EditKind kind) {
  switch (kind) {
    case EditKind::Flip:
      return "flip";
    case EditKind::Join:
      return "join";
    case EditKind::SplitEdge:
    case EditKind::SplitFace:
      return "split";
    case EditKind::Collapse:
      return "collapse";
    case EditKind::MoveVertex:
      return "move";
    case EditKind::DeleteFace:
      return "delete";
  }
  return "";
}

}  // namespace planewright::ui
