// What stands round a drawing on each page: frame, title block, scale bar. Internal to writers/.
#pragma once

#include <string>

#include "core/writers/pdf_pen.h"

namespace planewright {

struct PageTitle {
  std::string title;   // of the drawing
  double scale = 0.0;  // the n of 1:n; 0: none (index)
  int page = 1, pages = 1;
  bool without_edge_names = false;  // of the page; it says so
};

// project: TitleBlock::project, or the model's title where that is empty.
void draw_page_frame(PdfPen& pen, const PageLayout& layout, const TitleBlock& block,
                     const std::string& project, const PageTitle& title);

std::string scale_text(double scale);  // "1:25"

}  // namespace planewright
