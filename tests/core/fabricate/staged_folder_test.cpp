#include "core/fabricate/staged_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>
#include <set>

#include "core/fabricate/earlier_export.h"
#include "support/temporary_folder.h"

namespace planewright {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Everything below a folder, hidden files too.
std::set<std::string> below(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    names.insert(fs::relative(entry.path(), folder).string());
  return names;
}

TEST(StagedFolder, ANewFolderAppearsWhole) {
  const test::TemporaryFolder folder;
  {
    auto staged = StagedFolder::at(folder / "out");
    ASSERT_TRUE(staged);
    ASSERT_TRUE(staged->write("sheets/sheet-01.dxf", "one"));
    ASSERT_TRUE(staged->write("panels.csv", "two"));
    EXPECT_FALSE(fs::exists(folder / "out"));
    ASSERT_TRUE(staged->publish({"sheets/sheet-01.dxf", "panels.csv"}, {}));
  }
  EXPECT_EQ(below(folder.path()),
            (std::set<std::string>{"out", "out/panels.csv", "out/sheets", "out/sheets/sheet-01.dxf"}));
  EXPECT_EQ(content(folder / "out/panels.csv"), "two");
}

TEST(StagedFolder, WithoutPublishingNothingIsLeft) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "there");
  folder.write("there/panels.csv", "old");
  for (const char* target : {"out", "there"}) {
    auto staged = StagedFolder::at(folder / target);
    ASSERT_TRUE(staged);
    ASSERT_TRUE(staged->write("panels.csv", "new"));
  }
  EXPECT_EQ(below(folder.path()), (std::set<std::string>{"there", "there/panels.csv"}));
  EXPECT_EQ(content(folder / "there/panels.csv"), "old");
}

TEST(StagedFolder, FilesThatAreThereAreReplacedAndStaleOnesGo) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder / "out/sheets");
  folder.write("out/sheets/sheet-01.dxf", "old");
  folder.write("out/sheets/sheet-02.dxf", "old");
  folder.write("out/notes.txt", "mine");
  {
    auto staged = StagedFolder::at(folder / "out/");
    ASSERT_TRUE(staged);
    ASSERT_TRUE(staged->write("sheets/sheet-01.dxf", "new"));
    ASSERT_TRUE(staged->write("solids/all.obj", "new"));
    ASSERT_TRUE(staged->publish({"sheets/sheet-01.dxf", "solids/all.obj"}, {"sheets/sheet-02.dxf"}));
  }
  EXPECT_EQ(below(folder / "out"), (std::set<std::string>{"notes.txt", "sheets", "sheets/sheet-01.dxf",
                                                          "solids", "solids/all.obj"}));
  EXPECT_EQ(content(folder / "out/sheets/sheet-01.dxf"), "new");
}

TEST(StagedFolder, AMoveThatFailsTakesTheOthersBack) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder / "out");
  folder.write("out/a.csv", "old a");
  folder.write("out/stale.csv", "old");
  {
    auto staged = StagedFolder::at(folder / "out");
    ASSERT_TRUE(staged);
    ASSERT_TRUE(staged->write("a.csv", "new a"));
    ASSERT_TRUE(staged->write("sub/b.csv", "new b"));
    // Named, but never written.
    const auto published = staged->publish({"a.csv", "sub/b.csv", "c.csv"}, {"stale.csv"});
    ASSERT_FALSE(published);
    EXPECT_EQ(published.error().code, ErrorCode::Unwritable);
    EXPECT_NE(published.error().text().find("c.csv"), std::string::npos) << published.error().text();
  }
  EXPECT_EQ(below(folder / "out"), (std::set<std::string>{"a.csv", "stale.csv"}));
  EXPECT_EQ(content(folder / "out/a.csv"), "old a");
}

TEST(StagedFolder, FoldersThatCannotBeMadeAreNamed) {
  const test::TemporaryFolder folder;
  folder.write("file", "");
  for (const char* target : {"missing/out", "file", "file/out"}) {
    const auto staged = StagedFolder::at(folder / target);
    ASSERT_FALSE(staged) << target;
    EXPECT_EQ(staged.error().code, ErrorCode::Unwritable);
    EXPECT_NE(staged.error().text().find(target), std::string::npos) << staged.error().text();
  }
}

TEST(EarlierExport, OnlyFilesBelowTheFolderThatAreThereCount) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(files_of_earlier_export(folder.path()).empty());
  fs::create_directory(folder / "out");
  folder.write("outside.dxf", "");
  folder.write("out/a.dxf", "");
  folder.write(
      "out/certificate.json",
      R"({"format":"planewright certificate","files":[{"file":"a.dxf"},{"file":"gone.dxf"},{"file":"../outside.dxf"},{"file":7}]})");
  EXPECT_EQ(files_of_earlier_export(folder / "out"), (std::vector<std::string>{"a.dxf", "certificate.json"}));
}

TEST(EarlierExport, CertificatesOfOthersCountForNothing) {
  const test::TemporaryFolder folder;
  folder.write("a.dxf", "");
  for (const char* text : {R"({"format":"other","files":[{"file":"a.dxf"}]})", R"({"format":7,"files":[]})",
                           "[1]", "{", R"({"format":"planewright certificate","files":7})"}) {
    folder.write("certificate.json", text);
    EXPECT_TRUE(files_of_earlier_export(folder.path()).empty()) << text;
  }
}

}  // namespace
}  // namespace planewright
