// STL and glTF by assimp, which keeps coordinates in single precision. Internal to certify/.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/certify/read_mesh.h"

namespace planewright {

std::string scene_reader_name();  // "assimp 5.2.5"

// An object per node with faces (STL: one), placed by the transforms of its nodes. Coordinates as in the file
// (glTF: metres, y up). unit: of glTF "metre" by its standard. Fails with ErrorCode::Unreadable.
Result<ReadMesh> read_scene(const std::filesystem::path& path);

}  // namespace planewright
