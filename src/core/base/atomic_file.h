// Files written whole or not at all.
//
// The content goes to a temporary file in the same folder, is flushed, and takes the target's name by rename(2);
// so a reader, or a crash, sees the old file or the new one, never a part. Threads: safe for different paths.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace planewright {

// Writes `content` (text or bytes) to `path`. Fails with ErrorCode::Unwritable, naming the path and the system's
// reason (missing folder, no permission, disk full); the old file then stays as it was and no temporary is left.
Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content);

// Reads a whole file. Fails with ErrorCode::Unreadable (missing, a folder, no permission).
Result<std::string> read_file(const std::filesystem::path& path);

}  // namespace planewright
