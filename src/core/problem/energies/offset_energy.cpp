#include "core/problem/energies/offset_energy.h"

#include <vector>

namespace planewright {
namespace {

class OffsetEnergy final : public Energy {
 public:
  OffsetEnergy(const TangentComplex& complex, const Layout& layout) : wanted_(complex.offsets) {
    for (int i = 0; i < layout.planes; ++i) variables_.push_back(layout.h(i));
  }

  std::string_view name() const override { return "offset"; }
  int terms() const override { return rows(); }
  int rows() const override { return static_cast<int>(variables_.size()); }
  std::span<const int> stencil(int row) const override { return {&variables_[static_cast<size_t>(row)], 1}; }

  double evaluate(int row, const double* h, double* gradient, double*) const override {
    if (gradient) gradient[0] = 1.0;
    return h[0] - wanted_[row];
  }

 private:
  const Vector& wanted_;
  std::vector<int> variables_;
};

}  // namespace

std::unique_ptr<Energy> make_offset_energy(const EnergyContext& context) {
  return std::make_unique<OffsetEnergy>(context.complex, context.layout);
}

}  // namespace planewright
