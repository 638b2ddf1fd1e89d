// FaceGraph: what clustering needs of a mesh, computed once: which faces lie beside each other, and each
// face's area, normal, centre and second moments, in flat arrays.
//
// Frame: all geometry is relative to `origin` (the centre of the bounding box of the used vertices) and in
// units of `length` (the square root of the mesh's area), so that the areas add up to 1 and scaling or moving
// a model changes nothing. Corners: corner c is an entry of faces.indices(); its edge runs from there to the
// next corner of the same face. Indices: 0-based, the mesh's own. Threads: immutable once made.
#pragma once

#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

// Symmetric 3 x 3: xx, xy, xz, yy, yz, zz.
using SecondMoments = Eigen::Matrix<double, 6, 1>;

struct FaceShape {
  Vector3d normal;  // unit, by Newell's vector; 0 for a face without area
  Vector3d centre;  // of its area
  double area;      // share of the whole
};

class FaceGraph {
 public:
  // Refused: no faces, no face with area.
  static Result<FaceGraph> create(const PolygonMesh& mesh);

  int face_count() const { return faces.size(); }
  int next(int c) const {
    return c + 1 == faces.offsets()[face_of_corner[c] + 1] ? faces.offsets()[face_of_corner[c]] : c + 1;
  }
  int previous(int c) const {
    return c == faces.offsets()[face_of_corner[c]] ? faces.offsets()[face_of_corner[c] + 1] - 1 : c - 1;
  }
  int tail(int c) const { return faces.indices()[c]; }
  int head(int c) const { return faces.indices()[next(c)]; }
  // The vertex's next corner, counter-clockwise or clockwise; -1 beyond the border.
  int turn_left(int c) const { return across[previous(c)]; }
  int turn_right(int c) const { return across[c] < 0 ? -1 : next(across[c]); }
  Vector3d to_model(const Vector3d& point) const { return origin + length * point; }

  Vector3d origin = Vector3d::Zero();  // model coordinates
  double length = 1.0;                 // model units

  Points vertices;                     // #V x 3
  Polygons faces;                      // #F
  std::vector<FaceShape> shapes;       // #F
  std::vector<SecondMoments> moments;  // #F: the integral of (x - centre)(x - centre)^T over the face
  std::vector<int> face_of_corner;     // #C
  std::vector<int> across;  // #C: the corner whose edge is the same, the other way round; -1: border
  std::vector<int> beside;  // #C: the face of that corner; -1: border
  std::vector<int>
      corner_of_vertex;  // #V: one that begins there, at the border the first counter-clockwise; -1: isolated
  std::vector<char> on_border;         // #V
  std::vector<int> component_of_face;  // #F
  std::vector<char> closed;            // #components: it has no border
  int component_count() const { return static_cast<int>(closed.size()); }
  int edge_count = 0;

  // V - E + F, isolated vertices left out.
  int euler_characteristic() const;
};

}  // namespace planewright
