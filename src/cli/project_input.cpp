#include "cli/project_input.h"

#include <cstdio>
#include <filesystem>
#include <utility>

#include "core/design/design.h"
#include "core/edit/project_file.h"
#include "core/mesh/mesh_io.h"

namespace planewright::cli {

Result<Project> load_project_or_mesh(const std::string& path) {
  if (is_project_file(path)) {
    auto read = load_project(path);
    if (!read) return tl::unexpected(read.error());
    for (const std::string& warning : read->warnings)
      std::fprintf(stderr, "planewright-cli: warning: %s\n", warning.c_str());
    return std::move(read->project);
  }
  auto loaded = load_mesh(path);
  if (!loaded) return tl::unexpected(loaded.error());
  if (!loaded->health.healthy())
    std::fprintf(stderr, "planewright-cli: note: %s: %s\n", path.c_str(), loaded->health.summary().c_str());
  Design design;
  design.layers.front().settings.mode = suggested_mode(loaded->mesh);
  return new_project(std::filesystem::path(path).filename().string(), std::move(loaded->mesh),
                     std::move(design));
}

}  // namespace planewright::cli
