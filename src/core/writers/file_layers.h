// Layers of a drawing as the files name them: those of DrawingLayer, and the names of edges and notes apart
// from those of panels. Internal to writers/. Threads: pure.
#pragma once

#include <array>
#include <string_view>

#include "core/pattern/drawing.h"

namespace planewright {

struct FileLayer {
  std::string_view name;  // in DXF and SVG
  int dxf_colour;         // of AutoCAD's index
  std::string_view svg_colour;
};

// From the ground upwards, in the order that they are drawn.
inline constexpr std::array<FileLayer, 5> kFileLayers{{{"SHEET", 8, "#808080"},
                                                       {"CUT", 1, "#ff0000"},
                                                       {"ENGRAVE", 5, "#0000ff"},
                                                       {"TEXT", 7, "#000000"},
                                                       {"TEXT_EDGES", 9, "#606060"}}};

// Positions in kFileLayers.
constexpr int file_layer(DrawingLayer layer) {
  switch (layer) {
    case DrawingLayer::Sheet:
      return 0;
    case DrawingLayer::Cut:
      return 1;
    case DrawingLayer::Engrave:
      return 2;
    case DrawingLayer::Text:
      break;
  }
  return 3;
}
inline int file_layer(const DrawingLine& line) {
  return file_layer(line.layer);
}
inline int file_layer(const DrawingText& text) {
  return text.layer == DrawingLayer::Text && !text.is_name ? 4 : file_layer(text.layer);
}

}  // namespace planewright
