// The file of a reference surface, as the command line and the window read it: one that cannot be meant for
// the mesh at hand is refused in both. Threads: pure.
#pragma once

#include <filesystem>
#include <memory>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

// low, high: the mesh's bounding box, model coordinates. Fails as load_mesh, ReferenceSurface::create and
// check_reference do; every error names the file as `path` says it.
Result<std::shared_ptr<const ReferenceSurface>> load_reference(const std::filesystem::path& path,
                                                               const Vector3d& low, const Vector3d& high);

// For the box of a mesh; one without vertices takes any reference.
Result<std::shared_ptr<const ReferenceSurface>> load_reference(const std::filesystem::path& path,
                                                               const PolygonMesh& mesh);

}  // namespace planewright
