#include "core/problem/unit_normal_constraint.h"

#include <array>

namespace planewright {
namespace {

constexpr std::array<StencilPair, 3> kDiagonal{{{0, 0}, {1, 1}, {2, 2}}};

class UnitNormalConstraint final : public Constraint {
 public:
  explicit UnitNormalConstraint(const Layout& layout) {
    for (int i = 0; i < layout.planes; ++i)
      stencils_.push_back({layout.n(i, 0), layout.n(i, 1), layout.n(i, 2)});
  }

  std::string_view name() const override { return "unit normal"; }
  std::string_view unit() const override { return ""; }
  int rows() const override { return static_cast<int>(stencils_.size()); }
  std::span<const int> stencil(int row) const override { return stencils_[row]; }
  std::span<const StencilPair> curvature(int) const override { return kDiagonal; }
  Bounds bounds(int) const override { return {0.0, 0.0}; }
  ElementRef element(int row) const override { return {ElementKind::Panel, row}; }

  double evaluate(int, const double* n, double* gradient, double* curvature) const override {
    for (int c = 0; c < 3; ++c) {
      if (gradient) gradient[c] = n[c];
      if (curvature) curvature[c] = 1.0;
    }
    return 0.5 * (n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1.0);
  }

 private:
  std::vector<std::array<int, 3>> stencils_;
};

}  // namespace

std::unique_ptr<Constraint> make_unit_normal_constraint(const Layout& layout) {
  return std::make_unique<UnitNormalConstraint>(layout);
}

}  // namespace planewright
