// Models: what solvers are compared on, by the names of --models.
//
//   torus-1k, torus-10k, torus-100k, torus-1m   duals of the torus on a square grid: panels grow, shape stays
//   fertility, dragon                           quad meshes made planar
//   train-station                               dual of a triangle mesh
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/complex/tangent_complex.h"
#include "core/design/layer_settings.h"

namespace planewright::bench {

struct Model {
  std::string name;
  int grid;          // torus: vertices round the tube, and round the axis; 0: a file
  std::string file;  // relative to the folder of meshes
  double tolerance;  // first-order residual at which solves of it stop
  bool torus() const { return grid > 0; }
};

inline constexpr const char* kLargest = "torus-1m";  // for the tangent solver alone

const std::vector<Model>& all_models();
// Throws std::runtime_error, the known names listed.
const Model& find_model(const std::string& name);
std::vector<Model> find_models(const std::vector<std::string>& names);

// named, else $PLANEWRIGHT_MESHES, else shared/meshes beside the source folder or one of those above it. An
// empty path if there is none.
std::filesystem::path meshes_folder(const std::string& named);

// Whether there is a file to load, if it needs one.
bool available(const Model& model, const std::filesystem::path& meshes);

// settings: its mode becomes the one that fits the mesh. Throws std::runtime_error.
std::shared_ptr<const TangentComplex> complex_of(const Model& model, const std::filesystem::path& meshes,
                                                 LayerSettings& settings);

}  // namespace planewright::bench
