// A list of faces as text: numbers and ranges, "3,17 40-44", on any number of lines; '#' begins a comment.
// Faces count from 0, as reports and the window name them. Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace planewright {

// The faces in the order of the text, of a mesh of `faces` faces. Fails with ErrorCode::Unreadable, with the
// line: no face at all, something that is neither number nor range, a range that runs backwards, a face that
// the mesh does not have, one that is listed twice. name: what errors call the text.
Result<std::vector<int>> parse_face_list(std::string_view content, const std::string& name, int faces);

}  // namespace planewright
