// What a DXF or SVG file has to show of its drawing. Internal to certify/. Threads: pure.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/certify/certificate.h"
#include "core/certify/read_drawing.h"

namespace planewright {

// What a file showed, for the check over all files of its kind.
struct ShownParts {
  std::map<std::string, int> names;  // panel names on the layer TEXT, and how often
  int contours = 0;                  // closed lines on CUT
};

// The names that belong to panels in a file: texts on TEXT; where the format says the panel of a text, those
// that name it.
ShownParts shown_parts(const ReadDrawing& read);

std::vector<Check> check_drawing(const ReadDrawing& read, const ExportContent& content,
                                 const Drawing& drawing);

// All files of one kind together: every panel that has a pattern and is not left out, once.
std::vector<Check> check_all_parts(const std::vector<ShownParts>& files, const ExportContent& content);

// Panels whose contour a drawing cuts, ascending.
std::vector<int> panels_cut(const Drawing& drawing);

}  // namespace planewright
