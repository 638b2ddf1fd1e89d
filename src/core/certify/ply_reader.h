// PLY (text and binary) in double, with the face property "panel" and names from comments ("panel 3 C-17").
// Our own: assimp reads PLY in single precision, which says nothing of planarity. Internal to certify/.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/certify/read_mesh.h"

namespace planewright {

std::string ply_reader_name();

// Fails with ErrorCode::Unreadable: no PLY, a list or number that is none, too few or too many bytes.
Result<ReadMesh> read_ply_file(const std::filesystem::path& path);

}  // namespace planewright
