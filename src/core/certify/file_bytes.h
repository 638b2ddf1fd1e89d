// A whole file in memory. Internal to certify/.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace planewright {

// Fails with ErrorCode::Unreadable: missing, no plain file, empty, cannot be read.
Result<std::string> file_bytes(const std::filesystem::path& path);

}  // namespace planewright
