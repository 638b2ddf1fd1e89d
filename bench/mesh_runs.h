// What benches of parts of the program have in common: real meshes beside a model by formula, each measured
// so often.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "core/mesh/polygon_mesh.h"

namespace planewright::bench {

struct MeshRunOptions {
  std::string meshes;  // folder; empty: meshes_folder() looks for it
  int repeat = 5;
};

// --meshes and --repeat.
void declare_mesh_run(CLI::App& command, MeshRunOptions& options);

// Loads each of the files below the folder of meshes and measures it; says of those that are not there that
// they were skipped. Throws std::runtime_error.
void for_each_mesh(const MeshRunOptions& options, const std::vector<std::string>& files,
                   const std::function<void(const std::string& file, const PolygonMesh& mesh)>& measure);

// Least CPU time of so many runs, ms.
double best_ms(int repeat, const std::function<void()>& work);

}  // namespace planewright::bench
