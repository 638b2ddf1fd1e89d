// StagedFolder: many files that take their place together or not at all.
//
// They are made in a hidden folder on the target's own file system (inside the target if that is there,
// beside it if not), and moved to their names by rename(2) at the end. Until publish() succeeds, and whenever
// an object goes without it, nothing of the target has changed and no trace is left. Threads: one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace planewright {

class StagedFolder {
 public:
  // Fails with ErrorCode::Unwritable: the folder above `target` is not there, may not be written to, or
  // `target` is a file.
  static Result<StagedFolder> at(const std::filesystem::path& target);
  StagedFolder(StagedFolder&& other) noexcept;
  StagedFolder& operator=(StagedFolder&&) = delete;
  ~StagedFolder();

  // Where the files are until then.
  std::filesystem::path path() const { return staging_ / "files"; }

  // Below path(), in folders that are made. Fails with ErrorCode::Unwritable, as write_file_atomically does.
  Result<void> write(const std::string& name, std::string_view content) const;

  // Moves `files` (names below path()) to the target; what stands there under the same name, and the files
  // `stale` below the target, go. If one cannot be moved, those moved before are moved back. Fails with
  // ErrorCode::Unwritable.
  Result<void> publish(const std::vector<std::string>& files, const std::vector<std::string>& stale);

 private:
  StagedFolder(std::filesystem::path target, std::filesystem::path staging);
  std::filesystem::path target_, staging_;
};

}  // namespace planewright
