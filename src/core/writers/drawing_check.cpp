#include <algorithm>
#include <cmath>

#include "core/writers/drawing_writers.h"

namespace planewright {
namespace {

constexpr const char* kRemedy = "This is a fault of the drawing, not of the panels: report it";

tl::unexpected<Error> refuse(std::string what, const Drawing& drawing, int panel) {
  std::string where = "drawing \"" + drawing.title + "\"";
  if (panel >= 0) where += ", panel " + std::to_string(panel);
  return fail(ErrorCode::Refused, std::move(what), std::move(where), kRemedy);
}

}  // namespace

Result<void> check_drawing(const Drawing& drawing) {
  if (!std::isfinite(drawing.width) || !std::isfinite(drawing.height) || drawing.width < 0.0 ||
      drawing.height < 0.0)
    return refuse("its size is not a finite number of millimetres", drawing, -1);
  for (const DrawingLine& line : drawing.lines) {
    if (line.points.rows() < (line.closed ? 3 : 2))
      return refuse("a line has too few points", drawing, line.panel);
    if (!line.points.allFinite()) return refuse("a coordinate is not a finite number", drawing, line.panel);
  }
  for (const DrawingText& text : drawing.texts) {
    if (!text.at.allFinite() || !std::isfinite(text.rotation) || !std::isfinite(text.height) ||
        text.height <= 0.0)
      return refuse("the place or size of a text is not a finite number", drawing, text.panel);
  }
  return {};
}

}  // namespace planewright
