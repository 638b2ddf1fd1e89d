#include "core/base/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "support/temporary_folder.h"

namespace planewright {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

int entries(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

mode_t mode_of(const fs::path& path) {
  struct stat info {};
  EXPECT_EQ(::stat(path.c_str(), &info), 0);
  return info.st_mode & 07777;
}

// The exit status of a child process that does this; so that it may give up rights that the tests still need.
template <class Work>
int in_child(Work work) {
  const pid_t child = ::fork();
  if (child == 0) std::_Exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(WriteFileAtomically, WritesEveryByteAndNothingElse) {
  const TemporaryFolder folder;
  const std::string content("a\0b\r\n\xff", 6);
  ASSERT_TRUE(write_file_atomically(folder / "a.bin", content));
  EXPECT_EQ(read_file(folder / "a.bin").value(), content);
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(WriteFileAtomically, WritesAnEmptyFile) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder / "empty", ""));
  EXPECT_EQ(read_file(folder / "empty").value(), "");
}

TEST(WriteFileAtomically, ReplacesALongerFile) {
  const TemporaryFolder folder;
  folder.write("a.txt", std::string(100000, 'x'));
  ASSERT_TRUE(write_file_atomically(folder / "a.txt", "new"));
  EXPECT_EQ(read_file(folder / "a.txt").value(), "new");
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(WriteFileAtomically, GivesTheOldFilesPermissionsToTheNewOne) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  for (const mode_t mode : {0600, 0640, 0755}) {
    ASSERT_EQ(::chmod((folder / "a.txt").c_str(), mode), 0);
    ASSERT_TRUE(write_file_atomically(folder / "a.txt", "new"));
    EXPECT_EQ(mode_of(folder / "a.txt"), mode);
  }
}

TEST(WriteFileAtomically, ObeysTheUmask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  const auto written = write_file_atomically(folder / "a.txt", "new");
  ::umask(before);
  ASSERT_TRUE(written);
  EXPECT_EQ(mode_of(folder / "a.txt"), 0640u);
}

TEST(WriteFileAtomically, NamesAMissingFolder) {
  const TemporaryFolder folder;
  const auto written = write_file_atomically(folder / "not/there.txt", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::Unwritable);
  EXPECT_EQ(written.error().where, (folder / "not/there.txt").string());
  EXPECT_NE(written.error().what.find("No such file or directory"), std::string::npos);
  EXPECT_EQ(entries(folder.path()), 0);
}

TEST(WriteFileAtomically, RefusesAFolder) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "sub");
  const auto written = write_file_atomically(folder / "sub", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::Unwritable);
  EXPECT_TRUE(fs::is_directory(folder / "sub"));
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(WriteFileAtomically, RefusesAFileTakenForAFolder) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  const auto written = write_file_atomically(folder / "file/inner", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::Unwritable);
  EXPECT_EQ(read_file(folder / "file").value(), "old");
}

// As somebody who may not write there; root may write everywhere, so the child gives up its rights.
TEST(WriteFileAtomically, KeepsTheOldFileInAnUnwritableFolder) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  EXPECT_EQ(in_child([&] {
              if (::geteuid() == 0 && ::setuid(65534) != 0) return 3;
              const auto written = write_file_atomically(folder / "a.txt", "new");
              return !written && written.error().code == ErrorCode::Unwritable ? 0 : 1;
            }),
            0);
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
  EXPECT_EQ(read_file(folder / "a.txt").value(), "old");
  EXPECT_EQ(entries(folder.path()), 1);
}

// A disk that is full in the middle of writing, by a limit on the file's size.
TEST(WriteFileAtomically, KeepsTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  EXPECT_EQ(in_child([&] {
              std::signal(SIGXFSZ, SIG_IGN);
              rlimit limit{};
              limit.rlim_cur = limit.rlim_max = 1000;
              if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 3;
              const auto written = write_file_atomically(folder / "a.txt", std::string(5000, 'n'));
              return !written && written.error().code == ErrorCode::Unwritable ? 0 : 1;
            }),
            0);
  EXPECT_EQ(read_file(folder / "a.txt").value(), "old");
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(WriteFileAtomically, WritesThroughASymbolicLink) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "real");
  folder.write("real/a.txt", "old");
  fs::create_symlink("real/a.txt", folder / "link");
  ASSERT_TRUE(write_file_atomically(folder / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "real/a.txt").value(), "new");
  EXPECT_EQ(entries(folder.path()), 2);
}

TEST(WriteFileAtomically, CreatesWhatADanglingLinkPointsTo) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "real");
  fs::create_symlink("real/a.txt", folder / "link");
  fs::create_symlink("link", folder / "link to link");
  ASSERT_TRUE(write_file_atomically(folder / "link to link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link to link"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "real/a.txt").value(), "new");
}

TEST(WriteFileAtomically, RefusesLinksThatRunInACircle) {
  const TemporaryFolder folder;
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  const auto written = write_file_atomically(folder / "a", "new");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::Unwritable);
  EXPECT_TRUE(fs::is_symlink(folder / "a"));
  EXPECT_FALSE(read_file(folder / "a"));
}

// Such as /dev/stdout of a program whose output goes to another one.
TEST(WriteFileAtomically, WritesIntoAPipe) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const auto written = write_file_atomically("/dev/fd/" + std::to_string(ends[1]), "through");
  ::close(ends[1]);
  char buffer[16] = {};
  EXPECT_EQ(::read(ends[0], buffer, sizeof buffer), 7);
  ::close(ends[0]);
  ASSERT_TRUE(written) << written.error().text();
  EXPECT_STREQ(buffer, "through");
}

TEST(WriteFileAtomically, TakesTheLongestNameThatTheSystemTakes) {
  const TemporaryFolder folder;
  const std::string name(255, 'n');
  ASSERT_TRUE(write_file_atomically(folder / name, "new"));
  EXPECT_EQ(read_file(folder / name).value(), "new");
}

TEST(WriteFileAtomically, WritesToDevices) {
  EXPECT_TRUE(write_file_atomically("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  const auto written = write_file_atomically("/dev/full", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::Unwritable);
  EXPECT_NE(written.error().what.find("No space left"), std::string::npos);
  EXPECT_NE(written.error().remedy.find("Make room"), std::string::npos) << written.error().remedy;
}

TEST(ReadFile, NamesAMissingFile) {
  const TemporaryFolder folder;
  const auto content = read_file(folder / "none.obj");
  ASSERT_FALSE(content);
  EXPECT_EQ(content.error().code, ErrorCode::Unreadable);
  EXPECT_EQ(content.error().where, (folder / "none.obj").string());
}

TEST(ReadFile, RefusesAFolder) {
  const TemporaryFolder folder;
  const auto content = read_file(folder.path());
  ASSERT_FALSE(content);
  EXPECT_EQ(content.error().code, ErrorCode::Unreadable);
  EXPECT_NE(content.error().what.find("folder"), std::string::npos);
}

TEST(ReadFile, NamesAFileThatMayNotBeRead) {
  const TemporaryFolder folder;
  folder.write("secret", "x");
  ASSERT_EQ(::chmod((folder / "secret").c_str(), 0), 0);
  EXPECT_EQ(in_child([&] {
              if (::geteuid() == 0 && ::setuid(65534) != 0) return 3;
              const auto content = read_file(folder / "secret");
              return !content && content.error().code == ErrorCode::Unreadable ? 0 : 1;
            }),
            0);
}

}  // namespace
}  // namespace planewright
