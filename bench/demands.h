// Solves with demands, as the command line makes them: the paper's constraints on designs and real meshes,
// and quads that do not cross themselves.
#pragma once

#include <string>
#include <vector>

namespace planewright::bench {

struct DemandOptions {
  std::vector<std::string> files;
  std::vector<double> offsets{0.2};           // mean panel edges
  std::vector<std::string> also;              // further demands, by name
  std::vector<std::string> solvers{"ipopt"};  // by the names of solver_choice.h
  double seconds = 900.0;                     // a row is cut off after so long
};

// The torus of 1,600 vertices, the dome, the alpine hut and both stations, or `files`: their duals with the
// vertex, face and edge constraints (and `also`) on and crossings counted, at each offset, by each solver.
void measure_non_penetration(const DemandOptions& options);

// `files`, planarized with the preset "uncrossed", by each solver.
void measure_uncrossed(const DemandOptions& options);

}  // namespace planewright::bench
