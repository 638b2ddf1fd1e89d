// PolygonMesh: the designer's editable half-edge mesh, faces of any valence, in double precision over
// OpenMesh.
//
// Invariants: manifold with border (every edge has one or two faces, the faces round a vertex form one fan,
// or none for an isolated vertex), consistently oriented, every face has at least 3 distinct corners.
// `from_polygons` refuses anything else; `load_mesh` (mesh_io.h) repairs first and reports what it did.
// Indices: vertices, faces and edges are 0-based and dense, and survive a flip unchanged (a flip changes
// which vertices an edge joins, never any index). Units: positions in model units, as in the file. Threads: a
// const mesh may be read by several threads; copies are deep. OpenMesh stays behind the .cpp.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"

namespace planewright {

// An edge in the direction of its half-edge 0: from a to b, with `left` the face that runs a -> b.
struct MeshEdge {
  int a = -1, b = -1;
  int left = -1, right = -1;  // faces; -1: none (border). An edge always has at least one.
  bool border() const { return left < 0 || right < 0; }
};

class PolygonMesh {
 public:
  PolygonMesh();
  PolygonMesh(const PolygonMesh&);
  PolygonMesh(PolygonMesh&&) noexcept;
  PolygonMesh& operator=(const PolygonMesh&);
  PolygonMesh& operator=(PolygonMesh&&) noexcept;
  ~PolygonMesh();

  // positions: #V x 3, model units; faces: #F lists of vertex indices, counter-clockwise seen from outside.
  // Refuses (ErrorCode::Refused, naming the first offending element) what breaks the invariants above,
  // non-finite coordinates and indices out of range.
  static Result<PolygonMesh> from_polygons(const Points& positions, const Polygons& faces);
  // The same with edges numbered as they are listed, #E pairs of vertices in the direction that edge() tells:
  // flips leave another order than the faces alone give. Refuses edges that are not those of the faces.
  static Result<PolygonMesh> from_polygons(const Points& positions, const Polygons& faces,
                                           std::span<const std::array<int, 2>> edges);

  int vertex_count() const;
  int face_count() const;
  int edge_count() const;

  const Points& positions() const;        // #V x 3, model units
  Polygons faces() const;                 // corners in the order given to from_polygons, as changed by flips
  std::vector<int> corners(int f) const;  // of one face, as faces() has them
  int valence(int f) const;               // how many
  MeshEdge edge(int e) const;
  int find_edge(int a, int b) const;  // the edge that joins two vertices, -1 if none

  // Faces round v, counter-clockwise seen from outside. At a border vertex the list begins with the face at
  // the border edge that leaves v with its face on the left, and ends with the face at the border edge that
  // arrives. Empty for an isolated vertex.
  std::vector<int> faces_around(int v) const;
  // Edges in the same order: faces_around(v)[k] lies between edges_around(v)[k] and edges_around(v)[k + 1]
  // (cyclic at an inner vertex; one more edge than faces at a border vertex).
  std::vector<int> edges_around(int v) const;
  bool is_border_vertex(int v) const;
  bool is_isolated(int v) const;

  // Whether edge e can be flipped: inner, both faces triangles, the new edge not there yet, and no vertex
  // would fall below valence 3 (2 at the border). Purely combinatorial.
  bool can_flip(int e) const;
  // Flips e; false, with nothing changed, if !can_flip(e). Flipping twice restores the connectivity; the same
  // edge joins the same two vertices again, though with left and right exchanged.
  bool flip(int e);

  // False, with nothing changed, for a place that is not finite. Precondition: v is a vertex.
  bool move_vertex(int v, const Vector3d& to);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace planewright
