// Limits of the findings in the right panel: a field for each kind.
#include <imgui_internal.h>

#include <algorithm>
#include <string>

#include "ui/finding_limits.h"
#include "ui/finding_text.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

constexpr float kFieldWidth = 104;

void draw_limit(Ui& ui, FindingSettings& settings, FindingKind kind) {
  const std::string name = std::string("limit ") + info(kind).name;
  const double own = info(kind).threshold;
  double& threshold = settings[kind].threshold;
  const LimitLook about = limit_look(kind, threshold);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
  const float field = at.x + width - ui.px(kFieldWidth), reset_left = field - ui.px(22);
  draw_text_aligned(*ImGui::GetWindowDrawList(), ui.theme().small(), at, ImVec2(reset_left, at.y + height),
                    0.0f, threshold == own ? ui.colours().ink_soft : ui.colours().ink,
                    elided(ui.theme().small(), capitalised(kind_name(kind)), reset_left - at.x));
  if (threshold != own) {
    ImGui::SetCursorScreenPos(ImVec2(reset_left, at.y + 0.5f * (height - ui.px(18))));
    ButtonLook reset;
    reset.small = reset.quiet = reset.has_icon = true;
    reset.icon = Icon::Undo;
    reset.width = ui.px(18);
    reset.tooltip = "Back to the kind's own limit";
    if (ui.button(name + " reset", ui.theme().has_icons() ? "" : "0", reset)) threshold = own;
  }
  ImGui::SetCursorScreenPos(ImVec2(field, at.y));
  double shown = about.scale * threshold;
  QuantityLook look;
  look.unit = about.unit;
  look.per_pixel = about.per_pixel;
  look.reset_value = about.scale * own;
  look.least = 0.0;
  look.width = ui.px(kFieldWidth);
  look.tooltip = about.tooltip;
  if (ui.quantity(name, shown, look).changed)
    threshold = shown == look.reset_value ? own : shown / about.scale;
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(ImVec2(width, height - ImGui::GetStyle().ItemSpacing.y + ui.px(3)));
}

}  // namespace

std::string limits_summary(const Desk& desk) {
  const auto changed = static_cast<std::int64_t>(desk.window.settings.finding_limits.size());
  return changed > 0 ? format_count(changed) + " changed" : "";
}

void draw_limits(Desk& desk) {
  Ui& ui = desk.ui;
  FindingSettings settings = desk.state.finding_settings();
  for (const FindingKind kind : all_finding_kinds()) draw_limit(ui, settings, kind);
  ButtonLook all;
  all.enabled = settings != FindingSettings();
  all.width = -1;
  if (ui.button("limits reset", "All back to their own", all)) settings = {};
  if (settings == desk.state.finding_settings()) return;
  desk.state.set_finding_settings(settings);
  desk.window.settings.finding_limits = limits_of(settings);
}

}  // namespace planewright::ui
