// Selection file: named sets of mesh elements as text; '#' begins a comment, commas and semicolons count as
// blanks:
//
//   roof: faces 0-41 57; vertices 3 4 5
//   rim: edges 12 7/8          # 7/8: the edge that joins vertices 7 and 8
//   roof: faces 60-63          # the same name again adds to it
//
// Numbers count from 0 (mesh after its repair, as reports and the window name them). Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/polygon_mesh.h"
#include "core/problem/demand.h"

namespace planewright {

// Selections in the order in which they are first named, lists ascending. name: what errors call the file.
// Fails with ErrorCode::Unreadable, with the line: no name, an unknown word, something that is neither number
// nor range, an element that the mesh does not have, a selection of nothing.
Result<std::vector<Selection>> parse_selection_file(std::string_view content, const std::string& name,
                                                    const PolygonMesh& mesh);

}  // namespace planewright
