// Suggestions for the mesh, ranked, as a table on stdout.
#pragma once

#include <vector>

#include "core/advise/advisor.h"

namespace planewright::cli {

// mesh: that they are for.
void print_suggestions(const std::vector<Suggestion>& ranked, const PolygonMesh& mesh);

}  // namespace planewright::cli
