#include "core/problem/energies/edge_direction_energy.h"

#include <array>
#include <vector>

namespace planewright {
namespace {

class EdgeDirectionEnergy final : public Energy {
 public:
  EdgeDirectionEnergy(const TangentComplex& complex, const Layout& layout) {
    for (const PanelEdge& edge : complex.panel_edges) {
      const Vector3d along = complex.preferred.row(edge.a) - complex.preferred.row(edge.b);
      const double length = along.norm();
      if (!(length >= kLeastReferenceLength)) continue;
      directions_.push_back(along / length);
      variables_.push_back({layout.x(edge.a, 0), layout.x(edge.a, 1), layout.x(edge.a, 2),
                            layout.x(edge.b, 0), layout.x(edge.b, 1), layout.x(edge.b, 2)});
    }
  }

  std::string_view name() const override { return "edge-direction"; }
  int terms() const override { return static_cast<int>(directions_.size()); }
  int rows() const override { return 3 * terms(); }
  std::span<const int> stencil(int row) const override { return variables_[static_cast<size_t>(row / 3)]; }

  double evaluate(int row, const double* x, double* gradient, double*) const override {
    const Vector3d& d = directions_[static_cast<size_t>(row / 3)];
    const int axis = row % 3;
    double value = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double across = (k == axis ? 1.0 : 0.0) - d[axis] * d[k];
      value += across * (x[k] - x[3 + k]);
      if (gradient) {
        gradient[k] = across;
        gradient[3 + k] = -across;
      }
    }
    return value;
  }

 private:
  std::vector<Vector3d> directions_;
  std::vector<std::array<int, 6>> variables_;
};

}  // namespace

std::unique_ptr<Energy> make_edge_direction_energy(const EnergyContext& context) {
  return std::make_unique<EdgeDirectionEnergy>(context.complex, context.layout);
}

}  // namespace planewright
