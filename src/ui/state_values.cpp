// What scripts ask of the program's state, by name: state_value() and state_keys() of test_driver.h.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "ui/finding_text.h"
#include "ui/layer_edits.h"
#include "ui/script.h"
#include "ui/solve_badge.h"
#include "ui/suggestion_text.h"
#include "ui/test_driver.h"

namespace planewright::ui {
namespace {

std::string text_of(double value) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return error == std::errc() ? std::string(buffer, end) : "?";
}

// demand.NAME: on or off; demand.NAME.PARAMETER; and of the report: violation.NAME, violated.NAME, rows.NAME.
std::optional<std::string> demand_value(const AppState& state, const std::string& key) {
  const std::size_t dot = key.find('.');
  if (dot == std::string::npos) return std::nullopt;
  const std::string what = key.substr(0, dot);
  std::string name = key.substr(dot + 1);
  if (what == "violation" || what == "violated" || what == "rows") {
    if (state.report() == nullptr) return "none";
    for (const SolveReport::Constraint& c : state.report()->constraints) {
      if (c.name != name) continue;
      return text_of(what == "rows" ? c.rows : what == "violated" ? c.violated : c.max_violation);
    }
    return "none";
  }
  if (what != "demand") return std::nullopt;
  const Demands& demands = state.document().settings().demands;
  std::string parameter_name;
  if (const std::size_t second = name.find('.'); second != std::string::npos) {
    parameter_name = name.substr(second + 1);
    name.erase(second);
  }
  const auto info = find_demand(name);
  if (!info) return std::nullopt;
  if (parameter_name.empty()) return is_on(demands, name) ? "1" : "0";
  const auto entries = entries_of(demands, name);
  const Demand entry = entries.empty() ? Demand{} : demands.list[entries.front()];
  if (parameter_name == "where") return entry.selection;
  for (std::size_t k = 0; k < (*info)->parameters.size(); ++k) {
    if ((*info)->parameters[k].name != parameter_name) continue;
    const double value = parameter(**info, entry, k);
    return std::abs(value) >= kNoLimit ? "none" : text_of(value);
  }
  return std::nullopt;
}

// share.NAME, value.NAME: what an energy adds to the objective.
std::optional<std::string> energy_value(const AppState& state, const std::string& key) {
  const bool share = key.starts_with("share.");
  if (!share && !key.starts_with("value.")) return std::nullopt;
  double total = 0;
  std::optional<double> own;
  for (const SolveReport::Energy& energy : state.energies()) {
    total += energy.value;
    if (energy.name == key.substr(6)) own = energy.value;
  }
  if (!own) return "none";
  return text_of(share ? *own / total : *own);
}

// findings, findings.KIND: how many there are, "none" until that is known; findings_listed: of the kinds that
// are not hidden; finding: the row that the designer is at, -1 for none; finding.ROW.measure, .kind,
// .element; limit.KIND: from which measure on; flagged: edges; flagged.I: the edge; flagged.flippable: the
// first that can be flipped, flagged.stuck: that cannot.
std::optional<std::string> finding_value(const AppState& state, const std::string& key) {
  const FindingList& list = state.finding_list();
  if (key == "findings") return list.from ? std::to_string(list.from->diagnosis.findings.size()) : "none";
  if (key == "findings_listed") return text_of(list.size());
  if (key == "finding") return text_of(state.current_finding().value_or(-1));
  if (key == "solved") return list.from ? (list.from->diagnosis.solved ? "1" : "0") : "none";
  if (key == "flagged") return std::to_string(list.flagged.size());
  if (key.starts_with("limit.")) {
    const auto kind = find_finding_kind(key.substr(6));
    return kind ? std::optional(text_of(state.finding_settings()[*kind].threshold)) : std::nullopt;
  }
  if (key.starts_with("findings.")) {
    const auto kind = find_finding_kind(key.substr(9));
    if (!kind) return std::nullopt;
    return list.from ? text_of(list.from->diagnosis.count(*kind)) : "none";
  }
  if (key.starts_with("finding.")) {
    const std::size_t dot = key.find('.', 8);
    const auto row = number_in(key.substr(8, dot == std::string::npos ? dot : dot - 8));
    if (!row || dot == std::string::npos || *row < 0 || *row >= list.size()) return std::nullopt;
    const Finding& finding = list.finding(static_cast<int>(*row));
    const std::string what = key.substr(dot + 1);
    if (what == "kind") return info(finding.kind).name;
    if (what == "element") return text(finding.element);
    if (what == "measure") return text_of(finding.measure);
    return std::nullopt;
  }
  return std::nullopt;
}

// suggestions: how many there are, "none" as long as none is known; suggestions_listed: of the kinds that are
// not left out; suggestions_together: that are applied with one button; suggestion: the row that the designer
// is at, -1 for none; suggestion.ROW.gain, .edit, .edge; rated, candidates: how far the rating is; rating.
std::optional<std::string> suggestion_value(const AppState& state, const std::string& key) {
  const SuggestionList& list = state.suggestion_list();
  if (key == "suggestions") return list.from ? std::to_string(list.from->ranked.size()) : "none";
  if (key == "suggestions_listed") return text_of(list.size());
  if (key == "suggestions_together") return std::to_string(list.together.size());
  if (key == "suggestions_text") return why_no_suggestions(state);
  if (key == "suggestion") return text_of(state.current_suggestion().value_or(-1));
  if (key == "rating") return state.rating() ? "1" : "0";
  if (key == "rated") return text_of(list.from ? list.from->tried : 0);
  if (key == "candidates") return text_of(list.from ? list.from->candidates : 0);
  if (!key.starts_with("suggestion.")) return std::nullopt;
  const std::size_t dot = key.find('.', 11);
  const auto row = number_in(key.substr(11, dot == std::string::npos ? dot : dot - 11));
  if (!row || dot == std::string::npos || *row < 0 || *row >= list.size()) return std::nullopt;
  const Suggestion& suggestion = list.at(static_cast<int>(*row));
  const std::string what = key.substr(dot + 1);
  if (what == "gain") return text_of(suggestion.gain());
  if (what == "edit") return state.edit_name(suggestion.candidate.edit);
  if (what == "edge") return text_of(suggestion.candidate.mesh_edge);
  return std::nullopt;
}

// regions: how many there are, 0 while there are none; asked_regions; clustering; clustering_ms: the newest;
// cluster_error: why there is nothing new, or empty; sight; hovered_region, selected_region: -1 for none,
// selected_regions; region_faces.N: how many it has; report_panels, report_l21, report_rms, report_acute,
// report_repairs: "none" until they are known.
std::optional<std::string> cluster_value(const DriverContext& c, const std::string& key) {
  const AppState& state = c.state;
  const auto& clusters = state.clusters();
  if (key == "regions") return text_of(clusters ? clusters->regions.count() : 0);
  if (key == "asked_regions") return text_of(state.cluster_options().panels);
  if (key == "clustering") return state.clustering() ? "1" : "0";
  if (key == "clustering_ms") return text_of(state.milliseconds_per_clustering());
  if (key == "cluster_error") return state.cluster_error() ? state.cluster_error()->what : "";
  if (key == "sight") return std::string(name(state.cluster_sight()));
  if (key == "hovered_region") return text_of(c.viewport.hovered_region().value_or(-1));
  const std::vector<int>& selected = state.selected_regions();
  if (key == "selected_regions") return std::to_string(selected.size());
  if (key == "selected_region") return text_of(selected.empty() ? -1 : selected.front());
  if (key.starts_with("region_faces.")) {
    const auto region = number_in(key.substr(13));
    if (!region || !clusters) return std::nullopt;
    const std::vector<int>& regions = clusters->regions.region_of_face;
    return std::to_string(std::count(regions.begin(), regions.end(), static_cast<int>(*region)));
  }
  if (key.starts_with("report_")) {
    const auto report = state.cluster_report();
    if (!report) return "none";
    if (key == "report_l21") return text_of(report->l21);
    if (key == "report_rms") return report->panels_to_mesh ? text_of(report->panels_to_mesh->rms()) : "none";
    if (key == "report_max") return report->panels_to_mesh ? text_of(report->panels_to_mesh->max()) : "none";
    if (key == "report_acute") return std::to_string(report->acute.size());
    if (key == "report_repairs") return std::to_string(report->repairs.size());
  }
  return std::nullopt;
}

// Of the schedule as it was last drawn. schedule_rows: how many are listed, "none" until that is known, of
// schedule_panels; schedule_text: why there are none; schedule_sort: "area descending";
// schedule_filter_error; schedule_sum; schedule_made: how often the list was made; schedule_row: where the
// panel that is pointed at stands, -1 for nowhere; schedule.ROW.COLUMN: a cell's text; schedule.ROW.panel;
// schedule.ROW.selected.
std::optional<std::string> schedule_value(const DriverContext& c, const std::string& key) {
  const ScheduleView& view = c.window.schedule;
  if (key == "schedule_rows") return view.schedule().from ? text_of(view.list().size()) : "none";
  if (key == "schedule_panels") return text_of(view.schedule().size());
  if (key == "schedule_sort")
    return info(view.query.sort).name + (view.query.descending ? " descending" : " ascending");
  if (key == "schedule_filter_error") return view.list().filter_error;
  if (key == "schedule_sum") return view.schedule().from ? sum_text(view.schedule(), view.list()) : "none";
  if (key == "schedule_text") return why_no_schedule(c.state);
  if (key == "schedule_made") return text_of(view.made());
  if (key == "schedule_row")
    return text_of(c.state.selected_panel ? view.row_of(*c.state.selected_panel).value_or(-1) : -1);
  if (!key.starts_with("schedule.")) return std::nullopt;
  const std::size_t dot = key.find('.', 9);
  const auto row = number_in(key.substr(9, dot == std::string::npos ? dot : dot - 9));
  if (!row || dot == std::string::npos || *row < 0 || *row >= view.list().size()) return std::nullopt;
  const int panel = view.list().panels[static_cast<std::size_t>(*row)];
  const std::string what = key.substr(dot + 1);
  if (what == "panel") return text_of(panel);
  if (what == "selected") return view.selected(panel) ? "1" : "0";
  const auto column = find_schedule_column(what);
  return column ? std::optional(cell_text(view.schedule(), panel, *column)) : std::nullopt;
}

}  // namespace

const std::vector<std::string>& state_keys() {
  static const std::vector<std::string> keys = {"document",
                                                "vertices",
                                                "faces",
                                                "edges",
                                                "mode",
                                                "offset",
                                                "freedom",
                                                "border",
                                                "preset",
                                                "margin",
                                                "side",
                                                "never_touch",
                                                "crossings",
                                                "conflicts",
                                                "waived",
                                                "revision",
                                                "ticket",
                                                "solving",
                                                "settled",
                                                "asked",
                                                "solver",
                                                "badge",
                                                "polishing",
                                                "polished",
                                                "can_polish",
                                                "polish_automatically",
                                                "status",
                                                "panels",
                                                "points",
                                                "iterates_before_end",
                                                "steps",
                                                "planarity",
                                                "displacement",
                                                "objective",
                                                "findings",
                                                "findings_listed",
                                                "finding",
                                                "solved",
                                                "flagged",
                                                "suggestions",
                                                "suggestions_listed",
                                                "suggestions_together",
                                                "suggestion",
                                                "rating",
                                                "rated",
                                                "candidates",
                                                "history",
                                                "fingerprint",
                                                "undo",
                                                "redo",
                                                "can_undo",
                                                "can_redo",
                                                "colours",
                                                "range",
                                                "ghost",
                                                "dark",
                                                "unit",
                                                "messages",
                                                "messages_posted",
                                                "last_message",
                                                "selected_panel",
                                                "selected_point",
                                                "hovered_edge",
                                                "selected",
                                                "selected_vertices",
                                                "selected_edges",
                                                "selected_faces",
                                                "stored",
                                                "pins",
                                                "plane_pins",
                                                "tool",
                                                "regions",
                                                "asked_regions",
                                                "clustering",
                                                "cluster_error",
                                                "sight",
                                                "selected_regions",
                                                "schedule_rows",
                                                "schedule_sort",
                                                "schedule_filter_error",
                                                "layers",
                                                "active_layer",
                                                "browser_open",
                                                "camera",
                                                "drain_median_ms",
                                                "drain_max_ms",
                                                "upload_median_ms",
                                                "upload_max_ms",
                                                "stream_median_ms",
                                                "stream_max_ms"};
  return keys;
}

std::optional<std::string> state_value(const DriverContext& c, const std::string& key) {
  const AppState& state = c.state;
  const Document& document = state.document();
  const auto& shown = state.shown();
  const auto flag = [](bool on) { return std::string(on ? "1" : "0"); };
  const auto count = [](auto n) { return std::to_string(n); };
  if (key == "document") return document.name();
  if (key == "vertices") return count(document.empty() ? 0 : document.mesh()->vertex_count());
  if (key == "faces") return count(document.empty() ? 0 : document.mesh()->face_count());
  if (key == "edges") return count(document.empty() ? 0 : document.mesh()->edge_count());
  if (key == "mode") {
    const ComplexKind mode = document.settings().mode;
    return std::string(mode == ComplexKind::Dual        ? "dual"
                       : mode == ComplexKind::Planarize ? "planarize"
                                                        : "cluster");
  }
  if (key == "offset") return text_of(document.settings().offset);
  if (key == "freedom") return count(static_cast<int>(document.settings().freedom));
  if (key == "border") return count(static_cast<int>(document.settings().border));
  if (key.starts_with("weight.")) {
    const auto found = document.settings().weights.find(key.substr(7));
    return text_of(found == document.settings().weights.end() ? 0.0 : found->second);
  }
  if (auto of_demand = demand_value(state, key)) return of_demand;
  if (auto of_energy = energy_value(state, key)) return of_energy;
  if (key == "preset") {
    const Preset* preset = present_preset(document.settings());
    return preset != nullptr ? preset->name : "custom";
  }
  if (key == "never_touch") {
    const Switch now = never_touch(document.settings());
    return std::string(now == Switch::On ? "on" : now == Switch::Off ? "off" : "mixed");
  }
  if (key == "margin") return text_of(document.settings().demands.margin);
  if (key == "side") return count(static_cast<int>(document.settings().side));
  if (key == "waived") return count(document.settings().demands.waived.size());
  if (key == "conflicts") return count(state.report() != nullptr ? state.report()->conflicts.size() : 0);
  if (key == "crossings") return count(state.report() != nullptr ? state.report()->crossings : -1);
  if (key.starts_with("edge.")) {
    const auto index = number_in(key.substr(5));
    if (!index || document.empty() || *index < 0 || *index >= document.mesh()->edge_count())
      return std::nullopt;
    const MeshEdge edge = document.mesh()->edge(static_cast<int>(*index));
    return count(std::min(edge.a, edge.b)) + "-" + count(std::max(edge.a, edge.b));
  }
  if (key.starts_with("ui:")) {
    const UiRecord* record = c.ui.find(key.substr(3));
    return record == nullptr ? "absent" : record->enabled ? "enabled" : "disabled";
  }
  if (key == "revision") return count(document.revision());
  if (key == "ticket") return count(state.ticket());
  if (key == "solving") return flag(state.solving());
  if (key == "settled") return flag(state.settled());
  if (key == "asked") return std::string(planewright::name(state.asked_solver()));
  if (key == "solver") return state.report() != nullptr ? state.report()->solver : "none";
  if (key == "badge") return solve_badge(standing_of(state), c.state.unit()).headline;
  if (key == "polishing") return flag(state.polishing());
  if (key == "polished") return flag(state.polished());
  if (key == "can_polish") return flag(state.can_polish());
  if (key == "polish_automatically") return flag(state.polish_automatically());
  if (key == "status")
    return std::string(state.report() != nullptr ? planewright::name(state.report()->status) : "none");
  if (key == "panels") return count(shown ? shown->complex().plane_count() : 0);
  if (key == "points") return count(shown ? shown->complex().point_count() : 0);
  if (key == "iterates_before_end") return count(state.iterates_before_end());
  if (key == "steps") return count(state.history().empty() ? 0 : state.history().back().number);
  if (key == "planarity") return text_of(shown ? shown->planarity.max : 0.0);
  if (key == "planarity_relative") return text_of(shown ? shown->planarity.max_relative_to_bbox : 0.0);
  if (key == "displacement") return text_of(shown ? shown->displacement.rms : 0.0);
  if (key == "objective") return text_of(state.history().empty() ? 0.0 : state.history().back().objective);
  if (auto value = finding_value(state, key)) return value;
  if (auto value = suggestion_value(state, key)) return value;
  if (auto value = cluster_value(c, key)) return value;
  if (auto value = schedule_value(c, key)) return value;
  if (key == "clipboard") {
    const char* text = ImGui::GetClipboardText();
    return std::string(text != nullptr ? text : "");
  }
  if (key == "findings_text") return why_no_findings(findings_standing(state), c.state.unit());
  if (key == "history") return count(document.history().size());
  if (key == "steps_done") return count(document.steps_done());
  if (key == "fingerprint") return count(shown ? shown->fingerprint : 0);
  if (key == "undo") return document.undo_name();
  if (key == "redo") return document.redo_name();
  if (key == "can_undo") return flag(document.can_undo());
  if (key == "can_redo") return flag(document.can_redo());
  if (key == "colours") return std::string(name(state.view_options.colours));
  if (key == "range") return text_of(state.colour_range());
  if (key == "ghost") return flag(state.view_options.ghost);
  if (key == "dark") return flag(c.window.settings.dark);
  if (key == "unit") return c.state.unit();
  if (key == "messages") return count(state.messages().size());
  if (key == "messages_posted") return count(state.messages_posted());
  if (key == "last_message") {
    if (state.messages().empty()) return std::string();
    const Message& last = state.messages().back();
    return last.where + ": " + last.what + ". " + last.remedy;
  }
  if (key == "selected_panel") return count(state.selected_panel.value_or(-1));
  if (key == "selected_point") return count(state.selected_point.value_or(-1));
  if (key == "selected_edge") return count(state.selected_edge.value_or(-1));
  if (key == "selected") return count(element_count(state.selection()));
  if (key == "selected_vertices") return count(state.selection().vertices.size());
  if (key == "selected_edges") return count(state.selection().edges.size());
  if (key == "selected_faces") return count(state.selection().faces.size());
  if (key == "stored") return count(document.design().selections.size());
  if (key.starts_with("stored.")) {
    const auto index = number_in(key.substr(7));
    if (!index || *index < 0 || *index >= static_cast<double>(document.design().selections.size()))
      return std::nullopt;
    return document.design().selections[static_cast<std::size_t>(*index)].name;
  }
  if (key == "pins") return count(document.settings().demands.pins.size());
  if (key == "plane_pins") return count(document.settings().demands.plane_pins.size());
  if (key.starts_with("pin.")) {  // pin.N.x: where it holds; pin.N.off: how far its point is from there
    const std::size_t dot = key.find('.', 4);
    const auto index = number_in(key.substr(4, dot == std::string::npos ? dot : dot - 4));
    const auto& pins = document.settings().demands.pins;
    if (!index || dot == std::string::npos || *index < 0 || *index >= static_cast<double>(pins.size()))
      return std::nullopt;
    const Pin& pin = pins[static_cast<std::size_t>(*index)];
    const std::string what = key.substr(dot + 1);
    if (what == "off") {
      const auto place = state.pin_place(pin);
      const auto point = state.shown_point(pin.point);
      if (!place || !point) return std::nullopt;
      return text_of((*place - Vector3d(shown->points.row(*point).transpose())).norm());
    }
    if (what != "x" && what != "y" && what != "z") return std::nullopt;
    const auto& held = pin.at[static_cast<std::size_t>(what[0] - 'x')];
    return held ? text_of(*held) : "free";
  }
  if (key == "tool") return std::string(name(state.tool));
  if (key == "layers") return count(state.layer_count());
  if (key == "active_layer") return count(state.active_layer());
  if (key.starts_with("layer.")) {  // layer.N.name, .offset, .visible, .status, .planar
    const std::size_t dot = key.find('.', 6);
    const auto index = number_in(key.substr(6, dot == std::string::npos ? dot : dot - 6));
    if (!index || dot == std::string::npos || *index < 0 || *index >= state.layer_count())
      return std::nullopt;
    const int i = static_cast<int>(*index);
    const Layer& layer = document.design().layers[static_cast<std::size_t>(i)];
    const std::string what = key.substr(dot + 1);
    if (what == "name") return layer.name;
    if (what == "offset") return text_of(layer.settings.offset);
    if (what == "visible") return flag(layer.visible);
    if (what == "thickness") return text_of(layer.thickness);
    if (what == "status") {
      return std::string(state.report(i) != nullptr ? planewright::name(state.report(i)->status) : "none");
    }
    if (what == "planarity_relative")
      return text_of(state.shown(i) ? state.shown(i)->planarity.max_relative_to_bbox : -1);
    if (what == "beams")
      return count(state.shown(i) && state.shown(i)->beams ? state.shown(i)->beams->count : 0);
    if (what == "beam_planarity")
      return text_of(state.shown(i) && state.shown(i)->beams ? state.shown(i)->beams->planarity : -1);
    if (what == "sides")
      return count(state.shown(i) && state.shown(i)->thickness ? state.shown(i)->thickness->sides.count : 0);
    return std::nullopt;
  }
  if (key == "hovered_edge") return count(c.viewport.hovered_edge().value_or(-1));
  if (key == "browser_open") return flag(c.window.browser.is_open());
  if (key == "camera") {
    const Vector3d eye = c.viewport.camera().eye();
    char buffer[96];
    std::snprintf(buffer, sizeof buffer, "%.4g,%.4g,%.4g", eye.x(), eye.y(), eye.z());
    return std::string(buffer);
  }
  if (key == "drain_median_ms") return text_of(state.timings.drain.median());
  if (key == "drain_max_ms") return text_of(state.timings.drain.max());
  if (key == "upload_median_ms") return text_of(state.timings.upload.median());
  if (key == "upload_max_ms") return text_of(state.timings.upload.max());
  if (key == "frame_median_ms") return text_of(state.timings.frame.median());
  if (key == "frame_max_ms") return text_of(state.timings.frame.max());
  if (key == "stream_median_ms") return text_of(state.timings.stream.median());
  if (key == "stream_cpu_max_ms") return text_of(state.timings.stream_cpu.max());
  if (key == "stream_max_ms") return text_of(state.timings.stream.max());
  return std::nullopt;
}

}  // namespace planewright::ui
