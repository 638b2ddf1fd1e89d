// PanelTriangleRows: rows about triangles in the plane of a panel,
//
//   scale * n_i . ((x_k - s) x (x_l - s)),     s = mean of some of the panel's points, or a fixed place:
//
// twice the area of the triangle s, k, l as seen from the tip of the panel's normal, positive where it runs
// counter-clockwise. Corners, stars and diagonals of panels are all made of it. The normal is unknown like
// the points (trilinear). On a planar panel (x_k - s) x (x_l - s) is parallel to n_i, so the normal's part of
// the gradient only changes its length. A fixed s may lie beside the plane: what it adds is across n_i and
// drops out.
#pragma once

#include <string>
#include <vector>

#include "core/problem/constraint.h"
#include "core/problem/layout.h"

namespace planewright {

// s = mean of `points` (one or more, none twice), or `fixed` where there are none.
struct TriangleCentre {
  std::vector<int> points;
  Vector3d fixed = Vector3d::Zero();
};

class PanelTriangleRows : public Constraint {
 public:
  PanelTriangleRows(std::string name, std::string unit) : name_(std::move(name)), unit_(std::move(unit)) {}

  // k, l: two points; they may be among the centre's. The stencil has 3 variables for each point involved and
  // 3 for the normal.
  void add(const Layout& layout, int plane, int k, int l, const TriangleCentre& centre, double scale,
           Bounds bounds, ElementRef element);

  std::string_view name() const override { return name_; }
  std::string_view unit() const override { return unit_; }
  int rows() const override { return stencils_.size(); }
  std::span<const int> stencil(int row) const override { return stencils_[row]; }
  std::span<const StencilPair> curvature(int row) const override;
  Bounds bounds(int row) const override { return rows_[static_cast<size_t>(row)].bounds; }
  ElementRef element(int row) const override { return rows_[static_cast<size_t>(row)].element; }
  double evaluate(int row, const double* local, double* gradient, double* curvature) const override;

 private:
  struct Row {
    double share_k, share_l, share_other;  // of each point in s
    double scale;
    Vector3d fixed;
    Bounds bounds;
    ElementRef element;
  };
  // Points of the row's centre that are neither k nor l.
  int others(int row) const { return stencils_.valence(row) / 3 - 3; }

  std::string name_, unit_;
  Polygons stencils_;  // x_k, x_l, the centre's other points, n
  std::vector<Row> rows_;
  std::vector<std::vector<StencilPair>> patterns_;  // by number of others
};

}  // namespace planewright
