// Everything of a DXF file round its entities: header, tables, blocks, objects. Internal to writers/.
// Threads: pure.
#pragma once

#include <cstdint>

#include "core/pattern/drawing.h"
#include "core/writers/dxf_groups.h"

namespace planewright {

// Handles that others refer to.
inline constexpr std::uint32_t kModelSpaceRecord = 0x1F, kPaperSpaceRecord = 0x1B;

struct DxfExtent {
  Eigen::Vector2d low, high;  // mm
};
// Of the drawing's area and everything in it.
DxfExtent dxf_extent(const Drawing& drawing);

// next_handle: the first that no record of the file has.
void write_dxf_header(DxfGroups& out, const DxfExtent& extent, std::uint32_t next_handle);
// Also CLASSES, where the version has handles.
void write_dxf_tables(DxfGroups& out, const DxfExtent& extent);
void write_dxf_blocks(DxfGroups& out);
// The named objects: nothing but a root with an empty dictionary of groups. Only with handles.
void write_dxf_objects(DxfGroups& out);

}  // namespace planewright
