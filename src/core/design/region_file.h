// The file that says which region each face of a mesh belongs to: "face,region" and a line for each face, as
// spreadsheets and scripts read it. Regions are the panels, by number. Threads: pure.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace planewright {

std::string region_csv(std::span<const int> region_of_face);

// The region of each of `faces` faces. Fails with ErrorCode::Unreadable and the line: not two numbers, a face
// that is none of the mesh's, that is listed twice or not at all, a region below 0 or as large as `faces`.
// name: of the file.
Result<std::vector<int>> parse_region_csv(std::string_view content, const std::string& name, int faces);

}  // namespace planewright
