#include "core/writers/pdf_page.h"

#include <algorithm>
#include <cmath>

namespace planewright {
namespace {

constexpr double kMargin = 10.0, kGap = 6.0;
constexpr double kTitleWidth = 96.0, kTitleHeight = 52.0;

// The smallest usual scale that is not below `wanted`.
double usual_scale(double wanted) {
  constexpr double kRounding = 1e-9;  // a drawing that just fits does
  for (const double first : {1.0, 2.0, 5.0})
    if (wanted <= first * (1.0 + kRounding)) return first;
  for (double decade = 10.0;; decade *= 10.0)
    for (const double step : {1.0, 2.0, 2.5, 5.0})
      if (wanted <= step * decade * (1.0 + kRounding)) return step * decade;
}

double scale_in(const Drawing& drawing, const PageBox& area) {
  return usual_scale(std::max(drawing.width / area.width, drawing.height / area.height));
}

}  // namespace

PageLayout page_layout(const PdfOptions& options) {
  PageLayout layout;
  layout.width = std::max(options.page_width, options.page_height);
  layout.height = std::min(options.page_width, options.page_height);
  if (!options.landscape) std::swap(layout.width, layout.height);
  layout.frame = {kMargin, kMargin, layout.width - 2.0 * kMargin, layout.height - 2.0 * kMargin};
  const PageBox& frame = layout.frame;
  const double title_width = std::min(kTitleWidth, frame.width);
  layout.title = {frame.x + frame.width - title_width, frame.y + frame.height - kTitleHeight, title_width,
                  kTitleHeight};
  // At least a line remains, whatever the page.
  const auto inner = [&](double width, double height) {
    return PageBox{frame.x + kGap, frame.y + kGap, std::max(width - 2.0 * kGap, 1.0),
                   std::max(height - 2.0 * kGap, 1.0)};
  };
  layout.beside = inner(frame.width - title_width, frame.height);
  layout.above = inner(frame.width, frame.height - kTitleHeight);
  return layout;
}

PlacedDrawing place_drawing(const Drawing& drawing, const PageLayout& layout) {
  const double beside = scale_in(drawing, layout.beside), above = scale_in(drawing, layout.above);
  return beside <= above ? PlacedDrawing{beside, layout.beside} : PlacedDrawing{above, layout.above};
}

double scale_bar_length(double scale, double paper) {
  const double wanted = scale * paper;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {5.0, 2.0})
    if (step * decade <= wanted) return step * decade;
  return decade;
}

double page_scale(const Drawing& drawing, const PdfOptions& options) {
  return place_drawing(drawing, page_layout(options)).scale;
}

}  // namespace planewright
