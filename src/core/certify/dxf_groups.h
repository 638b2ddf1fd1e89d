// A DXF file by its group codes, coordinates in double: what dime cannot give, which keeps them in single
// precision. Knows what a flat drawing has: header variables, layers, POLYLINE, LWPOLYLINE, LINE, TEXT.
// Internal to certify/. Threads: pure.
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/certify/read_drawing.h"

namespace planewright {

// Fails with ErrorCode::Unreadable, with the line: no group code, no number, no EOF at the end, an entity
// that a drawing for cutting has no use for (it would be cut, and nobody checked it).
Result<ReadDrawing> read_dxf_groups(std::string_view content, const std::string& name);

}  // namespace planewright
