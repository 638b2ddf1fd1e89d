// Length rows: for pairs of points (a, b) that should keep their wanted distance L,
//   r = (|x_a - x_b|^2 - L^2) / (2 L),
// which is |x_a - x_b| - L to first order, but a polynomial: smooth where the points meet. L is the distance
// at the wanted positions, at least kLeastReferenceLength, so that a pair that should coincide divides by no
// zero. What edge length and diagonal length share. One term and one row per pair; unit of a residual: edges.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

class LengthRows final : public Energy {
 public:
  // pairs: indices of points, a != b.
  LengthRows(std::string name, const EnergyContext& context, const std::vector<std::array<int, 2>>& pairs);

  std::string_view name() const override { return name_; }
  int terms() const override { return rows(); }
  int rows() const override { return static_cast<int>(lengths_.size()); }
  // x_a, x_b: six variables.
  std::span<const int> stencil(int row) const override { return variables_[static_cast<size_t>(row)]; }
  std::span<const StencilPair> curvature(int row) const override;
  double evaluate(int row, const double* x, double* gradient, double* curvature) const override;

 private:
  std::string name_;
  std::vector<std::array<int, 6>> variables_;
  std::vector<double> lengths_;
};

}  // namespace planewright
