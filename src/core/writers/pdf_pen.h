// cairo for a drawing office: lines and text in millimetres on a page, y down. Internal to writers/. Threads:
// one pen per thread.
#pragma once

#include <cairo.h>

#include <string>
#include <string_view>

#include "core/writers/pdf_page.h"

namespace planewright {

enum class TextAnchor { Left, Middle, Right };

struct Grey {
  double value;  // 0 black .. 1 white
};
inline constexpr Grey kInk{0.10}, kMiddleGrey{0.45}, kPaleGrey{0.72}, kWash{0.955};

class PdfPen {
 public:
  explicit PdfPen(cairo_t* context) : cairo_(context) {}

  // height: of capital letters, mm. y: the baseline.
  void text(std::string_view utf8, double x, double y, double height, Grey grey = kInk,
            TextAnchor anchor = TextAnchor::Left, bool bold = false);
  double text_width(std::string_view utf8, double height, bool bold = false);  // mm
  // Cut with an ellipsis where it is wider than `width`.
  std::string fitted(std::string_view utf8, double width, double height, bool bold = false);
  // Round its middle, turned counter-clockwise (radians).
  void text_about(std::string_view utf8, double x, double y, double height, double rotation, Grey grey,
                  bool bold = false);
  void line(double x0, double y0, double x1, double y1, double width, Grey grey = kInk);
  void frame(const PageBox& box, double width, Grey grey = kInk);
  void fill(const PageBox& box, Grey grey);
  // rows of points, page mm
  void polyline(const Contour& points, bool closed, double width, Grey grey);

 private:
  void set_font(double height, bool bold);
  void set_grey(Grey grey) { cairo_set_source_rgb(cairo_, grey.value, grey.value, grey.value); }

  cairo_t* cairo_;
};

}  // namespace planewright
