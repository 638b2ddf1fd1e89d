#include "cli/project_input.h"

#include <cstdio>
#include <utility>

#include "core/edit/project_file.h"

namespace planewright::cli {

bool is_project(const std::string& path) {
  return is_project_file(path);
}

Result<Project> read_project_input(const std::string& path) {
  auto read = load_project(path);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& warning : read->warnings)
    std::fprintf(stderr, "planewright-cli: warning: %s\n", warning.c_str());
  return std::move(read->project);
}

}  // namespace planewright::cli
