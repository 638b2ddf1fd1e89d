// Sheets: several pictures in one, to be compared, each with a caption below. No OpenGL.
//
// Units: pixels. Threads: as TextPen's.
#pragma once

#include <string>
#include <vector>

#include "ui/render/image.h"
#include "ui/render/renderer.h"

namespace planewright::render {

struct Cell {
  Image image;
  std::string caption;  // UTF-8
};

struct SheetLayout {
  int columns = 1;
  int width = 1000;  // of the sheet, more or less: what gaps and letters are in proportion to
  bool captions = false;

  int gap() const;             // between neighbouring cells
  int caption_height() const;  // of the strip below each picture; 0 without captions
};

// Cells row by row from the top left, `columns` >= 1 of them in a row, on the theme's paper. All pictures
// have the size of the first; no cells: an empty image. Places that are left over at the end stay empty.
Image make_sheet(const std::vector<Cell>& cells, const SheetLayout& layout, const Theme& theme);

}  // namespace planewright::render
