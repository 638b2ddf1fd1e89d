// FindingList: what of the findings is listed, walked through and drawn, and which edges of the present mesh
// an edit there would change.
//
// Threads: plain values.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/edit/element_names.h"
#include "ui/prepared_findings.h"

namespace planewright::ui {

// A mesh edge that a click flips because findings say so.
struct FlaggedEdge {
  int edge;                   // of the present mesh
  double severity;            // of the worst finding that flags it
  std::vector<int> findings;  // rows of the list, the worst first
};

struct FindingList {
  // What it was made from.
  std::shared_ptr<const PreparedFindings> from;
  std::shared_ptr<const ElementIds> shown_ids, present_ids;
  HiddenFindings hidden;

  std::vector<int> rows;                   // indices into the findings, of the kinds that are not hidden
  std::array<int, kFindingKinds> count{};  // of each kind, hidden or not
  std::vector<FlaggedEdge> flagged;        // ascending by edge

  const Finding& finding(int row) const {
    return from->diagnosis.findings[static_cast<std::size_t>(rows[static_cast<std::size_t>(row)])];
  }
  int size() const { return static_cast<int>(rows.size()); }
  std::optional<int> row_of(int finding) const;     // none: it is hidden
  const FlaggedEdge* find_flagged(int edge) const;  // null: not flagged
  // To be told apart in a picture: then only those of the current finding are drawn.
  bool too_many_flagged() const { return flagged.size() > 150; }
};

// from: null, and the list is empty. shown_ids, present_ids: of the mesh that the findings are of, and of the
// one that edits go to.
FindingList make_finding_list(std::shared_ptr<const PreparedFindings> from,
                              std::shared_ptr<const ElementIds> shown_ids,
                              std::shared_ptr<const ElementIds> present_ids, const HiddenFindings& hidden);

// The row that is the same bad place as a finding of an earlier state: of its kind, and nearest to where it
// was, within `reach` (model units).
std::optional<int> same_place(const FindingList& list, const Finding& earlier, double reach);

}  // namespace planewright::ui
