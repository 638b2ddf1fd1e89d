#include "core/problem/energies/proxy_normal_energy.h"

#include <vector>

namespace planewright {
namespace {

class ProxyNormalEnergy final : public Energy {
 public:
  ProxyNormalEnergy(const TangentComplex& complex, const Layout& layout) : proxies_(complex.normals) {
    for (int i = 0; i < layout.planes; ++i)
      for (int axis = 0; axis < 3; ++axis) variables_.push_back(layout.n(i, axis));
  }

  std::string_view name() const override { return "proxy-normal"; }
  int terms() const override { return rows() / 3; }
  int rows() const override { return static_cast<int>(variables_.size()); }
  std::span<const int> stencil(int row) const override { return {&variables_[static_cast<size_t>(row)], 1}; }

  double evaluate(int row, const double* n, double* gradient, double*) const override {
    if (gradient) gradient[0] = 1.0;
    return n[0] - proxies_(row / 3, row % 3);
  }

 private:
  const Points& proxies_;
  std::vector<int> variables_;
};

}  // namespace

std::unique_ptr<Energy> make_proxy_normal_energy(const EnergyContext& context) {
  return std::make_unique<ProxyNormalEnergy>(context.complex, context.layout);
}

}  // namespace planewright
