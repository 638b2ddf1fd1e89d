#include "core/problem/demands/linear_rows.h"

#include <array>

namespace planewright {

void LinearRows::add(std::span<const int> variables, std::span<const double> coefficients, Bounds bounds,
                     ElementRef element) {
  stencils_.push_back(variables);
  coefficients_.insert(coefficients_.end(), coefficients.begin(), coefficients.end());
  bounds_.push_back(bounds);
  elements_.push_back(element);
}

void LinearRows::add_point(int first_variable, const Vector3d& normal, Bounds bounds, ElementRef element) {
  add(std::array{first_variable, first_variable + 1, first_variable + 2},
      std::array{normal.x(), normal.y(), normal.z()}, bounds, element);
}

double LinearRows::evaluate(int row, const double* local, double* gradient, double*) const {
  const int first = stencils_.offsets()[static_cast<size_t>(row)];
  double value = 0.0;
  for (int k = 0; k < stencils_.valence(row); ++k) {
    const double coefficient = coefficients_[static_cast<size_t>(first + k)];
    value += coefficient * local[k];
    if (gradient) gradient[k] = coefficient;
  }
  return value;
}

}  // namespace planewright
