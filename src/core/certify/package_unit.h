// The unit of a 3MF package: attribute "unit" of its model, which assimp does not read. The package is opened
// by minizip, the model scanned by libxml2. Internal to certify/.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace planewright {

// "millimeter" is the default of 3MF. Fails with ErrorCode::Unreadable: no package, no model in it.
Result<std::string> package_unit(const std::filesystem::path& path);

}  // namespace planewright
