// ReferenceSurface: a surface of polygons that answers which of its points is closest to a given one, and on
// which side of it that one lies.
//
// Faces are triangulated; the search structure is a bounding volume hierarchy of Eigen's (KdBVH). The side is
// told by angle-weighted pseudonormals of corners and edges (Baerentzen and Aanaes, "Signed distance
// computation using the angle weighted pseudonormal", 2005): the normal of one of several nearest triangles
// can point the wrong way. Vertices with equal coordinates count as one, so that a file without shared
// vertices has sides too.
//
// Units: model units; query points and answers are relative to an origin that the caller names, so that a
// model far from 0 loses no digits. Threads: queries are const and may run in several threads. The same query
// gets the same answer; of several nearest triangles it is on the first.
#pragma once

#include <memory>
#include <string>

#include "core/base/geometry.h"
#include "core/base/result.h"

namespace planewright {

struct ClosestPoint {
  Vector3d point;  // on the surface
  // Unit: the direction in which the signed distance grows at the query. On the border of an open surface:
  // the surface's own normal there, because beyond it there is no side; the surface goes on as its tangent
  // plane.
  Vector3d normal;
  double distance;  // positive on the side that the faces' normals point to; its size is |query - point|
  int face;         // of the polygons given
  bool border;      // the point lies on the border of an open surface
};

class ReferenceSurface {
 public:
  // Coordinates beyond this are refused: squares of them would overflow.
  static constexpr double kLargestCoordinate = 1e100;

  // points: #V x 3, model units; faces: indices into them. Refused: no face with area, coordinates of corners
  // that are not finite or beyond kLargestCoordinate.
  static Result<std::shared_ptr<const ReferenceSurface>> create(const Points& points, const Polygons& faces,
                                                                std::string name);
  ~ReferenceSurface();

  // query: finite, within kLargestCoordinate, relative to `origin` (model coordinates), and so is the
  // answer's point.
  ClosestPoint closest(const Vector3d& query, const Vector3d& origin) const;

  const std::string& name() const { return name_; }  // the file's, for messages
  Vector3d low() const;                              // bounding box, model coordinates
  Vector3d high() const;

 private:
  struct Impl;
  ReferenceSurface(std::unique_ptr<Impl> impl, std::string name);
  std::unique_ptr<Impl> impl_;
  std::string name_;
};

// Whether a reference can be meant for a mesh with the bounding box [low, high] (model coordinates). Refused:
// the sizes of their boxes differ by more than 100 times, or there are more than 10 sizes of the larger one
// between them; both are named.
Result<void> check_reference(const ReferenceSurface& reference, const Vector3d& low, const Vector3d& high);

}  // namespace planewright
