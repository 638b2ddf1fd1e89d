// Files written whole or not at all.
//
// The content goes to a temporary file in the same folder, is flushed, and takes the target's name by
// rename(2); so a reader, or a crash, sees the old file or the new one, never a part. Threads: safe for
// different paths.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace planewright {

// Writes `content` (text or bytes) to `path`. Fails with ErrorCode::Unwritable, naming the path and the
// system's reason (missing folder, no permission, disk full); the old file then stays as it was and no
// temporary is left.
Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content);

// Whether write_file_atomically could begin at `path` now, so that a long computation need not end in an
// error: a temporary is made in its folder and removed again. Fails with ErrorCode::Unwritable (also: a
// folder stands there). What the disk still holds, and what changes until then, it does not know.
Result<void> check_writable(const std::filesystem::path& path);

// Whether writing to one of the names would change what the other names, through links too; neither needs to
// exist yet.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

// Reads a whole file. Fails with ErrorCode::Unreadable (missing, a folder, no permission, a read error).
Result<std::string> read_file(const std::filesystem::path& path);

}  // namespace planewright
