#include "ui/export_dialog.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "ui/export_text.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/typed_path.h"

namespace planewright::ui {
namespace {

namespace fs = std::filesystem;

// DESIGN-workshop, beside what was opened or written last.
std::string first_folder(const Desk& desk) {
  std::error_code error;
  fs::path folder = desk.window.settings.last_folder;
  if (folder.empty() || !fs::is_directory(folder, error)) folder = fs::current_path(error);
  std::string stem = fs::path(desk.state.document().name()).stem().string();
  if (stem.empty()) stem = "panels";
  return (folder / (stem + "-workshop")).string();
}

// Why the button does nothing now; empty: it does.
std::string why_not(const Desk& desk) {
  const ExportDialog& dialog = desk.window.export_dialog;
  const AppState& state = desk.state;
  if (const auto why = state.why_no_export()) return why->what;
  if (state.export_refusal()) return "The sheets cannot be laid";
  const ExportChoice& choice = desk.window.settings.workshop_export;
  const auto writable = [&](ExportFormat format) { return !lacks_thickness(format, state.contract()); };
  if (std::none_of(choice.formats.begin(), choice.formats.end(), writable)) return "No format is chosen";
  if (dialog.folder.empty()) return "No folder is chosen";
  if (!state.workshop_fits()) return "The panels are being measured";
  return {};
}

// "out/" is "out": its parent is where "out" lies.
fs::path chosen_folder(const ExportDialog& dialog) {
  std::error_code error;
  const fs::path folder = fs::absolute(typed_path(dialog.folder), error).lexically_normal();
  return folder.has_filename() ? folder : folder.parent_path();
}

void start(Desk& desk) {
  const ExportDialog& dialog = desk.window.export_dialog;
  const fs::path folder = chosen_folder(dialog);
  if (desk.state.export_panels_to_workshop(desk.window.settings.workshop_export, folder, dialog.overwrite))
    desk.window.settings.last_folder = folder.parent_path().string();
}

void draw_header(Desk& desk) {
  Ui& ui = desk.ui;
  const float size = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const std::string title = "Export for the workshop";
  ImFont* bold = ui.theme().bold();
  draw_text_aligned(draw, bold, at, ImVec2(right, at.y + size), 0.0f, ui.colours().ink, title);
  const Document& document = desk.state.document();
  if (!document.empty()) {
    const float taken = bold->CalcTextSizeA(bold->FontSize, 1e6f, 0, title.c_str()).x + ui.px(14);
    std::string about = document.name();
    if (desk.state.shown())
      about += "  ·  " + format_count(desk.state.shown()->complex().plane_count(), "panel", "panels");
    if (desk.state.layer_count() > 1)
      about += " of " + document.design().layers[static_cast<std::size_t>(desk.state.active_layer())].name;
    about += "  ·  1 unit = 1 " + desk.state.unit();
    const ImVec2 from(at.x + taken, at.y);
    draw_text_aligned(draw, ui.theme().small(), from, ImVec2(right - size, at.y + size), 0.0f,
                      ui.colours().ink_soft, elided(ui.theme().small(), about, right - size - from.x));
  }
  ImGui::SetCursorScreenPos(ImVec2(right - size, at.y));
  ButtonLook look;
  look.quiet = look.has_icon = true;
  look.icon = Icon::Close;
  look.width = size;
  look.tooltip = desk.state.exporting_to_workshop() ? "Close; the export goes on  (Esc)" : "Close  (Esc)";
  if (ui.button("close", ui.theme().has_icons() ? "" : "x", look)) desk.window.export_dialog.open = false;
}

void draw_folder(Desk& desk) {
  Ui& ui = desk.ui;
  ExportDialog& dialog = desk.window.export_dialog;
  const float space = ImGui::GetStyle().ItemSpacing.x;
  ImGui::AlignTextToFramePadding();
  ui.text("Folder", ui.colours().ink_soft);
  ImGui::SameLine(ui.px(62));
  const std::string overwrite = "Overwrite existing files";
  const float check = ui.px(25) + ImGui::CalcTextSize(overwrite.c_str()).x, browse = ui.px(34);
  ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - check - browse - 3 * space, ui.px(80)));
  if (ImGui::InputTextWithHint("##folder", "where the files go", &dialog.folder))
    desk.state.forget_export_outcome();
  ui.record_item("folder");
  ImGui::SameLine();
  ButtonLook look;
  look.width = browse;
  look.tooltip = "Choose the folder";
  if (ui.button("browse", "…", look)) {
    const fs::path folder = chosen_folder(dialog);
    desk.window.browser.open(FileBrowser::Purpose::ChooseFolder, folder.parent_path(),
                             folder.filename().string());
  }
  ImGui::SameLine(0, 2 * space);
  if (ui.checkbox("overwrite", overwrite, dialog.overwrite,
                  "Files of an earlier export in this folder are replaced; those that are no longer written "
                  "go. Other files stay."))
    desk.state.forget_export_outcome();
}

void draw_progress(Desk& desk, ImVec2 min, ImVec2 max) {
  Ui& ui = desk.ui;
  const ExportStage stage = desk.state.export_stage();
  const double fraction = std::clamp(stage.fraction, 0.0, 1.0);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float middle = std::round(0.5f * (min.y + max.y));
  const std::string words = desk.state.export_stopping() ? "Stopping" : stage_text(stage.name);
  draw_text_aligned(draw, ui.theme().regular(), min, ImVec2(max.x, middle), 0.0f, ui.colours().ink, words);
  draw_text_aligned(draw, ui.theme().small(), min, ImVec2(max.x, middle), 1.0f, ui.colours().ink_soft,
                    std::to_string(std::lround(100 * fraction)) + " %");
  const ImVec2 a(min.x, middle + ui.px(4)), b(max.x, middle + ui.px(10));
  draw.AddRectFilled(a, b, ui.colours().hovered, ui.px(3));
  draw.AddRect(a, b, ui.colours().line, ui.px(3));
  if (fraction > 0)
    draw.AddRectFilled(a, ImVec2(a.x + std::max(static_cast<float>(fraction) * (b.x - a.x), ui.px(4)), b.y),
                       ui.colours().accent, ui.px(3));
  ui.record("progress", a, b);
}

// Icon and words in colour, and below them what else is to be known.
void draw_result(Ui& ui, const char* name, Icon icon, ImU32 colour, const std::string& what,
                 const std::string& more, ImVec2 min, ImVec2 max) {
  ImGui::PushClipRect(min, max, true);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ImFont* font = ui.theme().regular();
  const float indent = ui.theme().has_icons() ? ui.px(24) : 0.0f;
  const float width = max.x - min.x - indent;
  draw.AddText(font, font->FontSize, ImVec2(min.x, min.y + 1), colour, ui.theme().icon(icon));
  const float high =
      std::min(font->CalcTextSizeA(font->FontSize, 1e6f, width, what.c_str()).y, 2 * font->FontSize);
  draw.PushClipRect(ImVec2(min.x + indent, min.y), ImVec2(max.x, min.y + high + 1), true);
  draw.AddText(font, font->FontSize, ImVec2(min.x + indent, min.y), colour, what.c_str(), nullptr, width);
  draw.PopClipRect();
  ImFont* small = ui.theme().small();
  draw.AddText(small, small->FontSize, ImVec2(min.x + indent, min.y + high + ui.px(3)), ui.colours().ink_soft,
               more.c_str(), nullptr, width);
  ImGui::PopClipRect();
  ui.record(name, min, max);
  if (ImGui::IsMouseHoveringRect(min, max) && ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) &&
      font->CalcTextSizeA(font->FontSize, 1e6f, width, what.c_str()).y > high)
    ui.tooltip(what);
}

void draw_standing(Desk& desk, ImVec2 min, ImVec2 max) {
  Ui& ui = desk.ui;
  const AppState& state = desk.state;
  if (state.exporting_to_workshop()) return draw_progress(desk, min, max);
  if (const auto& error = state.export_error()) {
    std::string more = error->remedy;
    // The folder that was to be written stands above.
    if (!error->where.empty() && error->where != state.export_target().string())
      more = elided_left(ui.theme().small(), error->where, max.x - min.x - ui.px(30)) +
             (more.empty() ? "" : "\n" + more);
    return draw_result(ui, "error", Icon::Error, ui.colours().error, capitalised(error->what), more, min,
                       max);
  }
  if (state.export_stopped())
    return draw_result(ui, "stopped", Icon::Stop, ui.colours().ink_soft, "Stopped: nothing was written", "",
                       min, max);
  if (const auto& outcome = state.export_outcome()) {
    const bool pass = outcome->certificate.pass();
    const float button = ui.px(112);
    const std::string page = (outcome->folder / "certificate.html").string();
    draw_result(ui, "result", pass ? Icon::Done : Icon::Error, pass ? ui.colours().good : ui.colours().error,
                outcome_line(*outcome),
                elided_left(ui.theme().small(), page, max.x - min.x - button - ui.px(36)), min,
                ImVec2(max.x - button - ui.px(8), max.y));
    ImGui::SetCursorScreenPos(ImVec2(max.x - button, min.y));
    ButtonLook look;
    look.has_icon = true;
    look.icon = Icon::Copy;
    look.width = button;
    look.tooltip = "The folder's path, to paste it elsewhere:\n" + outcome->folder.string();
    if (ui.button("copy path", "Copy path", look)) ImGui::SetClipboardText(outcome->folder.c_str());
    return;
  }
  const std::string why = why_not(desk);
  draw_text_aligned(
      *ImGui::GetWindowDrawList(), ui.theme().small(), min, ImVec2(max.x, min.y + ImGui::GetFrameHeight()),
      0.0f, why.empty() ? ui.colours().ink_soft : ui.colours().warning,
      why.empty() ? "Every file is read back and compared with the panels before it takes its place."
                  : why + ".");
}

void draw_footer(Desk& desk) {
  Ui& ui = desk.ui;
  ui.separator();
  draw_folder(desk);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end(at.x + ImGui::GetContentRegionAvail().x, at.y + ImGui::GetContentRegionAvail().y);
  const float button = ui.px(140);
  draw_standing(desk, at, ImVec2(end.x - button - ui.px(20), end.y));
  ImGui::SetCursorScreenPos(ImVec2(end.x - button, at.y));
  ButtonLook look;
  look.has_icon = true;
  look.width = button;
  if (desk.state.exporting_to_workshop()) {
    look.icon = Icon::Stop;
    look.enabled = !desk.state.export_stopping();
    look.tooltip = "Nothing is written then";
    if (ui.button("stop", "Stop", look)) desk.state.stop_export();
    return;
  }
  const std::string why = why_not(desk);
  look.icon = Icon::Export;
  look.primary = true;
  look.enabled = why.empty();
  look.tooltip = why;
  if (ui.button("export", "Export", look)) start(desk);
}

// Another design has another folder, project and note.
void follow_design(Desk& desk) {
  ExportDialog& dialog = desk.window.export_dialog;
  if (dialog.design == desk.state.opened_count() && !dialog.folder.empty()) return;
  dialog.design = desk.state.opened_count();
  dialog.folder = first_folder(desk);
  dialog.overwrite = false;
  dialog.sheet = 0;
  dialog.preview.fit();
  if (!desk.state.exporting_to_workshop()) desk.state.forget_export_outcome();
  ExportChoice& choice = desk.window.settings.workshop_export;
  choice.project.clear();
  choice.note.clear();
  // Sheets that the tolerances demand are those that there are.
  if (const auto& stock = desk.state.contract().tolerances.stock) choice.layout.sheet = *stock;
}

}  // namespace

void open_export_dialog(Desk& desk) {
  ExportDialog& dialog = desk.window.export_dialog;
  dialog.open = dialog.appearing = true;
  if (!desk.state.exporting_to_workshop()) desk.state.forget_export_outcome();
  follow_design(desk);
}

void draw_export_dialog(Desk& desk) {
  ExportDialog& dialog = desk.window.export_dialog;
  if (!dialog.open) return;
  if (dialog.design != desk.state.opened_count()) follow_design(desk);
  Ui& ui = desk.ui;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(0, 0));
  ImGui::SetNextWindowSize(screen);
  if (dialog.appearing) ImGui::SetNextWindowFocus();
  dialog.appearing = false;
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                           ImGuiWindowFlags_NoScrollWithMouse;
  if (desk.window.browser.is_open()) flags |= ImGuiWindowFlags_NoBringToFrontOnFocus;  // it stays above
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin("##export", nullptr, flags);
  ImGui::PopStyleVar();
  const Ui::Scope scope(ui, "Export");
  const ExportChoice before = desk.window.settings.workshop_export;

  // The model stays in sight round the card, dimmed.
  const ImVec2 size(std::min(ui.px(1100), screen.x - ui.px(32)), std::min(ui.px(740), screen.y - ui.px(32)));
  const ImVec2 min(std::round(0.5f * (screen.x - size.x)), std::round(0.5f * (screen.y - size.y)));
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(ImVec2(0, 0), screen, IM_COL32(24, 22, 18, 96));
  draw.AddRectFilled(ImVec2(min.x - ui.px(2), min.y + ui.px(1)), ImVec2(max.x + ui.px(2), max.y + ui.px(5)),
                     ui.colours().shadow, ui.px(9));
  draw.AddRectFilled(min, max, ui.colours().overlay, ui.px(7));
  draw.AddRect(min, max, ui.colours().line, ui.px(7));

  const float pad = ui.px(18), gap = ui.px(18), left = std::min(ui.px(318), 0.36f * size.x);
  const float top = min.y + ui.px(12), frame = ImGui::GetFrameHeight(), footer = frame + ui.px(82);
  ImGui::SetCursorScreenPos(ImVec2(min.x + pad, top));
  ImGui::BeginChild("header", ImVec2(size.x - 2 * pad, frame), false, ImGuiWindowFlags_NoScrollbar);
  draw_header(desk);
  ImGui::EndChild();
  const float body = top + frame + ui.px(8), body_height = max.y - footer - ui.px(10) - body;
  ImGui::SetCursorScreenPos(ImVec2(min.x + pad, body));
  ImGui::BeginChild("form", ImVec2(left, body_height));
  draw_export_form(desk);
  ImGui::EndChild();
  ImGui::SetCursorScreenPos(ImVec2(min.x + pad + left + gap, body));
  ImGui::BeginChild("sheets", ImVec2(size.x - 2 * pad - left - gap, body_height), false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_export_sheets(desk);
  ImGui::EndChild();
  ImGui::SetCursorScreenPos(ImVec2(min.x + pad, max.y - footer - ui.px(2)));
  ImGui::BeginChild("footer", ImVec2(size.x - 2 * pad, footer - ui.px(8)), false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_footer(desk);
  ImGui::EndChild();
  ImGui::End();
  // What was written is another thing than what is chosen now, here or by undoing.
  const bool changed =
      desk.window.settings.workshop_export != before || desk.state.contract() != dialog.contract;
  dialog.contract = desk.state.contract();
  if (changed && !desk.state.exporting_to_workshop()) desk.state.forget_export_outcome();
}

}  // namespace planewright::ui
