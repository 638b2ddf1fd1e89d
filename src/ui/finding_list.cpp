#include "ui/finding_list.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/complex/mapped_origin.h"

namespace planewright::ui {

FindingList make_finding_list(std::shared_ptr<const PreparedFindings> from,
                              std::shared_ptr<const ElementIds> shown_ids,
                              std::shared_ptr<const ElementIds> present_ids, const HiddenFindings& hidden) {
  FindingList list;
  list.from = std::move(from);
  list.shown_ids = std::move(shown_ids);
  list.present_ids = std::move(present_ids);
  list.hidden = hidden;
  if (!list.from) return list;

  const std::vector<Finding>& findings = list.from->diagnosis.findings;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    ++list.count[static_cast<std::size_t>(findings[i].kind)];
    if (!is_hidden(hidden, findings[i].kind)) list.rows.push_back(static_cast<int>(i));
  }

  std::optional<ElementMap> edited;
  if (list.shown_ids && list.present_ids && list.shown_ids != list.present_ids &&
      *list.shown_ids != *list.present_ids) {
    edited = map_between(*list.shown_ids, *list.present_ids);
  }
  std::map<int, FlaggedEdge> flagged;
  for (int row = 0; row < list.size(); ++row) {
    const Finding& finding = list.finding(row);
    if (!calls_for_edits(finding.kind)) continue;
    for (int edge : finding.mesh_edges) {
      if (edited) edge = mapped(edited->edges, edge);
      if (edge < 0) continue;
      FlaggedEdge& of = flagged.try_emplace(edge, FlaggedEdge{edge, 0.0, {}}).first->second;
      of.severity = std::max(of.severity, finding.severity);
      of.findings.push_back(row);
    }
  }
  for (auto& [edge, of] : flagged) {
    std::stable_sort(of.findings.begin(), of.findings.end(),
                     [&](int a, int b) { return list.finding(a).severity > list.finding(b).severity; });
    list.flagged.push_back(std::move(of));
  }
  return list;
}

std::optional<int> FindingList::row_of(int finding) const {
  const auto at = std::lower_bound(rows.begin(), rows.end(), finding);
  if (at == rows.end() || *at != finding) return std::nullopt;
  return static_cast<int>(at - rows.begin());
}

const FlaggedEdge* FindingList::find_flagged(int edge) const {
  const auto at = std::lower_bound(flagged.begin(), flagged.end(), edge,
                                   [](const FlaggedEdge& of, int wanted) { return of.edge < wanted; });
  return at != flagged.end() && at->edge == edge ? &*at : nullptr;
}

std::optional<int> same_place(const FindingList& list, const Finding& earlier, double reach) {
  std::optional<int> best;
  double nearest = reach;
  for (int row = 0; row < list.size(); ++row) {
    const Finding& finding = list.finding(row);
    if (finding.kind != earlier.kind) continue;
    const double away = (finding.place - earlier.place).norm();
    if (!(away <= nearest) || (best && away == nearest)) continue;
    best = row;
    nearest = away;
  }
  return best;
}

}  // namespace planewright::ui
