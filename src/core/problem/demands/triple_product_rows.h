// TripleProductRows: rows  d . ((x_k - p) x (x_l - p))  with fixed p and d, for two points k and l. Bilinear.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/problem/constraint.h"

namespace planewright {

class TripleProductRows final : public Constraint {
 public:
  TripleProductRows(std::string name, std::string unit) : name_(std::move(name)), unit_(std::move(unit)) {}

  // first_k, first_l: first of the three variables of each point.
  void add(int first_k, int first_l, const Vector3d& p, const Vector3d& d, Bounds bounds, ElementRef element);

  std::string_view name() const override { return name_; }
  std::string_view unit() const override { return unit_; }
  int rows() const override { return static_cast<int>(stencils_.size()); }
  std::span<const int> stencil(int row) const override { return stencils_[static_cast<size_t>(row)]; }
  std::span<const StencilPair> curvature(int row) const override;
  Bounds bounds(int row) const override { return bounds_[static_cast<size_t>(row)]; }
  ElementRef element(int row) const override { return elements_[static_cast<size_t>(row)]; }
  double evaluate(int row, const double* local, double* gradient, double* curvature) const override;

 private:
  std::string name_, unit_;
  std::vector<std::array<int, 6>> stencils_;
  std::vector<Vector3d> feet_, directions_;
  std::vector<Bounds> bounds_;
  std::vector<ElementRef> elements_;
};

}  // namespace planewright
