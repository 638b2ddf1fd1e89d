#include "core/problem/demands/triple_product_rows.h"

#include <Eigen/Geometry>

namespace planewright {
namespace {

// Stencil: x_k (0..2), x_l (3..5). d . (a x b) = sum over the six even and odd permutations; its second
// derivatives d/da_r d/db_c are the entries of -[d]x.
constexpr std::array<StencilPair, 6> kCrossTerms{{{3, 1}, {3, 2}, {4, 0}, {4, 2}, {5, 0}, {5, 1}}};

}  // namespace

void TripleProductRows::add(int first_k, int first_l, const Vector3d& p, const Vector3d& d, Bounds bounds,
                            ElementRef element) {
  stencils_.push_back({first_k, first_k + 1, first_k + 2, first_l, first_l + 1, first_l + 2});
  feet_.push_back(p);
  directions_.push_back(d);
  bounds_.push_back(bounds);
  elements_.push_back(element);
}

std::span<const StencilPair> TripleProductRows::curvature(int) const {
  return kCrossTerms;
}

double TripleProductRows::evaluate(int row, const double* local, double* gradient, double* curvature) const {
  const Vector3d& p = feet_[static_cast<size_t>(row)];
  const Vector3d& d = directions_[static_cast<size_t>(row)];
  const Vector3d a = Eigen::Map<const Vector3d>(local) - p, b = Eigen::Map<const Vector3d>(local + 3) - p;
  if (gradient) {
    Eigen::Map<Vector3d> to_k(gradient), to_l(gradient + 3);
    to_k = b.cross(d);
    to_l = d.cross(a);
  }
  if (curvature) {
    // d(b x d)_r / db_c
    curvature[0] = -d[2];  // b_0, a_1: (b x d)_1 = b_2 d_0 - b_0 d_2
    curvature[1] = d[1];   // b_0, a_2: (b x d)_2 = b_0 d_1 - b_1 d_0
    curvature[2] = d[2];   // b_1, a_0: (b x d)_0 = b_1 d_2 - b_2 d_1
    curvature[3] = -d[0];  // b_1, a_2
    curvature[4] = -d[1];  // b_2, a_0
    curvature[5] = d[0];   // b_2, a_1
  }
  return d.dot(a.cross(b));
}

}  // namespace planewright
