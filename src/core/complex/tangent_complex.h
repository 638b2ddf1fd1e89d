// TangentComplex: planes, points, and which point lies on which plane. The one structure behind all
// applications
// ([Zimmer et al.], sections 2 and 4); only the builder differs (dual.h, planarize.h, cluster.h).
//
//   plane i: { x : n_i . (x - v_i) = h_i }, anchor v_i, unit normal n_i, signed offset h_i along n_i
//   point j: wanted position f_j; has to lie on each of its planes (its valence is their number, >= 1)
//   panel i: the points of plane i, in cyclic order, counter-clockwise seen from the tip of n_i
//
// The sign of h: [Z 2.2] derives n.(x - (v + h n)) = 0 but prints n.x = n.v - h. The derivation gives
// n.x = n.v + h, which we use: h >= 0 lifts a plane along its normal, as the face constraint of [Z 3] needs.
//
// Units: model units, relative to `origin`, so that a model far from 0 loses no digits. Indices: 0-based.
// Threads: plain data, immutable once built; share it as std::shared_ptr<const TangentComplex>.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

enum class ComplexKind { Dual, Planarize, Cluster };

// What a point stands for in the mesh that the complex was built from.
enum class PointKind {
  Face,        // dual: a primal face                      element = face
  BorderEdge,  // dual, closed border: a primal border edge   element = edge
  Corner,      // dual, closed border: a primal border vertex element = vertex
  Vertex,      // planarize: a vertex; cluster: a corner of regions   element = vertex
};
struct PointOrigin {
  PointKind kind;
  int element;
  bool operator==(const PointOrigin&) const = default;
};

// Two panel corners that follow each other; `left` runs a -> b, `right` b -> a; -1: no panel there (border).
struct PanelEdge {
  int a, b;
  int left, right;
  bool border() const { return left < 0 || right < 0; }
};

// The designer's mesh, as the constraints of [Z 3] and closeness refer to it. Relative to the origin of the
// complex; indices are the mesh's own.
struct InputSurface {
  Points vertices;        // #V x 3
  Points vertex_normals;  // #V x 3, unit, area-weighted
  Polygons faces;
  Points face_normals;                    // #F x 3, unit
  std::vector<std::array<int, 2>> edges;  // #E, the vertices at both ends
};

struct TangentComplex {
  ComplexKind kind = ComplexKind::Dual;
  Vector3d origin = Vector3d::Zero();  // model coordinates of the local 0

  Points anchors;                 // #P x 3, v_i
  Points normals;                 // #P x 3, unit, at the start
  Vector offsets;                 // #P, h_i at the start
  std::vector<int> plane_origin;  // #P: dual: primal vertex; planarize: face; cluster: region

  Points preferred;                       // #X x 3, f_j
  std::vector<PointOrigin> point_origin;  // #X

  Polygons panels;           // #P lists of points
  Polygons planes_of_point;  // #X lists of planes, ascending; may hold more planes than panels show
  std::vector<PanelEdge> panel_edges;

  InputSurface input;
  // Dual: the mesh face that a point belongs to, a border point to its one face; -1 for corners. Others: -1.
  std::vector<int> face_of_point;  // #X
  // Dual: the mesh vertices {i, j} of the mesh edge that a panel edge crosses; the outline of i's panel runs
  // a -> b, that of j's b -> a, whether or not they have a panel. {-1, -1}: along the border, and others.
  std::vector<std::array<int, 2>> crossed_edge;  // #panel_edges
  // Cluster: the region (= plane) of each mesh face. Others: empty.
  std::vector<int> region_of_face;  // #F

  // Mean length of the panel edges at the preferred positions: "one edge", the unit of weights, margins and
  // tolerances. 1 if there is no panel edge of positive length.
  double mean_edge = 1.0;

  int plane_count() const { return static_cast<int>(anchors.rows()); }
  int point_count() const { return static_cast<int>(preferred.rows()); }
  int incidence_count() const { return static_cast<int>(planes_of_point.indices().size()); }

  // Neighbours of each point along panel edges, ascending (#X lists). For a border point of the outline only
  // its neighbours along the border, so that fairing does not pull an outline inwards.
  Polygons fairing_neighbours() const;
};

// Fills panel_edges and mean_edge from panels and preferred; every builder ends with it.
void finish(TangentComplex& complex);

}  // namespace planewright
