// Project file: NAME.planewright, one document as JSON text that people and version control can read. What
// the keys mean is in docs/project-file.md.
//
// Numbers are written with as many digits as it takes to get the very same double again; a project that was
// read and is written again is the same text. Versions: a file of a higher version than ours is refused; keys
// that we do not know, in a file of ours, are left out with a warning. Threads: no shared state.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/edit/project.h"

namespace planewright {

inline constexpr std::string_view kProjectEnding = ".planewright";
inline constexpr std::string_view kProjectFormat = "planewright project";  // the file's "format"
inline constexpr int kProjectVersion = 1;

struct ReadProject {
  Project project;
  std::vector<std::string> warnings;  // what of the file is left out, each with its place
};

// Refused, with the place: numbers that are not finite, texts that are not UTF-8.
Result<std::string> format_project(const Project& project);

// name: what errors call the file. Fails with ErrorCode::Unreadable, with the line or the key, what is wrong
// there and what to do: no JSON, another format, a higher version, values and indices that make no sense.
Result<ReadProject> read_project(std::string_view text, const std::string& name);

// Whole or not at all. Fails as format_project() does (with the path), or with ErrorCode::Unwritable.
Result<void> save_project(const std::filesystem::path& path, const Project& project);
// Fails as read_project() does; for devices, pipes and files of more than 2 GB.
Result<ReadProject> load_project(const std::filesystem::path& path);

// Whether the path's ending, any case, or else the beginning of the file says that it is a project.
bool is_project_file(const std::filesystem::path& path);

}  // namespace planewright
