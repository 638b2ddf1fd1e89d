#include "ui/layout.h"

#include <algorithm>
#include <cmath>

namespace planewright::ui {

Layout arrange(ImVec2 window, float menu_height, float scale, UserSettings& settings) {
  const auto px = [&](float value) { return std::round(value * scale); };
  const float toolbar = px(46), status = px(28), grip = px(6), collapsed = px(32);

  const float width = window.x / scale, height = window.y / scale;
  settings.left_width = std::clamp(settings.left_width, 240.0f, std::max(240.0f, width / 3));
  settings.right_width = std::clamp(settings.right_width, 220.0f, std::max(220.0f, width / 3));
  float& bottom_height = settings.schedule_tab ? settings.schedule_height : settings.bottom_height;
  bottom_height = std::clamp(bottom_height, 110.0f, std::max(110.0f, height / 2));

  const float top = menu_height + toolbar;
  const float low = std::max(window.y - status, top);
  const float left = px(settings.left_width), right = std::max(window.x - px(settings.right_width), left);
  const float bottom = std::max(low - (settings.convergence_open ? px(bottom_height) : collapsed), top);

  Layout l;
  l.toolbar = {{0, menu_height}, {window.x, top}};
  l.status = {{0, low}, {window.x, window.y}};
  l.left = {{0, top}, {left, low}};
  l.right = {{right, top}, {window.x, low}};
  l.viewport = {{left, top}, {right, bottom}};
  l.bottom = {{left, bottom}, {right, low}};
  // The grips lie over the borders, half on either side.
  l.left_splitter = {{left - grip / 2, top}, {left + grip / 2, low}};
  l.right_splitter = {{right - grip / 2, top}, {right + grip / 2, low}};
  l.bottom_splitter = {{left + grip, bottom - grip / 2}, {right - grip, bottom + grip / 2}};
  return l;
}

}  // namespace planewright::ui
