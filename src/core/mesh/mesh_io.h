// Reading and writing polygon meshes: OBJ, OFF, PLY (ascii, binary little and big endian) and STL (ascii,
// binary).
//
// The readers are our own: OpenMesh's drop faces that break its invariants, know no line numbers and read
// floats in single precision on some paths. Formats are recognised by content where that is certain, else by
// the name's ending. Numbers are read and written locale-independently; writers use 17 significant digits, so
// that planarity survives the round trip (PLY is written as text, its coordinates declared as doubles; binary
// STL is single precision by its format and is only read, never written). Files of more than 2 GB, devices
// and pipes are refused. Threads: no shared state.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/mesh/health_report.h"

namespace planewright {

enum class MeshFormat { Obj, Off, Ply, Stl };

// Polygons as a file has them, before any check.
struct PolygonSoup {
  Points positions;                // #V x 3, model units
  Polygons faces;                  // 0-based, every index inside 0..#V-1
  bool one_based_indices = false;  // an OFF or PLY file that counted from 1 and was read so
};

// The format that a path's ending (.obj .off .ply .stl, any case) names; ErrorCode::Usage lists the known
// ones.
Result<MeshFormat> format_of(const std::filesystem::path& path);

// Parses a whole file's content. `name` is what errors call it ("roof.obj" -> "roof.obj:14: ...").
// Fails with ErrorCode::Unreadable, with line (or element, for binary) and remedy: bad number, non-finite
// coordinate, index 0 or beyond the end, a file that ends early, counts that cannot be true (checked against
// the file's size before anything is allocated). STL has no shared vertices: corners with exactly equal
// coordinates are joined.
Result<PolygonSoup> parse_mesh(std::string_view content, MeshFormat format, const std::string& name);

// Reads, checks and repairs: what a designer's "open" does.
Result<CheckedMesh> load_mesh(const std::filesystem::path& path);

// Writes polygons, whole or not at all. positions: #V x 3, model units. STL: polygons are cut into triangles
// (ear clipping in the panel's plane, so that concave panels keep their outline). Refuses
// (ErrorCode::Refused, naming the element) coordinates that are not finite, faces with fewer than 3 corners,
// indices out of range.
Result<void> save_mesh(const std::filesystem::path& path, const Points& positions, const Polygons& faces);
Result<std::string> format_mesh(MeshFormat format, const Points& positions, const Polygons& faces);

}  // namespace planewright
