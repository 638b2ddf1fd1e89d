// OBJ by tinyobjloader, in double, polygons as they are. Internal to certify/.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/certify/read_mesh.h"

namespace planewright {

std::string obj_reader_name();

// An object per group or object of the file. unit: the comments before the first vertex. Fails with
// ErrorCode::Unreadable.
Result<ReadMesh> read_obj_file(const std::filesystem::path& path);

}  // namespace planewright
