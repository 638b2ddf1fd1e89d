// The designs that commands begin with which take a project or a mesh. Warnings go to stderr.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/edit/project.h"

namespace planewright::cli {

// A project as it was saved, or a mesh as a design that nothing is set of but the mode that suits it. Fails
// as load_project() and load_mesh() do.
Result<Project> load_project_or_mesh(const std::string& path);

}  // namespace planewright::cli
