// Suggestions for a mesh, and what a design is worth, in the JSON reports of this folder. Internal to
// export/. Scores: mean panel edges squared. Threads: pure.
#pragma once

#include <vector>

#include "core/advise/advisor.h"
#include "core/advise/design_measure.h"
#include "core/export/json_parts.h"

namespace planewright {

// mesh: that the suggestions are for. Each with its gain's parts, which add up to it.
Json suggestions_json(const std::vector<Suggestion>& ranked, const PolygonMesh& mesh);
Json measure_json(const DesignMeasure& measure);

}  // namespace planewright
