// MeshEdit: one edit of a mesh as a value, whether a mesh allows it, and the mesh that it leads to.
//
// An edit names elements of the mesh that it applies to. The edited mesh is manifold again, its surface the
// same up to bending (only DeleteFace changes the Euler characteristic). Survivors keep their order and, but
// for a vertex that the edit moves, their positions bit for bit; new vertices and faces come at the end. Flip
// and MoveVertex change no index; the others number the edges anew, by the faces.
//
//   Flip        the edge between two triangles joins their other two corners
//   Join        an inner edge goes, its two faces become one: that of the lower index
//   SplitEdge   a vertex in the edge; a triangle beside it is split to its opposite corner, larger faces get
//               a corner more. The edge, and each triangle, stays the part at edge(element).a
//   SplitFace   a diagonal between two corners. The face stays the part that runs corners[0] -> corners[1]
//   Collapse    the ends of the edge become one vertex, triangles beside it go. The survivor is the end on
//               the border if there is one such end, else the end of the lower index
//   MoveVertex  the vertex moves to the place `to`
//   DeleteFace  the face, and vertices that are of no other one
//
// Units: model units. Indices 0-based. Threads: pure. Failure: ErrorCode::Refused, with the reason, the
// element, and what to do instead.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/mesh/element_map.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

enum class EditKind { Flip, Join, SplitEdge, SplitFace, Collapse, MoveVertex, DeleteFace };

struct MeshEdit {
  EditKind kind = EditKind::Flip;
  int element = -1;                    // vertex (MoveVertex), face (SplitFace, DeleteFace), else edge
  std::array<int, 2> corners{-1, -1};  // SplitFace: vertices
  std::optional<Vector3d> to = {};     // place of the new, merged or moved vertex. None: SplitEdge and
                                       // Collapse take the midpoint, or where the survivor is on the border

  static MeshEdit flip(int edge) { return {EditKind::Flip, edge}; }
  static MeshEdit join(int edge) { return {EditKind::Join, edge}; }
  static MeshEdit split_edge(int edge, std::optional<Vector3d> to = {}) {
    return {EditKind::SplitEdge, edge, {-1, -1}, to};
  }
  static MeshEdit split_face(int face, int from, int to) { return {EditKind::SplitFace, face, {from, to}}; }
  static MeshEdit collapse(int edge, std::optional<Vector3d> to = {}) {
    return {EditKind::Collapse, edge, {-1, -1}, to};
  }
  static MeshEdit move_vertex(int vertex, const Vector3d& to) {
    return {EditKind::MoveVertex, vertex, {-1, -1}, to};
  }
  static MeshEdit delete_face(int face) { return {EditKind::DeleteFace, face}; }

  bool operator==(const MeshEdit&) const = default;
};

const char* name(EditKind kind);  // "split-edge": in reports
// "Flip edge 1042"
std::string describe(const MeshEdit& edit);

// Looks at the neighbourhood alone: cheap enough to ask for every edge of a mesh.
Result<void> may_apply(const PolygonMesh& mesh, const MeshEdit& edit);

struct EditedMesh {
  PolygonMesh mesh;
  ElementMap map;  // from the mesh before
};
// The same edit of a mesh that `map` leads to. -1 in place of an element that is gone.
MeshEdit renumbered(const MeshEdit& edit, const ElementMap& map);

// Refused as by may_apply(). O(mesh).
Result<EditedMesh> apply(const PolygonMesh& mesh, const MeshEdit& edit);

}  // namespace planewright
