#include "core/writers/pdf_pen.h"

#include "core/writers/clean_text.h"

namespace planewright {
namespace {

// Height of the usual sans-serif faces' capital letters, parts of the font size.
constexpr double kCapitalHeight = 0.72;

}  // namespace

void PdfPen::set_font(double height, bool bold) {
  cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, height / kCapitalHeight);
}

double PdfPen::text_width(std::string_view utf8, double height, bool bold) {
  set_font(height, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_, clean_text(utf8).c_str(), &extents);
  return extents.x_advance;
}

std::string PdfPen::fitted(std::string_view utf8, double width, double height, bool bold) {
  std::string text = clean_text(utf8);
  if (text_width(text, height, bold) <= width) return text;
  const std::string ellipsis = "\u2026";
  while (!text.empty()) {
    // A whole character: its following bytes, then its first.
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
    if (!text.empty()) text.pop_back();
    if (text_width(text + ellipsis, height, bold) <= width) break;
  }
  return text + ellipsis;
}

void PdfPen::text(std::string_view utf8, double x, double y, double height, Grey grey, TextAnchor anchor,
                  bool bold) {
  if (utf8.empty()) return;
  const std::string text = clean_text(utf8);
  const double width = anchor == TextAnchor::Left ? 0.0 : text_width(text, height, bold);
  set_font(height, bold);
  set_grey(grey);
  cairo_move_to(cairo_, x - (anchor == TextAnchor::Middle ? width / 2.0 : width), y);
  cairo_show_text(cairo_, text.c_str());
}

void PdfPen::text_about(std::string_view utf8, double x, double y, double height, double rotation, Grey grey,
                        bool bold) {
  cairo_save(cairo_);
  cairo_translate(cairo_, x, y);
  cairo_rotate(cairo_, -rotation);
  text(utf8, 0.0, height / 2.0, height, grey, TextAnchor::Middle, bold);
  cairo_restore(cairo_);
}

void PdfPen::line(double x0, double y0, double x1, double y1, double width, Grey grey) {
  set_grey(grey);
  cairo_set_line_width(cairo_, width);
  cairo_move_to(cairo_, x0, y0);
  cairo_line_to(cairo_, x1, y1);
  cairo_stroke(cairo_);
}

void PdfPen::frame(const PageBox& box, double width, Grey grey) {
  set_grey(grey);
  cairo_set_line_width(cairo_, width);
  cairo_new_path(cairo_);
  cairo_rectangle(cairo_, box.x, box.y, box.width, box.height);
  cairo_stroke(cairo_);
}

void PdfPen::fill(const PageBox& box, Grey grey) {
  set_grey(grey);
  cairo_new_path(cairo_);
  cairo_rectangle(cairo_, box.x, box.y, box.width, box.height);
  cairo_fill(cairo_);
}

void PdfPen::polyline(const Contour& points, bool closed, double width, Grey grey) {
  set_grey(grey);
  cairo_set_line_width(cairo_, width);
  cairo_new_path(cairo_);  // text leaves a point behind
  for (Eigen::Index i = 0; i < points.rows(); ++i) cairo_line_to(cairo_, points(i, 0), points(i, 1));
  if (closed) cairo_close_path(cairo_);
  cairo_stroke(cairo_);
}

}  // namespace planewright
