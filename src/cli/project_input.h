// Projects that commands begin with. Warnings go to stderr.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/edit/project.h"

namespace planewright::cli {

// Whether a command that takes a project or a mesh was given a project: by the path's ending, else by what
// the file begins with.
bool is_project(const std::string& path);

// Fails as load_project() does.
Result<Project> read_project_input(const std::string& path);

}  // namespace planewright::cli
