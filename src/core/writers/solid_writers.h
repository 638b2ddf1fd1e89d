// Panels and thick panels as 3D files: OBJ, PLY, STL, 3MF, glTF. Each gives the bytes of a whole file.
//
// Coordinates are absolute (origin added), in mm; the file says so where the format can (3MF unit, comments
// in OBJ, PLY, STL header). glTF wants metres with y up: it gets them. OBJ, PLY: polygons, 17 digits. STL:
// binary, triangles, single precision by its format, relative to model.origin (said in the header), or
// nothing would be left of the digits. 3MF by lib3mf, glTF by tinygltf; each panel an object with its name.
// Threads: pure.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/pattern/thick_panel.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

enum class SolidFormat { Obj, Ply, Stl, ThreeMf, Gltf };

// One surface: the panels with shared corners (OBJ: one group per panel; PLY: a face property "panel", names
// as comments). 3MF holds solids only: panels as 3MF are refused with ErrorCode::Usage.
Result<std::string> format_panels(const WorkshopModel& model, SolidFormat format);
// One closed solid per panel (empty ones are left out). Polygons are cut into triangles where the format
// needs them.
Result<std::string> format_solids(const WorkshopModel& model, const ThickPanels& solids, SolidFormat format);

}  // namespace planewright
