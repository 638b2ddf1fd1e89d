// What the viewport shows of suggestions: a ghost of the edit that is pointed at, drawn over the picture, so
// that pointing at another costs no new one.
#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/format.h"
#include "ui/panels.h"
#include "ui/suggestion_text.h"
#include "ui/viewport_impl.h"

namespace planewright::ui {
namespace {

constexpr float kDash = 6, kGap = 4;  // pixels at scale 1

void dashed_line(ImDrawList& draw, ImVec2 a, ImVec2 b, ImU32 colour, float thickness, float dash, float gap) {
  const ImVec2 way(b.x - a.x, b.y - a.y);
  const float length = std::hypot(way.x, way.y);
  if (!(length > 0) || length > 1e4f) return;
  // A dash at both ends, so that a short line is one, too.
  const int dashes = std::max(1, static_cast<int>(std::round((length + gap) / (dash + gap))));
  const float period = (length + gap) / static_cast<float>(dashes);
  for (int i = 0; i < dashes; ++i) {
    const float from = static_cast<float>(i) * period / length;
    const float to = std::min((static_cast<float>(i) * period + period - gap) / length, 1.0f);
    draw.AddLine(ImVec2(a.x + from * way.x, a.y + from * way.y), ImVec2(a.x + to * way.x, a.y + to * way.y),
                 colour, thickness);
  }
}

}  // namespace

// The mesh lies behind panels that stand off it, so only what lies well before the place hides it.
bool Viewport::Impl::edit_in_sight(const AppState& state, const Vector3d& at) const {
  return in_sight(camera, at + 0.7 * state.mean_edge() * (camera.eye() - at).normalized());
}

std::optional<MeshEdit> Viewport::Impl::edit_pointed_at(const AppState& state) const {
  if (!mesh || mesh != state.mesh_view()) return std::nullopt;
  if (state.pointed_edit) return state.pointed_edit;
  const SuggestionList& list = state.suggestion_list();
  if (hovered) {
    if (state.document().may_edit(MeshEdit::flip(*hovered))) return MeshEdit::flip(*hovered);
    const Suggestion* best = list.best_at(*hovered);
    return best != nullptr ? std::optional(best->candidate.edit) : std::nullopt;
  }
  const auto current = state.current_suggestion();
  return current ? std::optional(list.at(*current).candidate.edit) : std::nullopt;
}

void Viewport::Impl::draw_edit(Ui& ui, const AppState& state, const MeshEdit& edit,
                               const EditPreview* known) const {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = ui.colours();
  const Vector3d origin = state.scene_origin();
  const EditSketch lines = sketch(*state.document().mesh(), edit);
  const auto in_front = [&](const Vector3d& at) { return camera.depth(at) > 0; };
  const float alpha =
      in_front(lines.place - origin) && !edit_in_sight(state, lines.place - origin) ? 0.45f : 1.0f;
  const auto on_window = [&](const Vector3d& at) { return to_window(camera.project(at)); };
  const auto line = [&](const Vector3d& from, const Vector3d& to, ImU32 colour, float width, float gap) {
    const Vector3d a = from - origin, b = to - origin;
    if (in_front(a) && in_front(b))
      dashed_line(draw, on_window(a), on_window(b), colour, ui.px(width), ui.px(kDash), ui.px(gap));
  };
  if (known != nullptr) {
    for (const std::vector<Vector3d>& outline : known->panels) {
      std::vector<ImVec2> corners;
      for (const Vector3d& at : outline)
        if (in_front(at - origin)) corners.push_back(on_window(at - origin));
      if (corners.size() != outline.size()) continue;
      // Fans from the middle do for panels with a reflex corner; without smoothing they show no seams.
      ImVec2 middle(0, 0);
      for (const ImVec2& at : corners) {
        middle.x += at.x / static_cast<float>(corners.size());
        middle.y += at.y / static_cast<float>(corners.size());
      }
      const ImDrawListFlags flags = draw.Flags;
      draw.Flags &= ~ImDrawListFlags_AntiAliasedFill;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        draw.AddTriangleFilled(middle, corners[k], corners[(k + 1) % corners.size()],
                               with_alpha(p.accent, 0.10f * alpha));
      }
      draw.Flags = flags;
      draw.AddPolyline(corners.data(), static_cast<int>(corners.size()), with_alpha(p.accent, 0.85f * alpha),
                       ImDrawFlags_Closed, ui.px(1.6f));
    }
  }
  for (const auto& [a, b] : lines.gone) line(a, b, with_alpha(p.ink_soft, 0.8f * alpha), 1.2f, kDash);
  for (const auto& [a, b] : lines.made) line(a, b, with_alpha(p.accent, alpha), 2.6f, kGap);
}

// A ring where the edit is, so that it is found in a view of the whole.
void Viewport::Impl::ring_edit(Ui& ui, const AppState& state, const MeshEdit& edit) const {
  const Vector3d middle_of = sketch(*state.document().mesh(), edit).place - state.scene_origin();
  if (camera.depth(middle_of) <= 0) return;
  const float alpha = edit_in_sight(state, middle_of) ? 1.0f : 0.4f;
  const ImVec2 at = to_window(camera.project(middle_of));
  const auto edges = static_cast<float>(state.mean_edge() / camera.pixel_size_at(middle_of)) / pixel_ratio;
  const float radius = std::max(1.1f * edges, ui.px(11));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircle(at, radius, with_alpha(ui.colours().panel, 0.5f * alpha), 40, ui.px(4));
  draw.AddCircle(at, radius, with_alpha(ui.colours().accent, alpha), 40, ui.px(2));
}

void Viewport::Impl::draw_suggestions(Ui& ui, AppState& state) {
  previewed.reset();
  if (!mesh || mesh != state.mesh_view()) return;
  ImGui::GetWindowDrawList()->PushClipRect(place.min, place.max, true);
  if (state.pointed_all) {
    const SuggestionList& list = state.suggestion_list();
    for (const int i : list.together) {
      const MeshEdit& edit = list.from->ranked[static_cast<std::size_t>(i)].candidate.edit;
      ring_edit(ui, state, edit);
      draw_edit(ui, state, edit, nullptr);
    }
  } else if (const auto edit = edit_pointed_at(state)) {
    previewed = state.preview(*edit);
    if (state.pointed_edit) ring_edit(ui, state, *edit);
    draw_edit(ui, state, *edit, previewed.get());
  }
  ImGui::GetWindowDrawList()->PopClipRect();
}

// What the flip, or else the best edit there, would gain.
void Viewport::Impl::explain_gain(Ui& ui, const AppState& state, int edge, bool may_flip) const {
  const Palette& p = ui.colours();
  const SuggestionList& list = state.suggestion_list();
  const Suggestion* flip = may_flip ? list.best_at(edge, EditKind::Flip) : nullptr;
  const MeshEdit wanted = MeshEdit::flip(edge);
  const bool asked = state.advice_fits() && may_flip;
  if (flip == nullptr && previewed && previewed->edit == wanted && previewed->rated)
    flip = &*previewed->rated;
  if (flip != nullptr) {
    const double gain = flip->gain();
    ui.text((gain >= 0 ? "gains about " : "loses about ") + gain_text(std::abs(gain)),
            gain > 0 ? p.good : p.warning);
    draw_gain_parts(ui, *flip);
  } else if (asked && previewed && previewed->edit == wanted) {
    ui.small_text("Not advised: a panel would fold, or the design change too much.", p.ink_faint);
  } else if (asked) {
    ui.small_text("Rating it…", p.ink_faint);
  }
  const Suggestion* best = list.best_at(edge);
  if (best != nullptr && best->candidate.edit.kind != EditKind::Flip) {
    ui.small_text(capitalised(kind_word(best->candidate.edit.kind)) + " gains about " +
                      gain_text(best->gain()) + ": right click",
                  p.accent);
  }
}

}  // namespace planewright::ui
