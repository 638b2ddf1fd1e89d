#include "core/problem/energies/fairing_energy.h"

namespace planewright {
namespace {

class FairingEnergy final : public Energy {
 public:
  FairingEnergy(const TangentComplex& complex, const Layout& layout) {
    const Polygons neighbours = complex.fairing_neighbours();
    std::vector<int> stencil;
    for (int j = 0; j < layout.points; ++j) {
      if (neighbours.valence(j) == 0) continue;
      ++terms_;
      for (int axis = 0; axis < 3; ++axis) {
        stencil.assign(1, layout.x(j, axis));
        for (int k : neighbours[j]) stencil.push_back(layout.x(k, axis));
        stencils_.push_back(stencil);
      }
    }
  }

  std::string_view name() const override { return "fairing"; }
  int terms() const override { return terms_; }
  int rows() const override { return stencils_.size(); }
  std::span<const int> stencil(int row) const override { return stencils_[row]; }

  double evaluate(int row, const double* x, double* gradient, double*) const override {
    const int neighbours = stencils_.valence(row) - 1;
    const double share = 1.0 / neighbours;
    double mean = 0.0;
    for (int k = 1; k <= neighbours; ++k) {
      mean += share * x[k];
      if (gradient) gradient[k] = -share;
    }
    if (gradient) gradient[0] = 1.0;
    return x[0] - mean;
  }

 private:
  Polygons stencils_;
  int terms_ = 0;
};

}  // namespace

std::unique_ptr<Energy> make_fairing_energy(const EnergyContext& context) {
  return std::make_unique<FairingEnergy>(context.complex, context.layout);
}

}  // namespace planewright
