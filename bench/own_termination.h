// Solves that end by each solver's own termination, as the "Measured" tables of docs/solver.md show them: the
// shipped general solver against the frozen baselines on a torus, and by itself on real meshes.
#pragma once

#include <string>
#include <vector>

namespace planewright::bench {

// The dual of a torus of rows x columns vertices. Each ends by its own options: residuals differ.
void compare_on_torus(int rows, int columns, bool baselines);

// `files`, with the default settings that fit them.
void measure_meshes(const std::vector<std::string>& files);

}  // namespace planewright::bench
