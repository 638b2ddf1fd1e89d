// Viewport: the model in the middle of the window: panels, ghost and marks, the camera that the mouse moves,
// with what lies over them (viewport_overlays.h).
//
// The model is drawn into a framebuffer of its own, only when something in it has changed; else the last
// picture is shown again. Where drawing is slow (software renderers), the picture is coarser while the camera
// moves.
//
// Threads: the window's, with its OpenGL context current. Units: pixels of the window for the mouse;
// framebuffer pixels inside the picture.
#pragma once

#include <memory>
#include <optional>

#include "ui/app_state.h"
#include "ui/edit_choices.h"
#include "ui/layout.h"
#include "ui/look_at.h"
#include "ui/render/camera.h"
#include "ui/render/renderer.h"
#include "ui/widgets.h"

namespace planewright::ui {

class Viewport {
 public:
  static Result<Viewport> create();
  Viewport(Viewport&&) noexcept;
  Viewport& operator=(Viewport&&) noexcept;
  ~Viewport();

  // Hands what is new to OpenGL. Cheap when nothing is.
  void upload(AppState& state, bool dark);
  // The window's part of the frame: mouse, picture, overlays.
  void draw(Ui& ui, AppState& state, const Rect& place);

  void fit(const AppState& state);
  void reset_direction(const AppState& state);
  // Brings the point to the middle, from a side where nothing hides it: flies there.
  void look_at(const LookAt& wish);
  bool flying() const;  // the next frame shows another picture

  std::optional<int> hovered_edge() const;
  std::optional<int> hovered_region() const;  // of the coloured input
  // Where panels are drawn: all of it, or one half; before the first draw() nothing.
  Rect panels_place() const;
  // What a click of the right button was on, once: edits of it are wanted.
  std::optional<EditTarget> take_context_request();
  // Where a click would take the panel, the corner, or the pin (of the active layer), if one would.
  std::optional<ImVec2> clickable_place_of_panel(const AppState& state, int panel) const;
  std::optional<ImVec2> clickable_place_of_corner(const AppState& state, int point) const;
  std::optional<ImVec2> place_of_pin(const AppState& state, int pin) const;
  // Where the middle of a mesh edge is on the window, if it is the edge that a click there would take.
  std::optional<ImVec2> clickable_place_of_edge(const AppState& state, int edge) const;
  // Where a click would take the region, or the border between two; a border needs the tool that merges.
  std::optional<ImVec2> clickable_place_of_region(const AppState& state, int region) const;
  std::optional<ImVec2> clickable_place_of_border(const AppState& state, int a, int b) const;
  // Likewise the middle of the picture's nearest panel; for tests that orbit.
  const render::Camera& camera() const;
  // A picture was drawn since the last call; for the timings and for tests.
  int names_drawn() const;  // of panels, in the newest frame
  bool take_redrawn();

 private:
  struct Impl;
  explicit Viewport(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace planewright::ui
