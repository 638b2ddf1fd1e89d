#include "core/problem/energies/closeness_energy.h"

#include <array>
#include <vector>

namespace planewright {
namespace {

class ClosenessEnergy final : public Energy {
 public:
  ClosenessEnergy(const TangentComplex& complex, const Layout& layout, const FootPoints& feet)
      : normals_(feet.normal) {
    for (int j = 0; j < layout.points; ++j) {
      variables_.push_back({layout.x(j, 0), layout.x(j, 1), layout.x(j, 2)});
      double offset = 0.0;
      for (int i : complex.planes_of_point[j]) offset += complex.offsets[i];
      wanted_.push_back(feet.normal.row(j).dot(feet.foot.row(j)) +
                        offset / complex.planes_of_point.valence(j));
    }
  }

  std::string_view name() const override { return "closeness"; }
  int terms() const override { return rows(); }
  int rows() const override { return static_cast<int>(variables_.size()); }
  std::span<const int> stencil(int row) const override { return variables_[static_cast<size_t>(row)]; }

  double evaluate(int row, const double* x, double* gradient, double*) const override {
    double value = -wanted_[static_cast<size_t>(row)];
    for (int axis = 0; axis < 3; ++axis) {
      value += normals_(row, axis) * x[axis];
      if (gradient) gradient[axis] = normals_(row, axis);
    }
    return value;
  }

 private:
  Points normals_;
  std::vector<std::array<int, 3>> variables_;
  std::vector<double> wanted_;  // m_j . y_j + d_j
};

}  // namespace

std::unique_ptr<Energy> make_closeness_energy(const EnergyContext& context) {
  return std::make_unique<ClosenessEnergy>(context.complex, context.layout, *context.feet);
}

}  // namespace planewright
