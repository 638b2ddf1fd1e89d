// Splitting one region into connected parts. Internal to this folder.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/cluster/proxy.h"

namespace planewright {

// Each face of `region` goes to the source that is fewest faces away, through the region; of equally near
// ones to the first. Part 0 keeps its number, part k becomes region `first_new` + k - 1. Parts are connected
// if each source is. Precondition: sources (lists of faces of the region) are not empty and share no face.
void split_by_distance(const FaceGraph& graph, std::vector<int>& region_of_face, int region, int first_new,
                       const std::vector<std::vector<int>>& sources);

// Two faces of a region that are far apart, by the number of faces between them. The same twice if it has
// one.
std::array<int, 2> far_faces(const FaceGraph& graph, const std::vector<int>& region_of_face, int start);

// In two by Lloyd iterations inside the region, starting at its best and worst face; part 1 becomes
// `new_region`. False, with nothing changed, for a single face. metric: of for_regions().
bool split_by_error(const FaceGraph& graph, std::vector<int>& region_of_face, int region, int new_region,
                    const ClusterMetric& metric);

}  // namespace planewright
