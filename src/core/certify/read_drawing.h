// ReadDrawing: what a reader found in a DXF or SVG file, before anybody knows what should be in it. Internal
// to certify/. Units: mm (by the file's own unit), y up. Threads: plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pattern/flat_pattern.h"

namespace planewright {

struct ReadLine {
  std::string layer, panel;  // panel: empty where the format does not say
  Contour points;            // the first is not repeated at the end of closed lines
  bool closed = false;
};
struct ReadText {
  std::string layer, panel, text;    // UTF-8
  Eigen::Vector2d at;                // the middle
  double width = 0.0, height = 0.0;  // mm, height of capitals; 0: the reader does not tell
};
struct ReadDrawing {
  std::string unit;                     // as the file says it: "$INSUNITS 4"
  std::optional<double> mm_per_unit;    // absent: the file says no unit that we know
  std::optional<Eigen::Vector2d> size;  // mm, that the file declares
  std::vector<std::string> layers;      // declared
  std::vector<ReadLine> lines;
  std::vector<ReadText> texts;
};

}  // namespace planewright
