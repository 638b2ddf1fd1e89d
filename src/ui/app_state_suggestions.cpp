// AppState's suggestions: when edits are rated, what came of it, and how they are applied.
#include <algorithm>
#include <utility>

#include "ui/app_state.h"
#include "ui/format.h"

namespace planewright::ui {
namespace {

constexpr std::size_t kMostPreviews = 200;

}  // namespace

// --- Rating ----------------------------------------------------------------------------------

bool AppState::may_advise() const {
  if (document_.empty() || merging_ || loading() || solving()) return false;
  const LayerRun& of = run(active_layer());
  return of.newest_final && !of.stale && !of.failed && of.started && of.shown &&
         of.shown->iterate == of.newest && findings_known(of) && of.findings->diagnosis.solved &&
         of.findings->thresholds == finding_settings_;
}

void AppState::end_advice() {
  if (advising_ == nullptr) return;
  advising_.reset();
  previews_.clear();
  preview_wanted_.reset();
  advice_task_.stop();
}

void AppState::begin_advice() {
  const LayerRun& of = run(active_layer());
  std::erase_if(known_advice_, [](const auto& known) { return known->of.expired(); });
  const auto known = std::find_if(known_advice_.begin(), known_advice_.end(), [&](const auto& advice) {
    return advice->of.lock() == of.newest && advice->thresholds == finding_settings_;
  });
  if (known != known_advice_.end()) {
    advice_ = *known;
  } else {
    const std::uint64_t revision = advice_ ? advice_->revision + 1 : 1;
    advice_ = std::make_shared<Advice>();
    advice_->of = of.newest;
    advice_->thresholds = finding_settings_;
    advice_->mesh = document_.mesh();
    advice_->kind = of.newest->complex->kind;
    advice_->revision = revision;
  }
  advice_layer_ = of.id;
  advising_ = of.newest;
  previews_.clear();
  preview_wanted_.reset();
  AdviceJob job;
  job.number = ++next_advice_;
  job.mesh = document_.mesh();
  // Without what coplanar edges ask of it: the other layer would have to be edited with this one.
  job.settings = of.layer.settings;
  job.selections = of.started->selections;
  job.reference = of.started->reference;
  job.iterate = of.newest;
  job.findings = of.findings;
  job.rates = !advice_->done;
  advice_task_.submit(std::move(job));
}

bool AppState::update_advice() {
  bool changed = take_advice();
  const bool wanted = may_advise();
  if (advising_ && (!wanted || run(active_layer()).newest != advising_)) {
    end_advice();
    changed = true;
  }
  if (wanted && !advising_) {
    begin_advice();
    changed = true;
  }
  return changed;
}

bool AppState::take_advice() {
  auto news = advice_task_.take();
  if (!news || !advising_ || news->number != next_advice_) return false;
  for (auto& made : news->previews) {
    if (preview_wanted_ == made->edit) preview_wanted_.reset();
    if (previews_.size() >= kMostPreviews) previews_.erase(previews_.begin());
    previews_.push_back(std::move(made));
  }
  if (!news->listed || advice_->done) return true;
  advice_->ranked.insert(advice_->ranked.end(), std::make_move_iterator(news->rated.begin()),
                         std::make_move_iterator(news->rated.end()));
  rank(advice_->ranked);
  advice_->listed = true;
  advice_->tried = news->tried;
  advice_->candidates = news->candidates;
  advice_->done = news->done;
  advice_->refused = std::move(news->refused);
  ++advice_->revision;
  if (advice_->done) known_advice_.push_back(advice_);
  return true;
}

std::shared_ptr<const Advice> AppState::advice() const {
  const bool fits = advice_ && advice_layer_ == run(active_layer()).id && advice_->mesh == document_.mesh() &&
                    advice_->kind == document_.settings().mode;
  return fits ? advice_ : nullptr;
}

const SuggestionList& AppState::suggestion_list() const {
  auto from = advice();
  if (suggestion_list_.from != from || (from && suggestion_list_.revision != from->revision) ||
      suggestion_list_.hidden != view_options.hidden_edits) {
    suggestion_list_ = make_suggestion_list(std::move(from), view_options.hidden_edits);
  }
  return suggestion_list_;
}

std::shared_ptr<const EditPreview> AppState::preview(const MeshEdit& edit) {
  if (!advising_) return nullptr;
  for (const auto& known : previews_)
    if (known->edit == edit) return known;
  if (preview_wanted_ == edit) return nullptr;
  preview_wanted_ = edit;
  std::optional<Candidate> candidate;
  for (const Suggestion& suggestion : advice_->ranked)
    if (suggestion.candidate.edit == edit) candidate = suggestion.candidate;
  advice_task_.want(edit, std::move(candidate));
  return nullptr;
}

// --- Going through them ----------------------------------------------------------------------

std::optional<int> AppState::current_suggestion() const {
  return current_suggestion_ ? suggestion_list().row_of(*current_suggestion_) : std::nullopt;
}

void AppState::show_suggestion(int row) {
  const SuggestionList& list = suggestion_list();
  if (row < 0 || row >= list.size()) return;
  const MeshEdit edit = list.at(row).candidate.edit;
  clear_selection();
  current_suggestion_ = edit;
  look_at_ = LookAt{sketch(*list.from->mesh, edit).place - scene_origin_, 5.0 * mean_edge()};
}

void AppState::walk_suggestions(int by) {
  const int count = suggestion_list().size();
  if (count == 0) return;
  const auto current = current_suggestion();
  const int row = current ? *current + by : by > 0 ? 0 : count - 1;
  show_suggestion((row % count + count) % count);
}

const Suggestion* AppState::suggestion_at_hand() const {
  const SuggestionList& list = suggestion_list();
  if (const auto row = current_suggestion()) return &list.at(*row);
  const auto finding = current_finding();
  if (!finding) return nullptr;
  const Suggestion* best = nullptr;
  for (const FlaggedEdge& of : finding_list().flagged) {
    if (std::find(of.findings.begin(), of.findings.end(), *finding) == of.findings.end()) continue;
    const Suggestion* here = list.best_at(of.edge);
    if (here != nullptr && (best == nullptr || here->gain() > best->gain())) best = here;
  }
  return best;
}

// --- Applying --------------------------------------------------------------------------------

int AppState::element_number(const MeshEdit& edit) const {
  static const ElementIds none;
  const ElementIds& ids = document_.ids() ? *document_.ids() : none;
  const bool of_face = edit.kind == EditKind::SplitFace || edit.kind == EditKind::DeleteFace;
  const auto& numbers = edit.kind == EditKind::MoveVertex ? ids.vertices : of_face ? ids.faces : ids.edges;
  const bool known = edit.element >= 0 && edit.element < static_cast<int>(numbers.size());
  return known ? numbers[static_cast<std::size_t>(edit.element)] : edit.element;
}

std::string AppState::edit_name(const MeshEdit& edit) const {
  MeshEdit named = edit;
  named.element = element_number(edit);
  return describe(named);
}

bool AppState::apply_suggestion(const Suggestion& suggestion) {
  const MeshEdit edit = suggestion.candidate.edit;  // the list goes with the mesh
  current_suggestion_.reset();
  return edit_mesh(std::vector{edit}, edit_name(edit));
}

bool AppState::apply_all_suggestions() {
  const SuggestionList& list = suggestion_list();
  std::vector<MeshEdit> edits;
  for (const int i : list.together)
    edits.push_back(list.from->ranked[static_cast<std::size_t>(i)].candidate.edit);
  if (edits.empty()) return false;
  if (edits.size() > 1) edits = in_order(*document_.mesh(), edits);
  std::string what = edits.size() == 1
                         ? edit_name(edits.front())
                         : "Apply " + format_count(static_cast<std::int64_t>(edits.size())) + " suggestions";
  current_suggestion_.reset();
  return edit_mesh(edits, std::move(what));
}

}  // namespace planewright::ui
