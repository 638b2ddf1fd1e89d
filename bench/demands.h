// Solves with demands, as the command line makes them: the paper's constraints on designs and real meshes,
// and quads that do not cross themselves.
#pragma once

#include <string>
#include <vector>

namespace planewright::bench {

// The torus of 1,600 vertices, the dome, the alpine hut and both stations, and `files`: their duals with the
// vertex, face and edge constraints (and `also`) on and crossings counted, at each offset (mean panel edges).
void measure_non_penetration(const std::vector<std::string>& files, const std::vector<double>& offsets,
                             const std::vector<std::string>& also);

// `files`, planarized with the preset "uncrossed".
void measure_uncrossed(const std::vector<std::string>& files);

}  // namespace planewright::bench
