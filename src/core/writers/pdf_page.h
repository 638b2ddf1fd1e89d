// The pages of a PDF: their measures and the scales of drawings on them. Internal to writers/. Units: mm, y
// down, (0, 0) the upper left corner. Threads: pure.
#pragma once

#include <vector>

#include "core/writers/drawing_writers.h"

namespace planewright {

struct PageBox {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;  // mm, upper left corner and size
};

struct PageLayout {
  double width = 0.0, height = 0.0;
  PageBox frame;  // the thin frame
  PageBox title;  // the title block, in its lower right corner
  // Where a drawing may lie: beside the title block, or above it.
  PageBox beside, above;
};

// The page as its options turn it.
PageLayout page_layout(const PdfOptions& options);

struct PlacedDrawing {
  double scale = 1.0;  // the n of 1:n
  PageBox area;        // the one that allows the larger scale
};
PlacedDrawing place_drawing(const Drawing& drawing, const PageLayout& layout);

// A round length whose bar is about `paper` mm long at 1:n, mm.
double scale_bar_length(double scale, double paper);

}  // namespace planewright
