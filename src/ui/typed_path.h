// Paths as people type them. Threads: pure.
#pragma once

#include <filesystem>
#include <string>

namespace planewright::ui {

// The designer's own folder; "/" where nothing says which it is.
std::filesystem::path home_folder();
// "~" and "~/..." lead from there; all else is taken as it stands.
std::filesystem::path typed_path(const std::string& text);

}  // namespace planewright::ui
