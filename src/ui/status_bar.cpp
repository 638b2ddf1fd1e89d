// One sentence at the bottom: what is going on, and what came of it.
#include <cmath>

#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

std::string sentence(const Desk& desk) {
  const AppState& state = desk.state;
  const std::string unit = desk.state.unit();
  if (state.loading()) return "Opening " + state.loading_name() + " …";
  if (state.exporting()) return "Writing the panels …";
  if (state.saving()) return "Saving the project …";
  if (state.exporting_to_workshop()) return "Exporting for the workshop: " + state.export_stage().name + " …";
  if (state.document().empty()) return "Drop a mesh on the window, or press Ctrl O.";
  if (state.clustering() && !state.solving()) return "Clustering …";
  const auto& shown = state.shown();
  if (state.solving()) {
    const bool polishing = state.polishing();
    std::string text = polishing ? "Polishing with Ipopt" : "Solving";
    if (!state.history().empty()) {
      const Iteration& at = state.history().back();
      text += ": step " + format_count(at.number) + ", infeasibility " +
              format_with_unit(at.infeasibility, "edges") + ", " + format_duration(at.seconds);
      if (at.restoration) text += ", looking for a feasible place";
    }
    return text +
           (polishing ? ". Space stops and keeps the panels." : ". Space stops and keeps the best state.");
  }
  if (!shown) return "Ready. Space solves.";
  std::string text = "Ready. " + format_count(shown->complex().plane_count(), "panel", "panels") +
                     ", largest deviation " + format_with_unit(shown->planarity.max, unit);
  const auto findings = state.findings();
  if (!findings) return text + ".";
  if (!findings->diagnosis.solved) return text + ", not planar yet.";
  const auto count = static_cast<std::int64_t>(findings->diagnosis.findings.size());
  text += count == 0 ? ", no findings."
                     : ", " + format_count(count, "finding", "findings") + " (N shows the next).";
  return text;
}

}  // namespace

void draw_status_bar(Desk& desk, const Rect& place) {
  Ui& ui = desk.ui;
  if (!begin_part("##status", place, ImVec2(ui.px(14), 0), ImGuiWindowFlags_NoScrollbar)) return;
  const Ui::Scope scope(ui, "Status");
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = ui.colours();
  const std::string right = "orbit: drag   pan: shift drag   zoom: wheel   keys: ?";
  ImFont* small = ui.theme().small();
  const float right_width = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0, right.c_str()).x;
  const float room = place.width() - right_width - ui.px(56);

  float left = place.min.x + ui.px(14);
  if (desk.state.busy() || desk.state.loading() || desk.state.exporting() || desk.state.saving() ||
      desk.state.exporting_to_workshop()) {
    // Something turns while something runs.
    const ImVec2 centre(left + ui.px(6), 0.5f * (place.min.y + place.max.y));
    const auto angle = static_cast<float>(std::fmod(ImGui::GetTime() * 4.0, 6.283185307179586));
    draw.PathArcTo(centre, ui.px(5), angle, angle + 4.2f, 18);
    draw.PathStroke(p.accent, 0, ui.px(2));
    left += ui.px(20);
  }
  draw_text_aligned(draw, small, ImVec2(left, place.min.y), place.max, 0.0f, p.ink,
                    elided(small, sentence(desk), room));
  draw_text_aligned(draw, small, place.min, ImVec2(place.max.x - ui.px(14), place.max.y), 1.0f, p.ink_faint,
                    right);
  draw_rim(ui, place, Side::Top);
  end_part();
}

}  // namespace planewright::ui
