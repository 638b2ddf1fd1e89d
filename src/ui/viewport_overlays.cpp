#include "ui/viewport_overlays.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>

#include "ui/finding_text.h"
#include "ui/format.h"
#include "ui/render/colour_map.h"

namespace planewright::ui {
namespace {

constexpr float kLegendBar = 10;  // height of the legend's colours at scale 1

ImU32 to_colour(glm::vec3 rgb) {
  return ImGui::ColorConvertFloat4ToU32(ImVec4(rgb.r, rgb.g, rgb.b, 1.0f));
}

}  // namespace

ImVec2 legend_size(const Ui& ui) {
  return {ui.px(284), 2 * ui.theme().small()->FontSize + ui.px(kLegendBar) + 3 * ui.px(8)};
}

std::string box_hint(const AppState& state) {
  return std::string("Drag a box round ") + (state.select_what == SelectWhat::Panels ? "panels" : "corners") +
         "  ·  Shift adds  ·  Ctrl removes  ·  Alt: only what is in sight  ·  Esc leaves";
}

void draw_tool_hint(Ui& ui, const Rect& place, const std::string& text) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = ui.colours();
  ImFont* font = ui.theme().small();
  const std::string fitting = elided(font, text, place.width() - ui.px(48));
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, fitting.c_str());
  const ImVec2 min(place.min.x + ui.px(12), place.min.y + ui.px(46));
  const ImVec2 max(min.x + size.x + 2 * ui.px(12), min.y + ui.px(26));
  draw.AddRectFilled(min, max, p.accent, ui.px(13));
  draw_text_aligned(draw, font, ImVec2(min.x + ui.px(12), min.y), max, 0.0f, p.on_accent, fitting);
}

void draw_label(Ui& ui, const Rect& place, const std::string& text, bool busy) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = ui.colours();
  ImFont* font = ui.theme().small();
  const float dot = ui.px(14);
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
  const ImVec2 min(place.min.x + ui.px(12), place.min.y + ui.px(12));
  const ImVec2 max(min.x + size.x + dot + ui.px(22), min.y + ui.px(26));
  draw.AddRectFilled(min, max, with_alpha(p.overlay, 0.92f), ui.px(13));
  draw.AddRect(min, max, p.line, ui.px(13));
  const ImVec2 centre(min.x + ui.px(14), 0.5f * (min.y + max.y));
  draw.AddCircleFilled(centre, ui.px(4), busy ? p.accent : p.ink_faint, 16);
  draw_text_aligned(draw, font, ImVec2(min.x + ui.px(10) + dot, min.y), max, 0.0f, p.ink, text);
}

void draw_legend(Ui& ui, const Rect& place, const render::ColourScale& scale, ColourMap colours) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = ui.colours();
  ImFont* font = ui.theme().small();
  const float bar = ui.px(kLegendBar), pad = ui.px(12);
  const ImVec2 size = legend_size(ui);
  const ImVec2 min(place.min.x + ui.px(12), place.max.y - ui.px(12) - size.y);
  const ImVec2 max(min.x + size.x, min.y + size.y);
  draw.AddRectFilled(min, max, with_alpha(p.overlay, 0.92f), ui.px(5));
  draw.AddRect(min, max, p.line, ui.px(5));

  const float x0 = min.x + pad, x1 = max.x - pad;
  float y = min.y + ui.px(8);
  draw_text_aligned(draw, font, ImVec2(x0, y), ImVec2(x1, y + font->FontSize), 0.0f, p.ink, scale.quantity);
  const std::string what = colours == ColourMap::Planarity      ? "corner to plane of its panel"
                           : colours == ColourMap::Displacement ? "point to wanted place"
                           : colours == ColourMap::Tolerances   ? "share of the limit, worst place"
                                                                : "worst at each panel";
  draw_text_aligned(draw, font, ImVec2(x0, y), ImVec2(x1, y + font->FontSize), 1.0f, p.ink_faint, what);
  y += font->FontSize + ui.px(4);
  // With a tolerance the bar has two stretches: what keeps it, and what misses it; like the map itself.
  constexpr double kKept = 0.34;
  const double span = scale.high - scale.low;
  const auto value_at = [&](double t) {
    if (!scale.tolerance) return scale.low + span * t;
    const double tolerance = *scale.tolerance;
    return t < kKept ? scale.low + (tolerance - scale.low) * t / kKept
                     : tolerance + (scale.high - tolerance) * (t - kKept) / (1 - kKept);
  };
  constexpr int kBands = 130;
  for (int i = 0; i < kBands; ++i) {
    const float a = x0 + (x1 - x0) * static_cast<float>(i) / kBands;
    const float b = x0 + (x1 - x0) * static_cast<float>(i + 1) / kBands;
    draw.AddRectFilled(ImVec2(a, y), ImVec2(b, y + bar),
                       to_colour(render::colour_of(scale, value_at((i + 0.5) / kBands))));
  }
  y += bar + ui.px(4);
  const ImVec2 low(x0, y), high(x1, y + font->FontSize);
  if (colours == ColourMap::Findings) {
    draw_text_aligned(draw, font, low, high, 0.0f, p.ink_soft, severity_word(0.0));
    draw_text_aligned(draw, font, low, high, 0.5f, p.ink_soft, severity_word(kHardToBuild));
    draw_text_aligned(draw, font, low, high, 1.0f, p.ink_soft, "not to be built");
    return;
  }
  if (colours == ColourMap::Tolerances) {
    const float x = x0 + static_cast<float>(kKept) * (x1 - x0), reach = ui.px(60);
    draw.AddLine(ImVec2(x, y - bar - ui.px(6)), ImVec2(x, y - ui.px(2)), p.ink_soft);
    draw_text_aligned(draw, font, low, high, 0.0f, p.ink_soft, "passes");
    draw_text_aligned(draw, font, ImVec2(x - reach, low.y), ImVec2(x + reach, high.y), 0.5f, p.ink, "limit");
    draw_text_aligned(draw, font, low, high, 1.0f, p.ink_soft, "fails, twice and more");
    return;
  }
  draw_text_aligned(draw, font, low, high, 0.0f, p.ink_soft, format_number(scale.low));
  draw_text_aligned(draw, font, low, high, 1.0f, p.ink_soft, format_with_unit(scale.high, scale.unit));
  const double middle = scale.tolerance ? kKept : 0.5;
  const float x = x0 + static_cast<float>(middle) * (x1 - x0);
  const std::string label = (scale.tolerance ? "planar ≤ " : "") + format_number(value_at(middle));
  const float half = 0.5f * font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, label.c_str()).x;
  draw.AddLine(ImVec2(x, y - bar - ui.px(6)), ImVec2(x, y - ui.px(2)), p.ink_soft);
  draw_text_aligned(draw, font, ImVec2(x - half, low.y), ImVec2(x + half, high.y), 0.5f, p.ink_soft, label);
}

void draw_axes(Ui& ui, const Rect& place, const render::Camera& camera) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = ui.colours();
  const ImVec2 centre(place.max.x - ui.px(44), place.max.y - ui.px(44));
  const float length = ui.px(24);
  const char* names[] = {"x", "y", "z"};
  struct Axis {
    ImVec2 tip;
    double depth;
    int index;
  };
  Axis axes[3];
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis = Vector3d::Unit(i);
    axes[i] = {ImVec2(centre.x + length * static_cast<float>(axis.dot(camera.right())),
                      centre.y - length * static_cast<float>(axis.dot(camera.up()))),
               axis.dot(camera.forward()), i};
  }
  std::sort(std::begin(axes), std::end(axes), [](const Axis& a, const Axis& b) { return a.depth > b.depth; });
  for (const Axis& axis : axes) {
    const ImU32 ink = axis.depth > 0.25 ? p.ink_faint : p.ink_soft;
    draw.AddLine(centre, axis.tip, ink, ui.px(1.5f));
    const ImVec2 at(centre.x + 1.42f * (axis.tip.x - centre.x), centre.y + 1.42f * (axis.tip.y - centre.y));
    draw_text_aligned(draw, ui.theme().small(), ImVec2(at.x - 6, at.y - 8), ImVec2(at.x + 6, at.y + 8), 0.5f,
                      ink, names[axis.index]);
  }
}

}  // namespace planewright::ui
