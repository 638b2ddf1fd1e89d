// Cards over the model: messages, what to try first, and help. None of them blocks anything.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "ui/format.h"
#include "ui/panels.h"
#include "ui/viewport.h"
#include "ui/viewport_overlays.h"

namespace planewright::ui {
namespace {

// A floating card with a thin frame; `pivot` says which of its corners stands at `at`. `in_front`: the
// designer asked for it, so it comes before everything else.
bool begin_card(Ui& ui, const char* name, ImVec2 at, ImVec2 pivot, float width, bool in_front = false) {
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowSize(ImVec2(width, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(14), ui.px(11)));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, to_vec4(ui.colours().overlay));
  ImGuiWindowFlags flags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  if (!in_front) flags |= ImGuiWindowFlags_NoFocusOnAppearing;
  return ImGui::Begin(name, nullptr, flags);
}

void end_card() {
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

bool close_cross(Ui& ui, std::string_view name) {
  const float size = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetWindowWidth() - size - ui.px(8));
  ButtonLook look;
  look.quiet = true;
  look.has_icon = true;
  look.icon = Icon::Close;
  look.width = size;
  look.tooltip = "Close";
  const ImVec2 at = ImGui::GetCursorPos();
  ImGui::SetCursorPosY(at.y - ui.px(4));
  return ui.button(name, ui.theme().has_icons() ? "" : "x", look);
}

void key_row(Ui& ui, const char* keys, const char* what) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float row = ImGui::GetTextLineHeight() + ui.px(5);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw_text_aligned(draw, ui.theme().regular(), at, ImVec2(at.x + ui.px(118), at.y + row), 0.0f,
                    ui.colours().ink, keys);
  draw_text_aligned(draw, ui.theme().regular(), ImVec2(at.x + ui.px(122), at.y),
                    ImVec2(at.x + ui.px(400), at.y + row), 0.0f, ui.colours().ink_soft, what);
  ImGui::Dummy(ImVec2(ui.px(340), row - ImGui::GetStyle().ItemSpacing.y));
}

struct KeyRow {
  std::string keys, what;
};
struct KeySection {
  const char* title;
  std::vector<KeyRow> rows;
};

// Keys of actions by where they belong, and what the mouse does.
std::vector<KeySection> key_sections() {
  KeySection design{"Design", {}}, view{"View", {}}, ways{"From place to place", {}},
      selection{"Selection and layers", {}}, clusters{"Clusters", {}};
  for (const ActionInfo& action : action_list()) {
    if (action.shortcut.empty()) continue;
    const Action a = action.action;
    KeySection& of = a >= Action::SplitRegion && a <= Action::NextSight             ? clusters
                     : a >= Action::SelectBox && a <= Action::HideLayer             ? selection
                     : a >= Action::NextFinding && a <= Action::ApplyAllSuggestions ? ways
                     : a >= Action::Fit                                             ? view
                                                                                    : design;
    of.rows.push_back(
        {action.shortcut, a == Action::SolveOrStop ? "Solve, or stop and keep the best" : action.label});
  }
  const KeySection mouse{"Mouse",
                         {{"drag", "orbit round what is there"},
                          {"shift drag", "pan (also middle or right button)"},
                          {"wheel", "zoom to the mouse"},
                          {"double click", "centre on the point"},
                          {"click an edge", "flip it and solve again"},
                          {"right click", "all edits of what is there"},
                          {"click", "select a panel or corner"},
                          {"shift, ctrl click", "select more, or less"},
                          {"alt click", "select the loop through an edge"},
                          {"drag a pin", "move it in the view's plane"}}};
  const KeySection sliders{
      "Sliders", {{"drag, wheel", "change"}, {"double click", "reset"}, {"ctrl click", "type the number"}}};
  return {design, view, ways, mouse, selection, clusters, sliders};
}

// As many columns as the window is wide for; what is too high for it can be scrolled.
void draw_keys_card(Desk& desk) {
  Ui& ui = desk.ui;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const std::vector<KeySection> sections = key_sections();
  const float column = ui.px(352), row = ImGui::GetTextLineHeight() + ui.px(5), head = row + ui.px(20);
  const int columns = std::clamp(static_cast<int>((screen.x - ui.px(60)) / column), 1, 3);
  float all = 0;
  for (const KeySection& section : sections) all += head + row * static_cast<float>(section.rows.size());
  // A section goes on in the next column where this one has had its share.
  std::vector<std::vector<const KeySection*>> laid(1);
  float used = 0, highest = 0;
  for (const KeySection& section : sections) {
    const float height = head + row * static_cast<float>(section.rows.size());
    if (used > 0 && used + 0.5f * height > all / static_cast<float>(columns) &&
        static_cast<int>(laid.size()) < columns) {
      laid.emplace_back();
      used = 0;
    }
    laid.back().push_back(&section);
    used += height;
    highest = std::max(highest, used);
  }
  if (begin_card(ui, "##keys", ImVec2(0.5f * screen.x, 0.5f * screen.y), ImVec2(0.5f, 0.5f),
                 column * static_cast<float>(columns) + ui.px(28), true)) {
    const Ui::Scope scope(ui, "Keys");
    ui.heading("Keys and mouse");
    if (close_cross(ui, "close")) desk.window.show_keys = false;
    ui.separator();
    ImGui::BeginChild("rows", ImVec2(0, std::min(highest + ui.px(10), screen.y - ui.px(110))));
    for (std::size_t c = 0; c < laid.size(); ++c) {
      if (c > 0) ImGui::SameLine(static_cast<float>(c) * column);
      ImGui::BeginGroup();
      for (const KeySection* section : laid[c]) {
        ui.heading(section->title);
        for (const KeyRow& each : section->rows) key_row(ui, each.keys.c_str(), each.what.c_str());
        ui.gap(14);
      }
      ImGui::EndGroup();
    }
    ImGui::EndChild();
  }
  end_card();
}

void draw_timings_card(Desk& desk) {
  Ui& ui = desk.ui;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  if (begin_card(ui, "##timings", ImVec2(0.5f * screen.x, ui.px(96)), ImVec2(0.5f, 0), ui.px(440))) {
    const Ui::Scope scope(ui, "Timings");
    ui.heading("Timings of the window's own thread");
    if (close_cross(ui, "close")) desk.window.show_timings = false;
    ui.separator();
    const FrameTimings& t = desk.state.timings;
    const float width = ImGui::GetContentRegionAvail().x;
    const float row = ImGui::GetTextLineHeight() + ui.px(4);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto line = [&](const std::string& name, const std::string& count, const std::string& median,
                          const std::string& most, ImFont* font, ImU32 ink) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const auto cell = [&](float to, float align, const std::string& text) {
        draw_text_aligned(draw, font, at, ImVec2(at.x + to * width, at.y + row), align, ink, text);
      };
      cell(1, 0, name);
      cell(0.62f, 1, count);
      cell(0.81f, 1, median);
      cell(1, 1, most);
      ImGui::Dummy(ImVec2(0, row - ImGui::GetStyle().ItemSpacing.y + ui.px(2)));
    };
    const auto series = [&](const char* name, const TimingSeries& s) {
      line(name, format_count(static_cast<std::int64_t>(s.count())), format_number(s.median()),
           format_number(s.max()), ui.theme().regular(), ui.colours().ink);
    };
    line("", "count", "median, ms", "most, ms", ui.theme().small(), ui.colours().ink_faint);
    series("Drain the solver", t.drain);
    series("Upload an iterate", t.upload);
    series("Drain and upload, a frame", t.stream);
    series("  of it processor time", t.stream_cpu);
    series("Prepare an iterate (worker)", t.prepare);
    series("Draw the model", t.scene);
    series("Draw the rest", t.panels);
    series("Whole frame", t.frame);
    ui.gap(4);
    if (ui.button("reset", "Start counting anew")) desk.state.timings.clear();
  }
  end_card();
}

void draw_about_card(Desk& desk) {
  Ui& ui = desk.ui;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  if (begin_card(ui, "##about", ImVec2(0.5f * screen.x, 0.5f * screen.y), ImVec2(0.5f, 0.5f), ui.px(430),
                 true)) {
    const Ui::Scope scope(ui, "About");
    ui.heading("Planewright " PLANEWRIGHT_VERSION);
    if (close_cross(ui, "close")) desk.window.show_about = false;
    ui.separator();
    ui.wrapped(
        "Turns freeform surfaces into planar panels, after “Variational Tangent Plane Intersection for "
        "Planar "
        "Polygonal Meshing” by Zimmer, Campen, Herkrath and Kobbelt.");
    ui.gap(6);
    ui.wrapped("MIT licence. With Ipopt, MUMPS, OpenMesh, Eigen, Dear ImGui, GLFW, GLM and FreeType.", 0,
               true);
  }
  end_card();
}

}  // namespace

void draw_hint(Desk& desk, const Rect& viewport) {
  if (!desk.window.settings.show_hint || desk.state.document().empty()) return;
  Ui& ui = desk.ui;
  const float width = std::min(ui.px(232), viewport.width() - ui.px(24));
  if (width < ui.px(200)) return;
  // In the corner where a model seldom is; beside the colours' legend where both have room, else above it.
  ImVec2 at(viewport.min.x + ui.px(12), viewport.max.y - ui.px(12));
  if (desk.state.shown() && desk.state.view_options.colours != ColourMap::None) {
    const ImVec2 legend = legend_size(ui);
    const float axes = ui.px(84);
    if (at.x + legend.x + ui.px(8) + width < viewport.max.x - axes) {
      at.x += legend.x + ui.px(8);
    } else {
      at.y -= legend.y + ui.px(8);
    }
  }
  if (begin_card(ui, "##hint", at, ImVec2(0, 1), width)) {
    const Ui::Scope scope(ui, "Hint");
    ui.heading("What to try");
    if (close_cross(ui, "close")) desk.window.settings.show_hint = false;
    const auto line = [&](const char* number, const char* text) {
      ImGui::PushFont(ui.theme().small());
      ui.text(number, ui.colours().accent);
      ImGui::SameLine(ui.px(28));
      ui.text(text);
      ImGui::PopFont();
    };
    line("1", "Drag a weight: the panels follow.");
    line("2", "Click a blue edge: it flips.");
    line("3", "Drop your own mesh here.");
  }
  end_card();
}

void draw_messages(Desk& desk, const Rect& viewport) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  float bottom = viewport.max.y - ui.px(12);
  const float width = std::min(ui.px(420), viewport.width() - ui.px(24));
  if (width < ui.px(160)) return;
  std::optional<std::uint64_t> dismissed;
  const auto& messages = desk.state.messages();
  for (auto it = messages.rbegin(); it != messages.rend(); ++it) {
    const Message& message = *it;
    const bool error = message.kind == Message::Kind::Error,
               warning = message.kind == Message::Kind::Warning || message.kind == Message::Kind::Refused;
    const ImU32 colour = error ? p.error : warning ? p.warning : p.good;
    const std::string id = "##message" + std::to_string(message.id);
    if (begin_card(ui, id.c_str(), ImVec2(viewport.max.x - ui.px(12), bottom), ImVec2(1, 1), width)) {
      const Ui::Scope scope(ui, "Message");
      const ImVec2 min = ImGui::GetWindowPos();
      const ImVec2 max(min.x + ImGui::GetWindowWidth(), min.y + ImGui::GetWindowHeight());
      ImDrawList& draw = *ImGui::GetWindowDrawList();
      draw.PushClipRect(min, max);
      draw.AddRectFilled(min, ImVec2(min.x + ui.px(4), max.y), colour, ui.px(3),
                         ImDrawFlags_RoundCornersLeft);
      draw.PopClipRect();
      const char* icon = ui.theme().icon(error ? Icon::Error : warning ? Icon::Warning : Icon::Done);
      if (*icon != '\0') {
        ui.text(icon, colour);
        ImGui::SameLine();
      }
      ImGui::BeginGroup();
      ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - ui.px(44));
      ImGui::PushFont(ui.theme().bold());
      ui.text(message.what + (message.what.ends_with('.') ? "" : "."));
      ImGui::PopFont();
      if (!message.where.empty()) {
        // Of a long path its end says most.
        const float room = ImGui::GetWindowWidth() - ImGui::GetCursorPosX() - ui.px(50);
        ui.small_text(elided_left(ui.theme().small(), message.where, room));
        ui.tooltip_if_hovered(message.where);
      }
      if (!message.remedy.empty()) ui.text(message.remedy, p.ink_soft);
      ImGui::PopTextWrapPos();
      ImGui::EndGroup();
      ImGui::SetCursorPosY(ui.px(9));
      ImGui::NewLine();
      ImGui::SetCursorPosY(ui.px(9));
      ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ImGui::GetFrameHeight() - ui.px(6));
      ButtonLook look;
      look.quiet = true;
      look.has_icon = true;
      look.icon = Icon::Close;
      look.width = ImGui::GetFrameHeight();
      if (ui.button("close " + std::to_string(message.id), ui.theme().has_icons() ? "" : "x", look))
        dismissed = message.id;
      bottom = min.y - ui.px(8);
    }
    end_card();
  }
  if (dismissed) desk.state.dismiss(*dismissed);
}

void draw_help_cards(Desk& desk) {
  if (desk.window.show_timings) draw_timings_card(desk);
  if (desk.window.show_about) draw_about_card(desk);
  if (desk.window.show_keys) draw_keys_card(desk);
}

}  // namespace planewright::ui
