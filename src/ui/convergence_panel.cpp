// Below the model: objective and infeasibility against the steps of the solve, both on logarithmic scales.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

constexpr double kLeast = 1e-16;  // what a logarithmic axis shows of 0

// A logarithmic axis over whole decades.
struct DecadeAxis {
  int low = -1, high = 0;     // powers of ten
  float top = 0, bottom = 0;  // pixels

  static DecadeAxis around(const std::vector<Iteration>& history, double Iteration::*quantity, Rect plot) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Iteration& step : history) {
      const double value = std::abs(step.*quantity);
      if (!std::isfinite(value) || value < kLeast) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    DecadeAxis axis;
    axis.top = plot.min.y;
    axis.bottom = plot.max.y;
    if (most > 0) {
      axis.low = static_cast<int>(std::floor(std::log10(least) + 1e-9));
      axis.high = static_cast<int>(std::ceil(std::log10(most) - 1e-9));
      if (axis.high <= axis.low) axis.high = axis.low + 1;
    }
    return axis;
  }
  float at(double value) const {
    const double size = std::abs(value);
    const double power = size < kLeast ? low : std::log10(size);
    const double t = std::clamp((power - low) / (high - low), 0.0, 1.0);
    return bottom - static_cast<float>(t) * (bottom - top);
  }
  // At most five labels, in whole decades.
  int label_step() const { return std::max(1, (high - low + 3) / 4); }
};

std::string decade_label(int power) {
  if (power >= -2 && power <= 3) return format_number(std::pow(10.0, power));
  return "1e" + std::to_string(power);
}

// 1, 2, 5, 10, 20, ... so that about `wanted` ticks fit.
int tick_step(int range, int wanted) {
  int step = 1;
  while (range / step > wanted) {
    const int lead = step / static_cast<int>(std::pow(10, static_cast<int>(std::log10(step))));
    step = lead == 2 ? step / 2 * 5 : step * 2;
  }
  return step;
}

void draw_curve(ImDrawList& draw, const std::vector<Iteration>& history, double Iteration::*quantity,
                const DecadeAxis& axis, const std::vector<float>& x, ImU32 colour, float thickness) {
  std::vector<ImVec2> line;
  line.reserve(history.size());
  for (std::size_t i = 0; i < history.size(); ++i) {
    if (!std::isfinite(history[i].*quantity)) continue;
    line.emplace_back(x[i], axis.at(history[i].*quantity));
  }
  draw.AddPolyline(line.data(), static_cast<int>(line.size()), colour, 0, thickness);
  if (line.size() <= 60) {
    for (const ImVec2& point : line) draw.AddCircleFilled(point, thickness + 0.8f, colour, 10);
  }
}

void draw_plot(Desk& desk, const Rect& area) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  ImFont* small = ui.theme().small();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const std::vector<Iteration>& history = desk.state.history();
  const float line_height = small->FontSize;

  const Rect plot{{area.min.x + ui.px(58), area.min.y + ui.px(6)},
                  {area.max.x - ui.px(58), area.max.y - line_height - ui.px(8)}};
  if (plot.width() < 40 || plot.height() < 24) return;
  draw.AddRectFilled(plot.min, plot.max, p.raised);
  if (history.empty()) {
    draw.AddRect(plot.min, plot.max, p.line);
    draw_text_aligned(draw, small, plot.min, plot.max, 0.5f, p.ink_faint,
                      "The steps of a solve appear here.");
    return;
  }

  const DecadeAxis objective = DecadeAxis::around(history, &Iteration::objective, plot);
  const DecadeAxis infeasibility = DecadeAxis::around(history, &Iteration::infeasibility, plot);
  const int first = history.front().number;
  const int last = std::max(history.back().number, first + 1);
  std::vector<float> x(history.size());
  for (std::size_t i = 0; i < history.size(); ++i) {
    x[i] = plot.min.x + ui.px(6) +
           (plot.width() - ui.px(12)) * static_cast<float>(history[i].number - first) /
               static_cast<float>(last - first);
  }

  // Restoration: the solver has left the objective aside.
  for (std::size_t i = 0; i < history.size(); ++i) {
    if (!history[i].restoration) continue;
    const float from = i > 0 ? 0.5f * (x[i - 1] + x[i]) : x[i];
    const float to = i + 1 < x.size() ? 0.5f * (x[i] + x[i + 1]) : x[i];
    draw.AddRectFilled(ImVec2(from, plot.min.y), ImVec2(to, plot.max.y), with_alpha(p.warning, 0.14f));
  }

  // Grid and scales: objective left, infeasibility right, each in its curve's colour.
  for (int power = objective.low; power <= objective.high; power += objective.label_step()) {
    const float y = std::round(objective.at(std::pow(10.0, power))) + 0.5f;
    draw.AddLine(ImVec2(plot.min.x, y), ImVec2(plot.max.x, y), with_alpha(p.line, 0.7f));
    draw_text_aligned(draw, small, ImVec2(area.min.x, y - line_height),
                      ImVec2(plot.min.x - ui.px(6), y + line_height), 1.0f, p.objective, decade_label(power));
  }
  for (int power = infeasibility.low; power <= infeasibility.high; power += infeasibility.label_step()) {
    const float y = infeasibility.at(std::pow(10.0, power));
    draw.AddLine(ImVec2(plot.max.x - ui.px(4), y), ImVec2(plot.max.x, y), p.infeasibility);
    draw_text_aligned(draw, small, ImVec2(plot.max.x + ui.px(6), y - line_height),
                      ImVec2(area.max.x, y + line_height), 0.0f, p.infeasibility, decade_label(power));
  }
  const int step = tick_step(last - first, std::max(2, static_cast<int>(plot.width() / ui.px(90))));
  for (int number = (first + step - 1) / step * step; number <= last; number += step) {
    const float tick =
        plot.min.x + ui.px(6) +
        (plot.width() - ui.px(12)) * static_cast<float>(number - first) / static_cast<float>(last - first);
    draw.AddLine(ImVec2(tick, plot.max.y), ImVec2(tick, plot.max.y + ui.px(3)), p.ink_faint);
    draw_text_aligned(draw, small, ImVec2(tick - 40, plot.max.y + ui.px(4)),
                      ImVec2(tick + 40, plot.max.y + ui.px(4) + line_height), 0.5f, p.ink_soft,
                      format_count(number));
  }
  draw.AddRect(plot.min, plot.max, p.line);

  draw.PushClipRect(plot.min, plot.max, true);
  draw_curve(draw, history, &Iteration::infeasibility, infeasibility, x, p.infeasibility, ui.px(1.5f));
  draw_curve(draw, history, &Iteration::objective, objective, x, p.objective, ui.px(1.7f));
  draw.PopClipRect();

  // What the step under the mouse says.
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (plot.contains(mouse) && ImGui::IsWindowHovered()) {
    const auto nearest = std::min_element(
        x.begin(), x.end(), [&](float a, float b) { return std::abs(a - mouse.x) < std::abs(b - mouse.x); });
    const Iteration& at = history[static_cast<std::size_t>(nearest - x.begin())];
    draw.AddLine(ImVec2(*nearest, plot.min.y), ImVec2(*nearest, plot.max.y), p.ink_faint);
    ImGui::BeginTooltip();
    ui.heading("Step " + format_count(at.number) + (at.restoration ? "  (restoration)" : ""));
    ui.text("Objective " + format_number(at.objective), p.objective);
    ui.text("Infeasibility " + format_with_unit(at.infeasibility, "edges"), p.infeasibility);
    ui.text("First-order residual " + format_number(at.first_order), p.ink_soft);
    ui.text("After " + format_duration(at.seconds), p.ink_soft);
    ImGui::EndTooltip();
  }
}

}  // namespace

void draw_convergence(Desk& desk, const Rect& head, const Rect& body) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();

  // The legend doubles as the label of the two scales.
  const auto key = [&](float right, ImU32 colour, const char* text) {
    ImFont* small = ui.theme().small();
    const float width = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0, text).x;
    const float y = 0.5f * (head.min.y + head.max.y);
    draw.AddLine(ImVec2(right - width - ui.px(24), y), ImVec2(right - width - ui.px(6), y), colour, ui.px(2));
    draw_text_aligned(draw, small, ImVec2(right - width, head.min.y), ImVec2(right, head.max.y), 0.0f,
                      p.ink_soft, text);
    return right - width - ui.px(38);
  };
  const bool roomy = head.width() > ui.px(430);
  if (head.width() > ui.px(210)) {
    const float right =
        key(head.max.x, p.infeasibility, roomy ? "infeasibility, mean edges (right)" : "infeasibility");
    key(right, p.objective, roomy ? "objective, weighted (left)" : "objective");
  }
  draw_plot(desk, body);
}

}  // namespace planewright::ui
