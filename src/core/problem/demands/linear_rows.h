// LinearRows: a constraint whose rows are linear, low <= sum_k coefficient_k z_k <= high. Most demands are: a
// half space for a point, a band, a pin. Their files only say which rows.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/problem/constraint.h"

namespace planewright {

class LinearRows final : public Constraint {
 public:
  // name: the demand's; unit: as in Constraint::unit().
  LinearRows(std::string name, std::string unit) : name_(std::move(name)), unit_(std::move(unit)) {}

  // variables: of the Layout, none twice; coefficients: as many.
  void add(std::span<const int> variables, std::span<const double> coefficients, Bounds bounds,
           ElementRef element);
  // normal . x between bounds, for the three variables from first_variable on.
  void add_point(int first_variable, const Vector3d& normal, Bounds bounds, ElementRef element);

  std::string_view name() const override { return name_; }
  std::string_view unit() const override { return unit_; }
  int rows() const override { return stencils_.size(); }
  std::span<const int> stencil(int row) const override { return stencils_[row]; }
  Bounds bounds(int row) const override { return bounds_[static_cast<size_t>(row)]; }
  ElementRef element(int row) const override { return elements_[static_cast<size_t>(row)]; }
  double evaluate(int row, const double* local, double* gradient, double* curvature) const override;

 private:
  std::string name_, unit_;
  Polygons stencils_;
  std::vector<double> coefficients_;  // in the order of the stencils' indices
  std::vector<Bounds> bounds_;
  std::vector<ElementRef> elements_;
};

}  // namespace planewright
