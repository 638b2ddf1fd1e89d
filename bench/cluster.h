// planewright-bench cluster: what clustering a mesh into regions costs, anew and while K is dragged, and how
// well the panels follow the mesh that are solved from them.
#pragma once

#include <CLI/CLI.hpp>

namespace planewright::bench {

void declare_cluster(CLI::App& app);

}  // namespace planewright::bench
