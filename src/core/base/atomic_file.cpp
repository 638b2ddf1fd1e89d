#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace planewright {
namespace {

Error unwritable(const std::filesystem::path& path, int error) {
  return {ErrorCode::Unwritable, std::string("cannot be written: ") + std::strerror(error), path.string(),
          "Choose a folder that exists and that you may write to"};
}

// Writes all bytes or returns errno.
int write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t n = ::write(file, content.data(), content.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    content.remove_prefix(static_cast<size_t>(n));
  }
  return 0;
}

// The mode a plain open(2) would give: what was there before, else 0666 less the umask.
mode_t wanted_mode(const std::filesystem::path& path) {
  struct stat old {};
  if (::stat(path.c_str(), &old) == 0) return old.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

// Goes to where a symbolic link leads, there or not yet, so that the link stays and its target is replaced.
// False if links run in a circle.
bool follow_links(std::filesystem::path& path) {
  constexpr int kLongestChain = 40;  // as the system itself follows
  for (int k = 0; k < kLongestChain; ++k) {
    std::error_code no_link;
    const auto next = std::filesystem::read_symlink(path, no_link);
    if (no_link) return true;
    path = path.parent_path() / next;  // an absolute one replaces all of it
  }
  return false;
}

}  // namespace

Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)) {
    if (std::filesystem::is_directory(path, ignored)) return tl::unexpected(unwritable(path, EISDIR));
    // A device or a pipe (/dev/stdout) cannot be renamed over: write to it directly.
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) return tl::unexpected(unwritable(path, errno));
    const int error = write_all(file, content);
    ::close(file);
    if (error != 0) return tl::unexpected(unwritable(path, error));
    return {};
  }

  std::filesystem::path target = path;
  if (!follow_links(target)) return tl::unexpected(unwritable(path, ELOOP));
  // Not the target's name with an ending: that could become longer than a name may be.
  std::string temporary = (target.parent_path() / ".planewright-XXXXXX").string();
  const int file = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (file < 0) return tl::unexpected(unwritable(path, errno));
  int error = write_all(file, content);
  if (error == 0 && ::fchmod(file, wanted_mode(target)) != 0) error = errno;
  if (error == 0 && ::fsync(file) != 0) error = errno;
  if (::close(file) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    return tl::unexpected(unwritable(path, error));
  }
  return {};
}

Result<std::string> read_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    return fail(ErrorCode::Unreadable, "there is no such file", path.string(), "Check the name and the folder");
  if (std::filesystem::is_directory(path, error))
    return fail(ErrorCode::Unreadable, "is a folder, not a file", path.string(), "Name a file inside it");
  std::ifstream in(path, std::ios::binary);
  if (!in)
    return fail(ErrorCode::Unreadable, std::string("cannot be opened: ") + std::strerror(errno), path.string(),
                "Check that you may read it");
  std::string content((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad())
    return fail(ErrorCode::Unreadable, "could not be read to its end", path.string(), "Check the disk it lies on");
  return content;
}

}  // namespace planewright
