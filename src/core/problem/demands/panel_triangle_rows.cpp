#include "core/problem/demands/panel_triangle_rows.h"

#include <Eigen/Geometry>

namespace planewright {
namespace {

// Places of a 3 x 3 matrix [u]x (u x v = [u]x v) that are not always 0, in the order of fill_cross.
constexpr int kCrossRows[6] = {0, 0, 1, 1, 2, 2};
constexpr int kCrossColumns[6] = {1, 2, 0, 2, 0, 1};

// factor * [u]x
void fill_cross(const Vector3d& u, double factor, double*& out) {
  *out++ = -factor * u[2];
  *out++ = factor * u[1];
  *out++ = factor * u[2];
  *out++ = -factor * u[0];
  *out++ = -factor * u[1];
  *out++ = factor * u[0];
}

// Blocks of a stencil x_0 = x_k, x_1 = x_l, x_2 ... others, n, in the order in which evaluate() fills them.
std::vector<StencilPair> pattern(int others) {
  std::vector<StencilPair> pairs;
  const auto add = [&pairs](int first_block, int second_block) {
    for (int e = 0; e < 6; ++e)
      pairs.push_back({3 * first_block + kCrossRows[e], 3 * second_block + kCrossColumns[e]});
  };
  add(1, 0);
  for (int o = 0; o < others; ++o) {
    add(2 + o, 0);
    add(2 + o, 1);
  }
  for (int block = 0; block < 2 + others; ++block) add(2 + others, block);
  return pairs;
}

}  // namespace

void PanelTriangleRows::add(const Layout& layout, int plane, int k, int l, const TriangleCentre& centre,
                            double scale, Bounds bounds, ElementRef element) {
  std::vector<int> stencil;
  const auto add_point = [&](int point) {
    for (int axis = 0; axis < 3; ++axis) stencil.push_back(layout.x(point, axis));
  };
  const double share = centre.points.empty() ? 0.0 : 1.0 / static_cast<double>(centre.points.size());
  Row row{0.0, 0.0, share, scale, centre.points.empty() ? centre.fixed : Vector3d::Zero(), bounds, element};
  add_point(k);
  add_point(l);
  for (int point : centre.points) {
    if (point == k)
      row.share_k = share;
    else if (point == l)
      row.share_l = share;
    else
      add_point(point);
  }
  for (int axis = 0; axis < 3; ++axis) stencil.push_back(layout.n(plane, axis));
  stencils_.push_back(stencil);
  rows_.push_back(row);
  for (int count = static_cast<int>(patterns_.size()); count <= others(rows() - 1); ++count)
    patterns_.push_back(pattern(count));
}

std::span<const StencilPair> PanelTriangleRows::curvature(int row) const {
  return patterns_[static_cast<size_t>(others(row))];
}

double PanelTriangleRows::evaluate(int row, const double* local, double* gradient, double* curvature) const {
  using Block = Eigen::Map<const Vector3d>;
  const Row& r = rows_[static_cast<size_t>(row)];
  const int other_points = others(row);
  const Block x_k(local), x_l(local + 3), n(local + 3 * (2 + other_points));
  Vector3d s = r.fixed + r.share_k * x_k + r.share_l * x_l;
  for (int o = 0; o < other_points; ++o) s += r.share_other * Block(local + 3 * (2 + o));
  const Vector3d a = x_k - s, b = x_l - s, area = a.cross(b);

  // The gradient in each point is u x n, because a and b take their shares of every point of the centre away.
  const Vector3d u_k = r.scale * ((1.0 - r.share_k) * b + r.share_k * a);
  const Vector3d u_l = -r.scale * ((1.0 - r.share_l) * a + r.share_l * b);
  const Vector3d u_other = r.scale * r.share_other * (a - b);
  if (gradient) {
    const auto fill = [&gradient](const Vector3d& value) {
      Eigen::Map<Vector3d>{gradient} = value;
      gradient += 3;
    };
    fill(u_k.cross(n));
    fill(u_l.cross(n));
    for (int o = 0; o < other_points; ++o) fill(u_other.cross(n));
    fill(r.scale * area);
  }
  if (curvature) {
    // Expanded:  n . (x_k x x_l) (1 - share_k - share_l) + share_other n . (x_o x (x_k - x_l)) + lower terms,
    // and d2 n . (p x q) / dp dq = -[n]x.
    fill_cross(n, r.scale * (1.0 - r.share_k - r.share_l), curvature);
    for (int o = 0; o < other_points; ++o) {
      fill_cross(n, -r.scale * r.share_other, curvature);
      fill_cross(n, r.scale * r.share_other, curvature);
    }
    // d(u x n) / dn = [u]x, rows and columns turned over.
    fill_cross(u_k, -1.0, curvature);
    fill_cross(u_l, -1.0, curvature);
    for (int o = 0; o < other_points; ++o) fill_cross(u_other, -1.0, curvature);
  }
  return r.scale * n.dot(area);
}

}  // namespace planewright
