#include "core/problem/energies/position_energy.h"

namespace planewright {
namespace {

class PositionEnergy final : public Energy {
 public:
  PositionEnergy(const TangentComplex& complex, const Layout& layout) : wanted_(complex.preferred) {
    for (int j = 0; j < layout.points; ++j)
      for (int axis = 0; axis < 3; ++axis) variables_.push_back(layout.x(j, axis));
  }

  std::string_view name() const override { return "position"; }
  int terms() const override { return static_cast<int>(wanted_.rows()); }
  int rows() const override { return static_cast<int>(variables_.size()); }
  std::span<const int> stencil(int row) const override { return {&variables_[row], 1}; }

  double evaluate(int row, const double* x, double* gradient, double*) const override {
    if (gradient) gradient[0] = 1.0;
    return x[0] - wanted_(row / 3, row % 3);
  }

 private:
  const Points& wanted_;
  std::vector<int> variables_;
};

}  // namespace

std::unique_ptr<Energy> make_position_energy(const EnergyContext& context) {
  return std::make_unique<PositionEnergy>(context.complex, context.layout);
}

}  // namespace planewright
