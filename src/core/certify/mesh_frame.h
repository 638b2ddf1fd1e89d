// The points of a file of polygons in the model's frame, and how exactly they can be there. Internal to
// certify/. Threads: pure.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/certify/certificate.h"
#include "core/certify/read_mesh.h"

namespace planewright {

enum class MeshFileFormat { Obj, Ply, Stl, ThreeMf, Gltf };
// By the ending, any case; nothing: none of them.
std::optional<MeshFileFormat> mesh_format_of(std::string_view file);

// mm, relative to the model's origin: STL is so by itself, the others hold absolute coordinates; glTF has
// metres with y up.
Points in_model_frame(const ReadMesh& mesh, MeshFileFormat format, const WorkshopModel& model);

// How far a coordinate may be off, mm: 1e-6, or what single precision makes of the file's largest one.
double coordinate_limit(const ReadMesh& mesh, MeshFileFormat format);

// What the file says of its unit, and how large it is against `wanted` (mm, relative to origin).
Check scale_check(const ReadMesh& mesh, MeshFileFormat format, const Points& points, const Points& wanted);

// Objects of the file by panel: faces of each, for panels listed in `wanted`; and the check that these and no
// others are there, each once. Without objects (STL): empty.
struct MeshObjects {
  std::vector<std::vector<int>> faces_of_panel;  // #P
  Check check;
};
MeshObjects objects_by_name(const ReadMesh& mesh, const std::vector<int>& wanted, const WorkshopModel& model);

// Whether two sets of points are the same: the largest distance of one of either from the nearest of the
// other.
double set_distance(const Points& a, const Points& b);

}  // namespace planewright
