#include "core/problem/foot_points.h"

#include <memory>

namespace planewright {

Result<FootPoints> foot_points(const TangentComplex& complex, const Points& x, const ReferenceSurface* reference) {
  std::shared_ptr<const ReferenceSurface> own;
  if (!reference) {
    const Points vertices = complex.input.vertices.rowwise() + complex.origin.transpose();
    auto made = ReferenceSurface::create(vertices, complex.input.faces, "the mesh itself");
    if (!made) return tl::unexpected(made.error());
    own = std::move(*made);
    reference = own.get();
  }
  FootPoints feet{Points(x.rows(), 3), Points(x.rows(), 3)};
  for (Eigen::Index j = 0; j < x.rows(); ++j) {
    const ClosestPoint foot = reference->closest(x.row(j), complex.origin);
    feet.foot.row(j) = foot.point;
    feet.normal.row(j) = foot.normal;
  }
  return feet;
}

}  // namespace planewright
