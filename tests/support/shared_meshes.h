// The folder of external real meshes. It lies outside the repository; tests that need it skip without it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace planewright::test {

// $PLANEWRIGHT_MESHES, or shared/meshes beside the source folder or one of the folders above it.
inline std::optional<std::filesystem::path> shared_meshes() {
  namespace fs = std::filesystem;
  std::error_code error;
  if (const char* named = std::getenv("PLANEWRIGHT_MESHES")) {
    if (fs::is_directory(named, error)) return fs::path(named);
    return {};
  }
  for (fs::path folder = PLANEWRIGHT_SOURCE_DIR; folder.has_relative_path(); folder = folder.parent_path()) {
    const fs::path meshes = folder.parent_path() / "shared" / "meshes";
    if (fs::is_directory(meshes, error)) return meshes;
  }
  return {};
}

}  // namespace planewright::test

// Declares `folder` (std::filesystem::path), or skips the test.
#define PLANEWRIGHT_SHARED_MESHES_OR_SKIP(folder)                                                \
  if (!planewright::test::shared_meshes())                                                       \
    GTEST_SKIP() << "the external meshes are not here; name their folder in PLANEWRIGHT_MESHES"; \
  const std::filesystem::path folder = *planewright::test::shared_meshes()
