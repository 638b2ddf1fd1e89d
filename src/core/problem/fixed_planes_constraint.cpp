#include "core/problem/fixed_planes_constraint.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>

#include "core/complex/point_equations.h"

namespace planewright {
namespace {

constexpr double kDetermined = 1e-6;   // singular values of unit rows below this determine nothing
constexpr double kOnItsPlanes = 1e-9;  // edges

class FixedPlanesConstraint final : public Constraint {
 public:
  void add(const Layout& layout, int point, const Vector3d& direction, double value) {
    stencils_.push_back({layout.x(point, 0), layout.x(point, 1), layout.x(point, 2)});
    directions_.push_back(direction);
    values_.push_back(value);
    points_.push_back(point);
  }

  std::string_view name() const override { return "incidence"; }
  std::string_view unit() const override { return "edges"; }
  int rows() const override { return static_cast<int>(stencils_.size()); }
  std::span<const int> stencil(int row) const override { return stencils_[row]; }
  Bounds bounds(int) const override { return {0.0, 0.0}; }
  ElementRef element(int row) const override { return {ElementKind::Point, points_[row]}; }

  double evaluate(int row, const double* x, double* gradient, double*) const override {
    const Vector3d& b = directions_[row];
    if (gradient) std::copy(b.data(), b.data() + 3, gradient);
    return b.dot(Eigen::Map<const Vector3d>(x)) - values_[row];
  }

 private:
  std::vector<std::array<int, 3>> stencils_;
  std::vector<Vector3d> directions_;
  std::vector<double> values_;
  std::vector<int> points_;
};

}  // namespace

Result<std::unique_ptr<Constraint>> make_fixed_planes_constraint(const TangentComplex& complex,
                                                                 const Layout& layout) {
  auto constraint = std::make_unique<FixedPlanesConstraint>();
  int impossible = 0, first = -1;
  for (int j = 0; j < complex.point_count(); ++j) {
    const auto [normals, right] = PointEquations(complex, j);
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(normals, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(kDetermined / std::max(svd.singularValues()[0], kDetermined));
    const Vector3d move = svd.solve(right);
    if ((normals * move - right).cwiseAbs().maxCoeff() > kOnItsPlanes) {
      if (impossible++ == 0) first = j;
      continue;
    }
    const Vector3d nearest = complex.preferred.row(j).transpose() + move;
    for (Eigen::Index r = 0; r < svd.rank(); ++r) {
      const Vector3d direction = svd.matrixV().col(r);
      constraint->add(layout, j, direction, direction.dot(nearest));
    }
  }
  if (impossible > 0)
    return fail(ErrorCode::Refused,
                "with fixed planes " + std::to_string(impossible) +
                    (impossible == 1 ? " point has" : " points have") +
                    " no place that lies on all of their planes",
                "point " + std::to_string(first), "Free the normals, or the normals and offsets");
  return std::unique_ptr<Constraint>(std::move(constraint));
}

}  // namespace planewright
