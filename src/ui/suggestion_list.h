// SuggestionList: what is known of edits that would better what is shown, and what of it is listed, walked
// through and applied together.
//
// Indices: of the mesh that was solved. Threads: plain values.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/advise/edit_plan.h"
#include "core/design/solve_session.h"

namespace planewright::ui {

inline constexpr int kEditKinds = 7;
using HiddenEdits = std::bitset<kEditKinds>;  // by EditKind

// What was found out about one result of a solve.
struct Advice {
  std::weak_ptr<const Iterate> of;
  FindingSettings thresholds;  // of the findings that the edits are candidates for
  std::shared_ptr<const PolygonMesh> mesh;
  ComplexKind kind = ComplexKind::Dual;
  std::vector<Suggestion> ranked;  // best first; grows while edits are being rated
  int tried = 0, candidates = 0;
  bool listed = false;           // the candidates are known
  bool done = false;             // all of them are rated
  std::optional<Error> refused;  // why none can be
  std::uint64_t revision = 0;    // grows with every change of the above
};

struct SuggestionList {
  // What it was made from.
  std::shared_ptr<const Advice> from;
  std::uint64_t revision = 0;
  HiddenEdits hidden;

  std::vector<int> rows;                // indices into the ranked ones, of the kinds that are not hidden
  std::array<int, kEditKinds> count{};  // of each kind, hidden or not
  // Indices into the ranked ones: what "all that gain" applies together. Of the rows, those whose local
  // solve met every row, and that lie apart (core/advise/edit_plan.h).
  std::vector<int> together;

  int size() const { return static_cast<int>(rows.size()); }
  const Suggestion& at(int row) const {
    return from->ranked[static_cast<std::size_t>(rows[static_cast<std::size_t>(row)])];
  }
  std::optional<int> row_of(const MeshEdit& edit) const;
  // The best that is shown at an edge, of one kind or of any; null: there is none.
  const Suggestion* best_at(int mesh_edge, std::optional<EditKind> kind = {}) const;
};

// from: null, and the list is empty.
SuggestionList make_suggestion_list(std::shared_ptr<const Advice> from, const HiddenEdits& hidden);

}  // namespace planewright::ui
