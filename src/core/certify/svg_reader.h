// SVG by libxml2: groups, transforms, polygon, polyline, line, rect, path (straight pieces), text;
// millimetres from width, height and viewBox. Internal to certify/.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/certify/read_drawing.h"

namespace planewright {

std::string svg_reader_name();

// y is turned up, (0, 0) is the lower left corner of the viewBox. Layers are the groups that Inkscape calls
// layers. Fails with ErrorCode::Unreadable: no well-formed SVG, a number that is none, a shape or a transform
// that a drawing for cutting has no use for.
Result<ReadDrawing> read_svg(const std::filesystem::path& path);

}  // namespace planewright
