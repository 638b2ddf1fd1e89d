#include "core/design/reference_file.h"

#include <string>
#include <utility>

#include "core/mesh/mesh_io.h"

namespace planewright {
namespace {

using Loaded = Result<std::shared_ptr<const ReferenceSurface>>;

tl::unexpected<Error> named(Error error, const std::filesystem::path& path) {
  if (error.where.find(path.string()) == std::string::npos) error.where = path.string();
  return tl::unexpected(std::move(error));
}

Loaded load(const std::filesystem::path& path) {
  const auto loaded = load_mesh(path);
  if (!loaded) return named(loaded.error(), path);
  auto surface = ReferenceSurface::create(loaded->mesh.positions(), loaded->mesh.faces(), path.string());
  if (!surface) return named(surface.error(), path);
  return surface;
}

}  // namespace

Loaded load_reference(const std::filesystem::path& path, const Vector3d& low, const Vector3d& high) {
  auto surface = load(path);
  if (!surface) return surface;
  if (auto meant = check_reference(**surface, low, high); !meant) return named(meant.error(), path);
  return surface;
}

Loaded load_reference(const std::filesystem::path& path, const PolygonMesh& mesh) {
  const Points points = mesh.positions();
  if (points.rows() == 0) return load(path);
  return load_reference(path, points.colwise().minCoeff(), points.colwise().maxCoeff());
}

}  // namespace planewright
