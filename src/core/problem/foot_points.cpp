#include "core/problem/foot_points.h"

#include <memory>
#include <string>

namespace planewright {

Result<FootPoints> foot_points(const TangentComplex& complex, const Points& x,
                               const ReferenceSurface* reference) {
  // The mesh is in the complex's frame already, any other surface in model coordinates.
  Vector3d origin = complex.origin;
  std::shared_ptr<const ReferenceSurface> own;
  if (!reference) {
    auto made = ReferenceSurface::create(complex.input.vertices, complex.input.faces, "the mesh itself");
    if (!made) return tl::unexpected(made.error());
    own = std::move(*made);
    reference = own.get();
    origin.setZero();
  }
  FootPoints feet{Points(x.rows(), 3), Points(x.rows(), 3)};
  for (Eigen::Index j = 0; j < x.rows(); ++j) {
    if (!(x.row(j).cwiseAbs().maxCoeff() <= ReferenceSurface::kLargestCoordinate) || !x.row(j).allFinite())
      return fail(ErrorCode::Refused, "a coordinate is not a finite number, or far too large",
                  "point " + std::to_string(j));
    const ClosestPoint foot = reference->closest(x.row(j), origin);
    feet.foot.row(j) = foot.point;
    feet.normal.row(j) = foot.normal;
  }
  return feet;
}

}  // namespace planewright
