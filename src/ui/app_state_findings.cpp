// AppState's findings: which are known of what is shown, and the way from one to the next.
#include "ui/app_state.h"

namespace planewright::ui {

bool AppState::findings_known(const LayerRun& of) const {
  return !of.shown || (of.findings && of.findings->number == of.shown->number);
}

std::shared_ptr<const PreparedFindings> AppState::findings() const {
  const LayerRun& of = run(active_layer());
  // With other thresholds they are found anew; until then those before stay, or the list would flicker.
  return of.shown && of.findings && of.findings->iterate == of.shown->iterate ? of.findings : nullptr;
}

void AppState::set_finding_settings(const FindingSettings& settings) {
  if (settings == finding_settings_) return;
  finding_settings_ = settings;
  end_advice();
  for (LayerRun& of : runs_) {
    if (of.newest) submit(of);
  }
}

const FindingList& AppState::finding_list() const {
  auto from = findings();
  const auto shown_ids = shown() ? shown()->ids : nullptr;
  if (finding_list_.from != from || finding_list_.shown_ids != shown_ids ||
      finding_list_.present_ids != document_.ids() || finding_list_.hidden != view_options.hidden_findings) {
    finding_list_ =
        make_finding_list(std::move(from), shown_ids, document_.ids(), view_options.hidden_findings);
  }
  return finding_list_;
}

void AppState::follow_finding() {
  constexpr double kReach = 0.5;  // mean edges
  const FindingList& list = finding_list();
  if (!list.from || !current_finding_ || !walked_) return;
  const auto row = same_place(list, *walked_, kReach * shown()->complex().mean_edge);
  current_finding_.reset();
  if (row) go_to_row(*row);
}

void AppState::go_to_row(int row) {
  const FindingList& list = finding_list();
  current_finding_ = list.rows[static_cast<std::size_t>(row)];
  next_row_ = row;
  walked_ = list.finding(row);
}

std::optional<int> AppState::current_finding() const {
  return current_finding_ ? finding_list().row_of(*current_finding_) : std::nullopt;
}

void AppState::show_finding(int row) {
  const FindingList& list = finding_list();
  if (row < 0 || row >= list.size()) return;
  const Finding finding = list.finding(row);
  show_element(finding.element);
  if (finding.second && finding.second->kind == ElementKind::Panel) {
    const auto pointed_at = selected_panel;
    select_panel(finding.second->index, Combine::Add);
    if (pointed_at) selected_panel = pointed_at;
  }
  if (look_at_ && finding.place.allFinite()) look_at_->point = finding.place - scene_origin_;
  go_to_row(row);
}

void AppState::walk_findings(int by) {
  const int count = finding_list().size();
  if (count == 0) return;
  int row = next_row_;  // what has come into the place of the one that is gone
  if (const auto current = current_finding()) {
    row = *current + by;
  } else if (!walked_) {
    row = by > 0 ? 0 : count - 1;
  } else if (by < 0) {
    row = next_row_ - 1;
  }
  show_finding((row % count + count) % count);
}

}  // namespace planewright::ui
