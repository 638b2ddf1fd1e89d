// What lies over the model: what the tool in hand does, the colours' legend, the axes. Each draws into the
// current Dear ImGui window. Threads: the window's. Units: `place` in pixels of the window; lengths in model
// units.
#pragma once

#include <string>

#include "ui/app_state.h"
#include "ui/layout.h"
#include "ui/render/camera.h"
#include "ui/render/scene.h"
#include "ui/widgets.h"

namespace planewright::ui {

// Top left, below the badge: what the mouse does while a tool other than looking is in hand.
void draw_tool_hint(Ui& ui, const Rect& place, const std::string& text);
std::string box_hint(const AppState& state);

// Top left: what a pane shows, where there are several. Busy: something turns beside it.
void draw_label(Ui& ui, const Rect& place, const std::string& text, bool busy);

// Bottom left; its size, for what has to stand beside it.
ImVec2 legend_size(const Ui& ui);
void draw_legend(Ui& ui, const Rect& place, const render::ColourScale& scale, ColourMap colours);

// Bottom right.
void draw_axes(Ui& ui, const Rect& place, const render::Camera& camera);

}  // namespace planewright::ui
