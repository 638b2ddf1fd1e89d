// The readers, one per format, behind parse_mesh(). Internal to this folder.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/mesh_io.h"

namespace planewright {

// `content`: the whole file, shorter than 2 GB, without a byte order mark. Each fails with
// ErrorCode::Unreadable.
Result<PolygonSoup> read_obj(std::string_view content, const std::string& name);
Result<PolygonSoup> read_off(std::string_view content, const std::string& name);
Result<PolygonSoup> read_ply(std::string_view content, const std::string& name);
Result<PolygonSoup> read_stl(std::string_view content, const std::string& name);

// Whether the content begins as an OFF file ("OFF", "COFF", "STCN4OFF", ...).
bool begins_as_off(std::string_view content);
// Whether the content is a binary STL file: its size is the one that its triangle count asks for.
bool is_binary_stl(std::string_view content);

// Joins what a reader found. Checks the indices; with `may_count_from_1`, indices that cannot count from 0
// but exactly fit counting from 1 are read so. `where_face` names a face for an error.
Result<PolygonSoup> make_soup(const std::vector<double>& coordinates, Polygons faces, bool may_count_from_1,
                              const std::function<std::string(int)>& where_face);

// The remedy for a file that is not as it should be.
inline constexpr const char* kExportAgain = "Export the file again";

}  // namespace planewright
