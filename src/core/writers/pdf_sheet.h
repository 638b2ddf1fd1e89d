// A drawing on its page, and the index of all of them. Internal to writers/.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "core/writers/pdf_pen.h"

namespace planewright {

// Of all panels: what tells edge names from notes.
using PanelNames = std::unordered_set<std::string>;

// Whether the page leaves out edge names, which would be too small on it (kLeastPdfText).
bool leaves_out_edge_names(const PanelNames& names, const Drawing& drawing, const PlacedDrawing& placed);

// Without those.
void draw_sheet(PdfPen& pen, const PanelNames& names, const Drawing& drawing, const PlacedDrawing& placed);

struct IndexRow {
  int page;
  std::string title;
  double width, height;  // mm
  int parts;
  double filled;  // 0..1 of the drawing's area; 0 where it has none
  double scale;
};
// Counted from the drawing: its cut contours.
IndexRow index_row(const Drawing& drawing, int page, double scale);

// The index, a page or more: first the table, then the notes.
class IndexPages {
 public:
  IndexPages(PdfPen& pen, const PageLayout& layout, std::vector<IndexRow> rows,
             const std::vector<std::string>& notes);
  int count() const { return static_cast<int>(pages_.size()); }
  // page: 0-based, of the index.
  void draw(int page) const;

 private:
  // One line of an index page; either a row of the table or text.
  struct Line {
    enum class Kind { Heading, TableHead, Row, Note, Space } kind;
    int row = -1;
    std::string text;
  };
  void break_pages(const std::vector<Line>& lines);
  void draw_line(const Line& line, double y) const;

  PdfPen& pen_;
  PageBox area_;
  std::vector<IndexRow> rows_;
  std::vector<std::vector<Line>> pages_;
};

// Words wrapped to lines no wider than `width` mm; a longer word is cut.
std::vector<std::string> wrapped(PdfPen& pen, const std::string& text, double width, double height);

}  // namespace planewright
