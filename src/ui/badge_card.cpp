// The badge over the model, top left, and beside it the button that asks for a polish.
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include "ui/panels.h"
#include "ui/solve_badge.h"

namespace planewright::ui {
namespace {

constexpr float kHeight = 26;   // at scale 1, like all below
constexpr float kMark = 24;     // room for the dot or the check
constexpr float kBetween = 25;  // between two columns, a thin line in the middle
constexpr float kEnd = 13;

float width_of(ImFont* font, const std::string& text) {
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
}

// As wide as what usually stands in them, and there while they are empty, so that nothing moves while the
// numbers do.
struct Column {
  const std::string* text;
  float width;
};

std::vector<Column> columns_of(const SolveBadge& badge, ImFont* font, const std::string& unit) {
  const auto column = [&](const std::string& text, std::initializer_list<std::string> usual) {
    float width = width_of(font, text);
    for (const std::string& other : usual) width = std::max(width, width_of(font, other));
    return Column{&text, std::ceil(width)};
  };
  return {column(badge.headline, {"Polishing with Ipopt", "Tangent, converged"}),
          column(badge.planarity, {"planar to 8.8e-88 " + unit}),
          column(badge.pace, {"step 888, 88.8 s", "88 steps, 888 ms"})};
}

float width_of(const Ui& ui, const std::vector<Column>& columns) {
  float width = ui.px(kMark + kEnd) + ui.px(kBetween) * static_cast<float>(columns.size() - 1);
  for (const Column& column : columns) width += column.width;
  return width;
}

void draw_mark(const Ui& ui, SolveBadge::Tone tone, ImVec2 min, ImVec2 max) {
  const Palette& p = ui.colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 middle(min.x + ui.px(13), 0.5f * (min.y + max.y));
  using Tone = SolveBadge::Tone;
  const ImU32 colour = tone == Tone::Busy      ? p.accent
                       : tone == Tone::Quiet   ? p.ink_faint
                       : tone == Tone::Warning ? p.warning
                                               : p.good;
  if (tone != Tone::Confirmed) {
    draw.AddCircleFilled(middle, ui.px(4), colour, 16);
    return;
  }
  const std::array<ImVec2, 3> check = {ImVec2(middle.x - ui.px(4.5f), middle.y + ui.px(0.5f)),
                                       ImVec2(middle.x - ui.px(1.2f), middle.y + ui.px(3.8f)),
                                       ImVec2(middle.x + ui.px(5), middle.y - ui.px(3.8f))};
  draw.AddPolyline(check.data(), static_cast<int>(check.size()), colour, 0, ui.px(2.2f));
}

void draw_pill(const Ui& ui, const SolveBadge& badge, const std::vector<Column>& columns, ImVec2 min,
               ImVec2 max) {
  const Palette& p = ui.colours();
  ImFont* font = ui.theme().small();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float round = 0.5f * (max.y - min.y);
  draw.AddRectFilled(min, max, with_alpha(p.overlay, 0.92f), round);
  draw.AddRect(min, max, p.line, round);
  draw_mark(ui, badge.tone, min, max);
  float x = min.x + ui.px(kMark);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0) {
      const float line = std::round(x + 0.5f * ui.px(kBetween)) + 0.5f;
      if (!columns[i].text->empty())
        draw.AddLine(ImVec2(line, min.y + ui.px(6)), ImVec2(line, max.y - ui.px(6)), p.line);
      x += ui.px(kBetween);
    }
    draw_text_aligned(draw, font, ImVec2(x, min.y), ImVec2(x + columns[i].width, max.y), 0.0f,
                      i == 0 ? p.ink : p.ink_soft, *columns[i].text);
    x += columns[i].width;
  }
}

// Below the badge, so that it does not hide what it explains.
void draw_details(Ui& ui, const SolveBadge& badge, ImVec2 at) {
  const float width = ui.px(250);
  ImGui::SetNextWindowPos(at);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(12), ui.px(9)));
  ImGui::BeginTooltip();
  ui.heading(badge.headline);
  ImGui::Dummy(ImVec2(width, 0));
  // A tooltip is as wide as what is in it, so rows that reach to its edge need one of their own.
  if (!badge.details.empty()) {
    const float row = ImGui::GetTextLineHeight() + ui.px(3);
    const ImVec2 size(width, row * static_cast<float>(badge.details.size()) + ui.px(4));
    ImGui::BeginChild("details", size, false, ImGuiWindowFlags_NoScrollbar);
    for (const auto& [name, value] : badge.details) ui.value_row(name, value);
    ImGui::EndChild();
  }
  if (!badge.explanation.empty()) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    ImGui::PushFont(ui.theme().small());
    ui.text(badge.explanation, ui.colours().ink_soft);
    ImGui::PopFont();
    ImGui::PopTextWrapPos();
  }
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

std::string polish_tooltip(const Desk& desk) {
  const AppState& state = desk.state;
  const std::string key = "  (" + info(Action::Polish).shortcut + ")";
  if (state.can_polish())
    return "Ipopt, the general solver, goes on from these panels and confirms them. It takes longer." + key;
  if (state.polishing()) return "Ipopt is at work. Space stops it; a change supersedes it.";
  if (state.solving()) return "Possible when the solve is through" + key;
  if (state.polished()) return "Ipopt has gone over these panels already.";
  return "There is no finished solve of this design to polish.";
}

}  // namespace

void draw_solve_badge(Desk& desk, const Rect& viewport) {
  Ui& ui = desk.ui;
  const std::string unit = desk.state.unit();
  const SolveBadge badge = solve_badge(standing_of(desk.state), unit);
  if (badge.headline.empty()) return;
  ImFont* font = ui.theme().small();
  const float room = viewport.width() - 2 * ui.px(12), gap = ui.px(6), height = ui.px(kHeight);

  ButtonLook look;
  look.has_icon = true;
  look.icon = Icon::Done;
  look.enabled = desk.actions.enabled(Action::Polish);
  look.tooltip = polish_tooltip(desk);
  const std::string label = info(Action::Polish).label;
  const std::string icon = ui.theme().icon(look.icon);
  look.width = std::ceil(width_of(font, label) + width_of(font, icon) + ui.px(icon.empty() ? 24 : 30));

  // In a narrow view the least important goes first.
  std::vector<Column> columns = columns_of(badge, font, unit);
  if (width_of(ui, columns) + gap + look.width > room) columns.pop_back();
  const bool with_button = width_of(ui, columns) + gap + look.width <= room;
  while (columns.size() > 1 && width_of(ui, columns) > room) columns.pop_back();
  const float pill = std::min(std::ceil(width_of(ui, columns)), room);
  columns.front().width = std::min(columns.front().width, pill - ui.px(kMark + kEnd));
  if (columns.front().width <= 0) return;

  ImGui::SetNextWindowPos(ImVec2(viewport.min.x + ui.px(12), viewport.min.y + ui.px(12)));
  ImGui::SetNextWindowSize(ImVec2(pill + (with_button ? gap + look.width : 0), height));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin("##badge", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  {
    const Ui::Scope scope(ui, "Badge");
    const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + pill, min.y + height);
    ImGui::Dummy(ImVec2(pill, height));
    ui.record_item("badge");
    draw_pill(ui, badge, columns, min, max);
    if (ImGui::IsItemHovered()) draw_details(ui, badge, ImVec2(min.x, max.y + ui.px(6)));
    if (with_button) {
      ImGui::SameLine(0, gap);
      ImGui::PushFont(font);
      ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(12), 0.5f * (height - font->FontSize)));
      ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, 0.5f * height);
      if (ui.button("polish", label, look)) desk.actions.request(Action::Polish);
      ImGui::PopStyleVar(2);
      ImGui::PopFont();
    }
  }
  ImGui::End();
}

}  // namespace planewright::ui
