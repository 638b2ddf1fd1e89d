// Reads 3MF packages: opened by minizip, the model scanned by libxml2. Of the format what solids need:
// objects with meshes, their names, the unit, and the items of the build with their transforms; no
// components. Not assimp, which finds no model in the packages that lib3mf writes. Internal to certify/.
// Threads: pure.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/certify/read_mesh.h"

namespace planewright {

// The items of the build, in their order. Fails with ErrorCode::Unreadable: no package, no model in it, a
// model that is no XML to its end, numbers that are none, corners and objects that are not there, no faces.
Result<ReadMesh> read_package(const std::filesystem::path& path);

}  // namespace planewright
