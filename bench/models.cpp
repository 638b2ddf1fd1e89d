#include "models.h"

#include <cstdlib>

#include "core/design/design.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "core/solve/solver.h"
#include "value_of.h"

namespace planewright::bench {
namespace {

// The torus's tolerance is the one that its goals are stated for; elsewhere the one that designers get.
constexpr double kTorusTolerance = 1e-3;

}  // namespace

const std::vector<Model>& all_models() {
  static const double usual = SolveOptions{}.tolerance;
  static const std::vector<Model> all{{"torus-1k", 32, "", kTorusTolerance},
                                      {"torus-10k", 100, "", kTorusTolerance},
                                      {"torus-100k", 316, "", kTorusTolerance},
                                      {"torus-1m", 1000, "", kTorusTolerance},
                                      {"fertility", 0, "quad/fertility_quad.off", usual},
                                      {"dragon", 0, "quad/dragon_quad.obj", usual},
                                      {"train-station", 0, "tri/train-station.off", usual}};
  return all;
}

const Model& find_model(const std::string& name) {
  std::string known;
  for (const Model& model : all_models()) {
    if (model.name == name) return model;
    known += (known.empty() ? "" : ", ") + model.name;
  }
  throw std::runtime_error("--models " + name + ": there is no such model. Known: " + known);
}

std::vector<Model> find_models(const std::vector<std::string>& names) {
  std::vector<Model> models;
  for (const std::string& name : names) models.push_back(find_model(name));
  return models;
}

std::filesystem::path meshes_folder(const std::string& named) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!named.empty()) {
    if (!fs::is_directory(named, error)) throw std::runtime_error("--meshes " + named + ": no such folder");
    return named;
  }
  if (const char* environment = std::getenv("PLANEWRIGHT_MESHES"))
    return fs::is_directory(environment, error) ? fs::path(environment) : fs::path();
  for (fs::path folder = PLANEWRIGHT_SOURCE_DIR; folder.has_relative_path(); folder = folder.parent_path()) {
    const fs::path meshes = folder.parent_path() / "shared" / "meshes";
    if (fs::is_directory(meshes, error)) return meshes;
  }
  return {};
}

bool available(const Model& model, const std::filesystem::path& meshes) {
  std::error_code error;
  return model.torus() || (!meshes.empty() && std::filesystem::is_regular_file(meshes / model.file, error));
}

std::shared_ptr<const TangentComplex> complex_of(const Model& model, const std::filesystem::path& meshes,
                                                 LayerSettings& settings) {
  const PolygonMesh mesh = model.torus() ? make_torus(model.grid, model.grid)
                                         : value_of(load_mesh((meshes / model.file).string())).mesh;
  settings.mode = suggested_mode(mesh);
  return value_of(build_complex(mesh, settings));
}

}  // namespace planewright::bench
