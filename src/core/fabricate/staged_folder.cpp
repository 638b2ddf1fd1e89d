#include "core/fabricate/staged_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/base/atomic_file.h"

namespace planewright {
namespace {

namespace fs = std::filesystem;

// Where publish() puts what it replaces, below the staging folder.
constexpr const char* kReplaced = ".replaced";

tl::unexpected<Error> unwritable(const fs::path& path, const std::string& reason) {
  return fail(ErrorCode::Unwritable, "cannot be written: " + reason, path.string(),
              "Choose a folder that exists and that you may write to");
}

// Moves that can be taken back.
class Moves {
 public:
  Result<void> move(const fs::path& from, const fs::path& to) {
    std::error_code error;
    // One level at a time, so that folders that were made can be removed again.
    std::vector<fs::path> missing;
    for (fs::path folder = to.parent_path(); !folder.empty() && !fs::exists(folder, error);
         folder = folder.parent_path())
      missing.push_back(folder);
    for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder) {
      if (!fs::create_directory(*folder, error)) return unwritable(*folder, error.message());
      made_.push_back(*folder);
    }
    fs::rename(from, to, error);
    if (error) return unwritable(to, error.message());
    done_.emplace_back(from, to);
    return {};
  }

  void take_back() {
    std::error_code ignored;
    for (auto move = done_.rbegin(); move != done_.rend(); ++move)
      fs::rename(move->second, move->first, ignored);
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, ignored);
  }

 private:
  std::vector<std::pair<fs::path, fs::path>> done_;
  std::vector<fs::path> made_;
};

}  // namespace

StagedFolder::StagedFolder(fs::path target, fs::path staging)
    : target_(std::move(target)), staging_(std::move(staging)) {}

StagedFolder::StagedFolder(StagedFolder&& other) noexcept
    : target_(std::move(other.target_)), staging_(std::exchange(other.staging_, {})) {}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  if (!staging_.empty()) fs::remove_all(staging_, ignored);
}

Result<StagedFolder> StagedFolder::at(const fs::path& target) {
  std::error_code error;
  fs::path absolute = fs::absolute(target, error).lexically_normal();
  if (!absolute.has_filename()) absolute = absolute.parent_path();  // "out/" is "out"
  const bool there = fs::exists(absolute, error);
  if (there && !fs::is_directory(absolute, error)) return unwritable(target, "it is a file");
  const fs::path on = there ? absolute : absolute.parent_path();
  std::string name = (on / ".planewright-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) return unwritable(target, std::strerror(errno));
  // mkdtemp's folders are the owner's alone; what becomes the target is for whom the umask allows.
  StagedFolder staged(std::move(absolute), name);
  if (!fs::create_directory(staged.path(), error)) return unwritable(target, error.message());
  return staged;
}

Result<void> StagedFolder::write(const std::string& name, std::string_view content) const {
  const fs::path path = this->path() / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) return unwritable(target_ / name, error.message());
  if (auto written = write_file_atomically(path, content); !written) {
    Error told = written.error();
    told.where = (target_ / name).string();
    return tl::unexpected(told);
  }
  return {};
}

Result<void> StagedFolder::publish(const std::vector<std::string>& files,
                                   const std::vector<std::string>& stale) {
  std::error_code error;
  if (!fs::exists(target_, error)) {
    fs::rename(path(), target_, error);
    if (error) return unwritable(target_, error.message());
    return {};
  }
  Moves moves;
  const auto step = [&]() -> Result<void> {
    const fs::path replaced = staging_ / kReplaced;
    for (const auto* names : {&stale, &files})
      for (const std::string& name : *names)
        if (fs::exists(target_ / name, error))
          if (auto moved = moves.move(target_ / name, replaced / name); !moved) return moved;
    for (const std::string& name : files)
      if (auto moved = moves.move(path() / name, target_ / name); !moved) return moved;
    return {};
  };
  auto moved = step();
  if (!moved) moves.take_back();
  return moved;
}

}  // namespace planewright
