#include "core/problem/energies/normal_smoothness_energy.h"

#include <algorithm>
#include <array>
#include <vector>

namespace planewright {
namespace {

// Panels that share an edge, ascending, each pair once however many edges they share.
std::vector<std::array<int, 2>> neighbouring_panels(const TangentComplex& complex) {
  std::vector<std::array<int, 2>> pairs;
  for (const PanelEdge& edge : complex.panel_edges)
    if (!edge.border() && edge.left != edge.right)
      pairs.push_back({std::min(edge.left, edge.right), std::max(edge.left, edge.right)});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

class NormalSmoothnessEnergy final : public Energy {
 public:
  NormalSmoothnessEnergy(const TangentComplex& complex, const Layout& layout) {
    for (const auto& [i, k] : neighbouring_panels(complex))
      for (int axis = 0; axis < 3; ++axis) variables_.push_back({layout.n(i, axis), layout.n(k, axis)});
  }

  std::string_view name() const override { return "normal-smoothness"; }
  int terms() const override { return rows() / 3; }
  int rows() const override { return static_cast<int>(variables_.size()); }
  std::span<const int> stencil(int row) const override { return variables_[static_cast<size_t>(row)]; }

  double evaluate(int, const double* n, double* gradient, double*) const override {
    if (gradient) {
      gradient[0] = 1.0;
      gradient[1] = -1.0;
    }
    return n[0] - n[1];
  }

 private:
  std::vector<std::array<int, 2>> variables_;
};

}  // namespace

std::unique_ptr<Energy> make_normal_smoothness_energy(const EnergyContext& context) {
  return std::make_unique<NormalSmoothnessEnergy>(context.complex, context.layout);
}

}  // namespace planewright
