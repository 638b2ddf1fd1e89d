#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>

namespace planewright {
namespace {

Error unwritable(const std::filesystem::path& path, int error) {
  const bool full = error == ENOSPC || error == EDQUOT;
  return {ErrorCode::Unwritable, std::string("cannot be written: ") + std::strerror(error), path.string(),
          full ? "Make room there, or choose a folder elsewhere"
               : "Choose a folder that exists and that you may write to"};
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

// open(2), again if a signal came between; errno if that fails.
int open_file(const std::filesystem::path& path, int flags, mode_t mode = 0) {
  int file;
  do file = ::open(path.c_str(), flags | O_CLOEXEC, mode);
  while (file < 0 && errno == EINTR);
  return file;
}

struct Temporary {
  std::filesystem::path path;
  int file = -1;
};

// A new empty file in the folder, with the mode that the kernel makes of `mode` and the process's umask.
// Reading the umask oneself would mean to change it for a moment, for every thread. The name does not contain
// the target's: that could become longer than a name may be. Fails with errno.
tl::expected<Temporary, int> make_temporary(const std::filesystem::path& folder, mode_t mode) {
  constexpr int kMostNames = 100;
  std::random_device random;
  for (int k = 0; k < kMostNames; ++k) {
    char name[40];
    std::snprintf(name, sizeof name, ".planewright-%08x%08x", random(), random());
    Temporary temporary{folder / name};
    temporary.file = open_file(temporary.path, O_WRONLY | O_CREAT | O_EXCL, mode);
    if (temporary.file >= 0) return temporary;
    if (errno != EEXIST) return tl::unexpected(errno);
  }
  return tl::unexpected(EEXIST);
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

// Whether something stands there that cannot be replaced by rename(2): a folder, a device, a pipe.
bool is_special(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
}

}  // namespace

Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content) {
  std::error_code ignored;
  if (is_special(path)) {
    if (std::filesystem::is_directory(path, ignored)) return tl::unexpected(unwritable(path, EISDIR));
    // A device or a pipe (/dev/stdout) cannot be renamed over: write to it directly.
    const int file = open_file(path, O_WRONLY);
    if (file < 0) return tl::unexpected(unwritable(path, errno));
    const int error = write_all(file, content);
    ::close(file);
    if (error != 0) return tl::unexpected(unwritable(path, error));
    return {};
  }

  std::filesystem::path target = path;
  if (!follow_links(target)) return tl::unexpected(unwritable(path, ELOOP));
  struct stat old {};
  const bool replaces = ::stat(target.c_str(), &old) == 0;
  // What replaces a file is nobody else's to read before it has that file's mode.
  const auto temporary = make_temporary(target.parent_path(), replaces ? 0600 : 0666);
  if (!temporary) return tl::unexpected(unwritable(path, temporary.error()));
  int error = write_all(temporary->file, content);
  if (error == 0 && replaces && ::fchmod(temporary->file, old.st_mode & 07777) != 0) error = errno;
  if (error == 0 && ::fsync(temporary->file) != 0) error = errno;
  if (::close(temporary->file) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary->path.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary->path.c_str());
    return tl::unexpected(unwritable(path, error));
  }
  return {};
}

Result<void> check_writable(const std::filesystem::path& path) {
  std::error_code ignored;
  if (is_special(path)) {
    if (std::filesystem::is_directory(path, ignored)) return tl::unexpected(unwritable(path, EISDIR));
    // Not opened: a pipe would wait for its reader, and a reader would take the closing for the end.
    if (::access(path.c_str(), W_OK) != 0) return tl::unexpected(unwritable(path, errno));
    return {};
  }
  std::filesystem::path target = path;
  if (!follow_links(target)) return tl::unexpected(unwritable(path, ELOOP));
  // A name ending in a slash, or none: the folder would take a temporary, but nothing could be renamed to it.
  if (!target.has_filename()) return tl::unexpected(unwritable(path, target.empty() ? ENOENT : EISDIR));
  // lstat(2) knows whether the file system takes the target's name; that it is not there is as good as that
  // it is.
  struct stat there {};
  if (::lstat(target.c_str(), &there) != 0 && errno != ENOENT) return tl::unexpected(unwritable(path, errno));
  const auto temporary = make_temporary(target.parent_path(), 0600);
  if (!temporary) return tl::unexpected(unwritable(path, temporary.error()));
  ::close(temporary->file);
  ::unlink(temporary->path.c_str());
  return {};
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;
  std::filesystem::path at = a, bt = b;
  // weakly_canonical alone leaves a link that leads to nothing yet as it is.
  if (!follow_links(at) || !follow_links(bt)) return false;
  std::error_code a_error, b_error;
  at = std::filesystem::weakly_canonical(std::filesystem::absolute(at, a_error), a_error);
  bt = std::filesystem::weakly_canonical(std::filesystem::absolute(bt, b_error), b_error);
  return !a_error && !b_error && at == bt;
}

Result<std::string> read_file(const std::filesystem::path& path) {
  const auto unreadable = [&path](const std::string& what, const char* remedy) {
    return fail(ErrorCode::Unreadable, what, path.string(), remedy);
  };
  // System calls, not a stream: a stream's iterators throw on a read error and lose its reason.
  const int file = open_file(path, O_RDONLY);
  if (file < 0 && (errno == ENOENT || errno == ENOTDIR))
    return unreadable("there is no such file", "Check the name and the folder");
  if (file < 0)
    return unreadable(std::string("cannot be opened: ") + std::strerror(errno), "Check that you may read it");

  std::string content;
  struct stat status {};
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode))
    content.reserve(static_cast<size_t>(status.st_size));
  std::array<char, 1 << 16> piece;
  int error = 0;
  while (true) {
    const ssize_t n = ::read(file, piece.data(), piece.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) error = errno;
    if (n <= 0) break;
    content.append(piece.data(), static_cast<size_t>(n));
  }
  ::close(file);
  if (error == EISDIR) return unreadable("is a folder, not a file", "Name a file inside it");
  if (error != 0)
    return unreadable(std::string("could not be read to its end: ") + std::strerror(error),
                      "Check the disk it lies on");
  return content;
}

}  // namespace planewright
