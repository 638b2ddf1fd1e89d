#include "demands.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "core/design/design.h"
#include "core/design/layer_solve.h"
#include "core/design/presets.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "core/solve/solver_choice.h"
#include "table.h"

namespace planewright::bench {
namespace {

template <class T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().text());
  return std::move(*result);
}

// offset_edges: in mean panel edges.
Row solve(const std::string& name, const PolygonMesh& mesh, LayerSettings settings, double offset_edges) {
  settings.offset = 0.0;
  const double edge = value_of(build_complex(mesh, settings))->mean_edge;
  settings.offset = offset_edges * edge;
  const auto begun = std::chrono::steady_clock::now();
  const double cpu = cpu_seconds();
  const auto complex = value_of(build_complex(mesh, settings));
  Row row;
  row.name = name;
  row.report = value_of(solve_layer(*make_solver(SolverKind::Ipopt), {complex, settings, {}, {}, {}}, start_state(*complex, settings),
                                    solve_options(settings), nullptr, {}));
  row.cpu = cpu_seconds() - cpu;
  row.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  measure_state(row, *complex, complex->mean_edge);
  return row;
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

void measure_non_penetration(const std::vector<std::string>& files, const std::vector<double>& offsets,
                             const std::vector<std::string>& also) {
  LayerSettings settings;
  settings.demands.list = {{"vertex"}, {"face"}, {"edge"}};
  for (const std::string& name : also) settings.demands.list.push_back({name});
  settings.no_penetration = true;
  std::printf(
      "duals with the vertex, face and edge constraints; cross: pairs of a panel and a mesh triangle\n");
  print_head();
  for (const double offset : offsets) {
    const auto measure = [&](const std::string& name, const PolygonMesh& mesh) {
      char label[64];
      std::snprintf(label, sizeof label, "%s, offset %g", name.c_str(), offset);
      print(solve(label, mesh, settings, offset));
    };
    if (files.empty()) {
      measure("torus, 1600 vertices", make_torus(40, 40));
      for (const char* sample : {"dome", "alpine-hut", "train-station", "train-station-unsymmetric"})
        measure(sample, value_of(make_sample(sample, 0)));
    }
    for (const std::string& file : files) measure(file_name(file), value_of(load_mesh(file)).mesh);
  }
}

void measure_uncrossed(const std::vector<std::string>& files) {
  LayerSettings settings;
  settings.mode = ComplexKind::Planarize;
  if (const auto applied = apply(*value_of(find_preset("uncrossed")), settings); !applied)
    throw std::runtime_error(applied.error().text());
  std::printf("planarized with the preset 'uncrossed'; self-x: panels that cross themselves\n");
  print_head();
  for (const std::string& file : files)
    print(solve(file_name(file), value_of(load_mesh(file)).mesh, settings, 0.0));
}

}  // namespace planewright::bench
