// ReferenceSurface: a surface of polygons that answers which of its points is closest to a given one.
//
// Faces are triangulated; the search structure is a bounding volume hierarchy of Eigen's (KdBVH). Units:
// model units; query points and answers are relative to an origin that the caller names, so that a model far
// from 0 loses no digits. Threads: queries are const and may run in several threads.
#pragma once

#include <memory>
#include <string>

#include "core/base/geometry.h"
#include "core/base/result.h"

namespace planewright {

struct ClosestPoint {
  Vector3d point;    // on the surface
  Vector3d normal;   // unit: direction in which the signed distance grows there
  double distance;   // signed: positive on the side that the faces' normals point to
  int face;          // of the polygons given
};

class ReferenceSurface {
 public:
  // points: #V x 3, model units; faces over them. Refused: no face with area, coordinates that are not finite.
  static Result<std::shared_ptr<const ReferenceSurface>> create(const Points& points, const Polygons& faces,
                                                                std::string name);
  ~ReferenceSurface();

  // query: relative to `origin` (model coordinates), and so is the answer's point.
  ClosestPoint closest(const Vector3d& query, const Vector3d& origin) const;

  const std::string& name() const { return name_; }  // the file's, for messages
  Vector3d low() const;   // bounding box, model coordinates
  Vector3d high() const;

 private:
  struct Impl;
  ReferenceSurface(std::unique_ptr<Impl> impl, std::string name);
  std::unique_ptr<Impl> impl_;
  std::string name_;
};

}  // namespace planewright
