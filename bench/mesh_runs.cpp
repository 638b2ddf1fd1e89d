#include "mesh_runs.h"

#include <algorithm>
#include <filesystem>

#include "core/mesh/mesh_io.h"
#include "measurement.h"
#include "models.h"
#include "table.h"
#include "value_of.h"

namespace planewright::bench {

void declare_mesh_run(CLI::App& command, MeshRunOptions& options) {
  command.add_option(
      "--meshes", options.meshes,
      "Folder of the real meshes (default: $PLANEWRIGHT_MESHES, else shared/meshes near the source)");
  command.add_option("--repeat", options.repeat, "Measure each so often; the least CPU time counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
}

void for_each_mesh(const MeshRunOptions& options, const std::vector<std::string>& files,
                   const std::function<void(const std::string& file, const PolygonMesh& mesh)>& measure) {
  const std::filesystem::path meshes = meshes_folder(options.meshes);
  for (const std::string& file : files) {
    std::error_code error;
    if (meshes.empty() || !std::filesystem::is_regular_file(meshes / file, error))
      print_skipped(file, "it is not there; name its folder with --meshes");
    else
      measure(file, value_of(load_mesh((meshes / file).string())).mesh);
  }
}

double best_ms(int repeat, const std::function<void()>& work) {
  double best = 0.0;
  for (int k = 0; k < repeat; ++k) {
    const double begun = cpu_seconds();
    work();
    const double ms = 1e3 * (cpu_seconds() - begun);
    best = k == 0 ? ms : std::min(best, ms);
  }
  return best;
}

}  // namespace planewright::bench
