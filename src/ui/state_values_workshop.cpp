// What scripts ask of the workshop: verdicts, terms, the export dialog and the schedule.
#include <algorithm>

#include "core/workshop/tolerance_share.h"
#include "ui/export_text.h"
#include "ui/state_values.h"

namespace planewright::ui {
namespace {

// passing, failing: panels, "none" until that is known; failures: places; failure: the row that the designer
// is at, -1 for none; failure.ROW.text, .panel; names: whether they are written on the panels, names_drawn:
// how many; name.PANEL; thickness, gap, density; limit_NAME of the sheet ("none": there is none).
std::optional<std::string> workshop_value(const DriverContext& c, const std::string& key) {
  const AppState& state = c.state;
  const auto workshop = state.workshop();
  const FailureList& list = state.failure_list();
  const WorkshopContract& contract = state.contract();
  if (key == "passing") return workshop ? std::to_string(workshop->verdicts.passed) : "none";
  if (key == "failing") return workshop ? std::to_string(workshop->verdicts.failed) : "none";
  if (key == "failures") return workshop ? std::to_string(workshop->verdicts.failures.size()) : "none";
  if (key == "failure") return text_of(state.current_failure().value_or(-1));
  if (key == "names") return std::string(state.view_options.names ? "1" : "0");
  if (key == "names_drawn") return text_of(c.viewport.names_drawn());
  if (key == "contract_thickness") return text_of(contract.thickness);
  if (key == "gap") return text_of(contract.gap);
  if (key == "density") return text_of(contract.density);
  if (key == "shares_break") {  // of the colours: failing panels that do not show as failing, and the other
                                // way round
    if (!workshop) return "none";
    const Vector shares = tolerance_shares(workshop->passports, workshop->verdicts, contract.tolerances);
    int wrong = 0;
    for (std::size_t p = 0; p < workshop->verdicts.pass.size(); ++p)
      wrong += workshop->verdicts.pass[p] != (shares[static_cast<Eigen::Index>(p)] <= 1.0) ? 1 : 0;
    return text_of(wrong);
  }
  if (key.starts_with("name.") || key.starts_with("failure.")) {
    const std::size_t begin = key.find('.') + 1, dot = key.find('.', begin);
    const auto index = number_in(key.substr(begin, dot == std::string::npos ? dot : dot - begin));
    if (!index || !workshop || *index < 0) return std::nullopt;
    const auto i = static_cast<std::size_t>(*index);
    if (key.starts_with("name."))
      return i < workshop->model->names.size() ? std::optional(workshop->model->names[i]) : std::nullopt;
    if (*index >= list.size() || dot == std::string::npos) return std::nullopt;
    const ToleranceFailure& failure = list.failure(static_cast<int>(i));
    if (key.substr(dot) == ".text") return describe(failure, *workshop->model);
    if (key.substr(dot) == ".panel") return text_of(failure.panel);
    return std::nullopt;
  }
  const auto limit = [](const std::optional<double>& value) { return value ? text_of(*value) : "none"; };
  const ToleranceSheet& sheet = contract.tolerances;
  if (key == "limit_planarity") return limit(sheet.planarity);
  if (key == "limit_edge_min") return limit(sheet.edge_min);
  if (key == "limit_edge_max") return limit(sheet.edge_max);
  if (key == "limit_area_max") return limit(sheet.area_max);
  if (key == "limit_stock") return limit(sheet.stock ? std::optional(sheet.stock->width) : std::nullopt);
  return std::nullopt;
}

// Of the export dialog. export_open; export_why: why nothing can be exported, or empty; export_preparing,
// export_running; export_sheets (drawings), export_sheet (that is seen, from 0), export_sheet_line,
// export_filled, export_parts_unplaced, export_failing, export_remarks: "none" until they are known;
// export_zoom: pixels per mm; export_refusal, export_error; export_stopped; export_pass, export_files,
// export_folder: of the newest result, "none" before it; export_chosen_folder, export_formats: of the dialog.
std::optional<std::string> export_value(const DriverContext& c, const std::string& key) {
  const AppState& state = c.state;
  const ExportDialog& dialog = c.window.export_dialog;
  const auto flag = [](bool on) { return std::string(on ? "1" : "0"); };
  if (key == "export_open") return flag(dialog.open);
  if (key == "export_why") return state.why_no_export() ? state.why_no_export()->what : "";
  if (key == "export_preparing") return flag(state.export_preparing());
  if (key == "export_running") return flag(state.exporting_to_workshop());
  if (key == "export_stopped") return flag(state.export_stopped());
  if (key == "export_refusal") return state.export_refusal() ? state.export_refusal()->what : "";
  if (key == "export_error") return state.export_error() ? state.export_error()->text() : "";
  if (key == "export_chosen_folder") return dialog.folder;
  if (key == "export_zoom") return text_of(dialog.preview.pixels_per_mm());
  if (key == "export_sheet") return text_of(dialog.sheet);
  if (key == "export_formats") {
    std::string names;
    for (const ExportFormat format : c.window.settings.workshop_export.formats)
      names.append(names.empty() ? "" : " ").append(name_of(format));
    return names;
  }
  const auto& outcome = state.export_outcome();
  if (key == "export_pass") return outcome ? flag(outcome->certificate.pass()) : "none";
  if (key == "export_files") return outcome ? std::to_string(outcome->files.size()) : "none";
  if (key == "export_folder") return outcome ? outcome->folder.string() : "none";
  if (!key.starts_with("export_")) return std::nullopt;
  const PreparedExport* prepared = state.export_preparation();
  if (prepared == nullptr) return "none";
  const ExportPreparation& made = prepared->made;
  if (key == "export_sheets") return std::to_string(made.drawings.size());
  if (key == "export_sheet_line") return sheet_line(made, dialog.sheet);
  if (key == "export_filled") return text_of(made.nesting ? made.nesting->filled : 0.0);
  if (key == "export_parts_unplaced") return std::to_string(made.nesting ? made.nesting->unplaced.size() : 0);
  if (key == "export_failing") return text_of(made.verdicts.failed);
  if (key == "export_remarks") return std::to_string(made.remarks.size());
  if (key == "export_first_part") {  // of the sheet that is seen
    if (!made.nesting || dialog.sheet >= static_cast<int>(made.nesting->sheets.size())) return "none";
    const auto& parts = made.nesting->sheets[static_cast<std::size_t>(dialog.sheet)].parts;
    return parts.empty() ? "none" : prepared->job.model->names[static_cast<std::size_t>(parts.front().panel)];
  }
  if (key == "export_first_panel") {
    if (!made.nesting || dialog.sheet >= static_cast<int>(made.nesting->sheets.size())) return "none";
    const auto& parts = made.nesting->sheets[static_cast<std::size_t>(dialog.sheet)].parts;
    return text_of(parts.empty() ? -1 : parts.front().panel);
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

std::optional<std::string> workshop_state_value(const DriverContext& c, const std::string& key) {
  if (auto value = workshop_value(c, key)) return value;
  if (auto value = schedule_value(c, key)) return value;
  return export_value(c, key);
}

}  // namespace planewright::ui
