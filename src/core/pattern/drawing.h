// Drawing: what a sheet or a pattern shows, free of any file format. Writers of DXF, SVG and PDF take this,
// and the window's preview draws it.
//
// Units: mm, y up, (0, 0) the lower left corner of the page or sheet. Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/pattern/flat_pattern.h"
#include "core/pattern/nesting.h"

namespace planewright {

// CUT: contours to cut. ENGRAVE: single strokes on the part (inner contour, up mark, the strokes of names).
// TEXT: names as text, for people and for programs that read them. SHEET: the sheet's border, not cut.
enum class DrawingLayer { Cut, Engrave, Text, Sheet };
std::string_view layer_name(DrawingLayer layer);  // "CUT", "ENGRAVE", "TEXT", "SHEET"

struct DrawingLine {
  DrawingLayer layer;
  Contour points;
  bool closed = false;
  int panel = -1;  // that it belongs to; -1: none
};
struct DrawingText {
  DrawingLayer layer = DrawingLayer::Text;
  std::string text;
  Eigen::Vector2d at;     // middle of the text
  double height = 0.0;    // of capital letters, mm
  double rotation = 0.0;  // radians, counter-clockwise
  int panel = -1;
  bool is_name = false;  // the panel's own name (once for each panel of a file); else an edge's, or a note
};
struct Drawing {
  std::string title;
  double width = 0.0, height = 0.0;  // mm
  std::vector<DrawingLine> lines;
  std::vector<DrawingText> texts;
};

struct LabelOptions {
  double text_height = 12.0;   // mm, at most; smaller where a part has less room
  bool edge_names = true;      // the neighbour's name inside along each side
  bool engrave_names = false;  // names as single strokes on ENGRAVE as well (a stroke font of our own)
};

// One part in its own frame / all parts of a sheet. Names are inside their part, upright in the part's frame
// (up mark above them; none on panels that lie flat), and smaller where the part is small. Names along sides
// read along them, from the part's left to its right; where there is no room for 0.5 mm there is none.
// ENGRAVE has outer or inner contour, too, where it is not what is cut. Empty patterns draw nothing.
Drawing part_drawing(const WorkshopModel& model, const FlatPattern& pattern,
                     const LabelOptions& options = {});
Drawing sheet_drawing(const WorkshopModel& model, const std::vector<FlatPattern>& patterns,
                      const Nesting& nesting, int sheet, const LabelOptions& options = {});
// All parts in rows, without sheets (no stock size given): rows as wide as they are high together, names in
// order.
Drawing row_drawing(const WorkshopModel& model, const std::vector<FlatPattern>& patterns, double spacing,
                    const LabelOptions& options = {});

}  // namespace planewright
