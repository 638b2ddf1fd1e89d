// SheetPreview: a drawing for the workshop, drawn to scale on white paper, that can be zoomed and moved.
//
// Only what is in sight and large enough to see is drawn, so that a full sheet costs a part of a frame.
// Threads: the window's, inside a Dear ImGui frame. Units: pixels, and mm of the drawing (y up).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/pattern/drawing.h"
#include "core/workshop/tolerance_sheet.h"
#include "ui/widgets.h"

namespace planewright::ui {

class SheetPreview {
 public:
  // What the mouse points at, a panel of the model.
  struct Pointed {
    std::optional<int> panel;
    bool clicked = false;
  };
  // Draws `drawing` in the given place, where the mouse zooms (wheel), moves (drag) and fits (double click).
  // `number`: another one for another drawing; one of another size is fitted. pass: #P; parts that fail are
  // tinted, and so is `selected`. Parts that are large enough are recorded as "part NAME".
  Pointed draw(Ui& ui, const Drawing& drawing, std::uint64_t number, const std::vector<std::string>& names,
               const std::vector<bool>& pass, std::optional<int> selected, ImVec2 min, ImVec2 max);
  void fit() { fitted_ = true; }
  double pixels_per_mm() const { return scale_; }

 private:
  struct Box {
    double x0, y0, x1, y1;  // mm
  };
  struct Part {
    int panel;
    std::size_t line;  // its contour to cut
  };
  void index(const Drawing& drawing, std::uint64_t number);
  void fit_to(const Drawing& drawing, ImVec2 min, ImVec2 max);
  ImVec2 place(double x, double y) const;
  bool has_room(const Ui& ui, const DrawingText& text) const;
  std::optional<Part> part_at(const Drawing& drawing, ImVec2 at) const;

  std::uint64_t number_ = 0;
  bool indexed_ = false;
  double width_ = 0, height_ = 0;  // mm, of the drawing
  std::vector<Box> boxes_;         // of each line
  std::vector<Part> parts_;
  std::unordered_map<int, std::size_t> part_of_panel_;  // the line that is cut
  bool fitted_ = true;                                  // follows the place until the mouse zooms or moves
  double scale_ = 1.0;                                  // pixels per mm
  double middle_x_ = 0, middle_y_ = 0;                  // mm, what stands in the middle of the place
  ImVec2 centre_;                                       // pixels, the middle of the place
  bool moved_ = false;                                  // the present press has moved the paper
  std::vector<ImVec2> buffer_;
};

// A drawing's parts in small, on its paper, into a rectangle of its proportions: no controls.
void draw_thumbnail(ImDrawList& draw, const Drawing& drawing, ImVec2 min, ImVec2 max);

}  // namespace planewright::ui
