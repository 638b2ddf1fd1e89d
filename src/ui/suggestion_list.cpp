#include "ui/suggestion_list.h"

#include <algorithm>
#include <utility>

#include "ui/advice_task.h"

namespace planewright::ui {

SuggestionList make_suggestion_list(std::shared_ptr<const Advice> from, const HiddenEdits& hidden) {
  SuggestionList list;
  list.from = std::move(from);
  list.hidden = hidden;
  if (!list.from) return list;
  list.revision = list.from->revision;
  std::vector<Suggestion> sure;
  std::vector<int> rank_of_sure;
  for (std::size_t i = 0; i < list.from->ranked.size(); ++i) {
    const Suggestion& suggestion = list.from->ranked[i];
    const auto kind = static_cast<std::size_t>(suggestion.candidate.edit.kind);
    ++list.count[kind];
    if (hidden[kind]) continue;
    list.rows.push_back(static_cast<int>(i));
    if (!suggestion.met) continue;
    sure.push_back(suggestion);
    rank_of_sure.push_back(static_cast<int>(i));
  }
  for (const int k : choose_apart(*list.from->mesh, sure))
    list.together.push_back(rank_of_sure[static_cast<std::size_t>(k)]);
  return list;
}

std::optional<int> SuggestionList::row_of(const MeshEdit& edit) const {
  for (int row = 0; row < size(); ++row)
    if (at(row).candidate.edit == edit) return row;
  return std::nullopt;
}

const Suggestion* SuggestionList::best_at(int mesh_edge, std::optional<EditKind> kind) const {
  for (int row = 0; row < size(); ++row) {
    const Candidate& candidate = at(row).candidate;
    if (candidate.mesh_edge == mesh_edge && (!kind || candidate.edit.kind == *kind)) return &at(row);
  }
  return nullptr;
}

}  // namespace planewright::ui
