// Layout: where the parts of the window stand, from its size and the widths that the designer set.
//
// Units: pixels of the window, (0, 0) top left. Threads: pure functions.
#pragma once

#include <imgui.h>

#include "ui/user_settings.h"

namespace planewright::ui {

struct Rect {
  ImVec2 min, max;
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
  bool contains(ImVec2 p) const { return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y; }
};

struct Layout {
  Rect toolbar, left, right, viewport, bottom, status;
  Rect left_splitter, right_splitter, bottom_splitter;
};

// Keeps at least a third of the width for the model by narrowing the panels (in `settings`, too).
Layout arrange(ImVec2 window, float menu_height, float scale, UserSettings& settings);

}  // namespace planewright::ui
