// LocalMesh: a mesh's geometry relative to a point of its own, as both builders need it. Internal to
// complex/.
//
// Subtracting a nearby point first keeps every digit of a model that lies far from 0: all later differences
// are taken between small numbers. Units: model units. Threads: a plain value.
#pragma once

#include "core/base/geometry.h"
#include "core/complex/tangent_complex.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

struct LocalMesh {
  explicit LocalMesh(const PolygonMesh& mesh);

  Vector3d origin;    // model coordinates of the local 0: the centre of the bounding box of the used vertices
  Points positions;   // #V x 3
  Points face_areas;  // #F x 3, Newell vectors (twice the vector area)

  // Unit; z for a face without area that has no neighbour with one.
  Vector3d face_normal(int f) const { return face_normals_.row(f); }
  // Area-weighted; where the faces cancel out (a fold), the normal of the largest one.
  Vector3d vertex_normal(const PolygonMesh& mesh, int v) const;
  // The whole mesh as a complex keeps it; an isolated vertex gets the normal z.
  InputSurface input_surface(const PolygonMesh& mesh) const;

 private:
  Points face_normals_;  // #F x 3
};

}  // namespace planewright
