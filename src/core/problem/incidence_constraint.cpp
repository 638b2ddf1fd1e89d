#include "core/problem/incidence_constraint.h"

#include <array>

namespace planewright {
namespace {

// Stencil: x_j (0..2), n_i (3..5), h_i (6).
constexpr std::array<StencilPair, 3> kCrossTerms{{{3, 0}, {4, 1}, {5, 2}}};

class IncidenceConstraint final : public Constraint {
 public:
  IncidenceConstraint(const TangentComplex& complex, const Layout& layout) : anchors_(complex.anchors) {
    const int count = complex.incidence_count();
    stencils_.reserve(count);
    planes_.reserve(count);
    for (int j = 0; j < complex.point_count(); ++j)
      for (int i : complex.planes_of_point[j]) {
        stencils_.push_back({layout.x(j, 0), layout.x(j, 1), layout.x(j, 2), layout.n(i, 0), layout.n(i, 1),
                             layout.n(i, 2), layout.h(i)});
        planes_.push_back(i);
        points_.push_back(j);
      }
  }

  std::string_view name() const override { return "incidence"; }
  std::string_view unit() const override { return "edges"; }
  int rows() const override { return static_cast<int>(planes_.size()); }
  std::span<const int> stencil(int row) const override { return stencils_[row]; }
  std::span<const StencilPair> curvature(int) const override { return kCrossTerms; }
  Bounds bounds(int) const override { return {0.0, 0.0}; }
  ElementRef element(int row) const override { return {ElementKind::Point, points_[row]}; }

  double evaluate(int row, const double* z, double* gradient, double* curvature) const override {
    double value = -z[6];
    for (int c = 0; c < 3; ++c) {
      const double arm = z[c] - anchors_(planes_[row], c);
      value += z[3 + c] * arm;
      if (gradient) {
        gradient[c] = z[3 + c];
        gradient[3 + c] = arm;
      }
      if (curvature) curvature[c] = 1.0;
    }
    if (gradient) gradient[6] = -1.0;
    return value;
  }

 private:
  const Points& anchors_;
  std::vector<std::array<int, 7>> stencils_;
  std::vector<int> planes_, points_;
};

}  // namespace

std::unique_ptr<Constraint> make_incidence_constraint(const TangentComplex& complex, const Layout& layout) {
  return std::make_unique<IncidenceConstraint>(complex, layout);
}

}  // namespace planewright
