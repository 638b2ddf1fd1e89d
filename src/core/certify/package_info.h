// What assimp does not read of a 3MF package: the unit of its model and the names of its objects. The package
// is opened by minizip, the model scanned by libxml2. Internal to certify/.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/base/result.h"

namespace planewright {

struct PackageInfo {
  std::string unit = "millimeter";           // the default of 3MF
  std::map<std::string, std::string> names;  // by the id of the object
};

// Fails with ErrorCode::Unreadable: no package, no model in it, a model that is no XML to its end.
Result<PackageInfo> read_package(const std::filesystem::path& path);

}  // namespace planewright
