#include "core/problem/energies/corner_angle_energy.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace planewright {
namespace {

// The lower triangle row by row, so that the first 21 are those of six variables.
constexpr auto kLowerTriangle = [] {
  std::array<StencilPair, 45> pairs{};
  size_t next = 0;
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column <= row; ++column) pairs[next++] = {row, column};
  return pairs;
}();

template <int N>
void store_lower(const Eigen::Matrix<double, N, N>& full, double* out) {
  for (int row = 0; row < N; ++row)
    for (int column = 0; column <= row; ++column) *out++ = full(row, column);
}

// (hinge_+)^2, with its first and second derivative by the hinge. Not finite where the hinge is not.
struct SquaredHinge {
  double value, slope, bend;
};
SquaredHinge squared(double hinge) {
  if (hinge <= 0.0) return {0.0, 0.0, 0.0};
  return {hinge * hinge, 2.0 * hinge, 2.0};
}

class CornerAngleEnergy final : public Energy {
 public:
  CornerAngleEnergy(const TangentComplex& complex, const Layout& layout) {
    for (int i = 0; i < complex.panels.size(); ++i) {
      const auto points = complex.panels[i];
      const size_t count = points.size();
      if (count < 3) continue;
      for (size_t k = 0; k < count; ++k) {
        std::array<int, 9>& variables = corners_.emplace_back();
        size_t next = 0;
        for (const int j : {points[(k + count - 1) % count], points[k], points[(k + 1) % count]})
          for (int axis = 0; axis < 3; ++axis) variables[next++] = layout.x(j, axis);
      }
    }
    for (const PanelEdge& edge : complex.panel_edges)
      edges_.push_back({layout.x(edge.a, 0), layout.x(edge.a, 1), layout.x(edge.a, 2), layout.x(edge.b, 0),
                        layout.x(edge.b, 1), layout.x(edge.b, 2)});
  }

  std::string_view name() const override { return "corner-angle"; }
  int terms() const override { return static_cast<int>(corners_.size()); }
  int rows() const override { return terms() + static_cast<int>(edges_.size()); }
  // x_a, x_p, x_b of a corner; x_a, x_b of an edge.
  std::span<const int> stencil(int row) const override {
    if (row < terms()) return corners_[static_cast<size_t>(row)];
    return edges_[static_cast<size_t>(row - terms())];
  }
  std::span<const StencilPair> curvature(int row) const override {
    return std::span(kLowerTriangle).first(row < terms() ? 45 : 21);
  }
  double evaluate(int row, const double* x, double* gradient, double* curvature) const override {
    return row < terms() ? sharpness(x, gradient, curvature) : shortness(x, gradient, curvature);
  }

 private:
  static double sharpness(const double* x, double* gradient, double* curvature) {
    using Matrix3 = Eigen::Matrix3d;
    static const double blunt = std::cos(kBluntDegrees * std::numbers::pi / 180.0);
    const Eigen::Map<const Vector3d> a(x), p(x + 3), b(x + 6);
    const Vector3d u = a - p, v = b - p;
    const double length_u = std::sqrt(u.squaredNorm() + kAngleLength * kAngleLength),
                 length_v = std::sqrt(v.squaredNorm() + kAngleLength * kAngleLength);
    const Vector3d along_u = u / length_u, along_v = v / length_v;
    const double cosine = along_u.dot(along_v);
    const SquaredHinge hinge = squared((cosine - blunt) / (1.0 - blunt));
    const double slope = hinge.slope / (1.0 - blunt), bend = hinge.bend / ((1.0 - blunt) * (1.0 - blunt));
    // Of the cosine, by u and v.
    const Vector3d by_u = (along_v - cosine * along_u) / length_u,
                   by_v = (along_u - cosine * along_v) / length_v;
    if (gradient) {
      Eigen::Map<Vector3d> to_a(gradient), to_p(gradient + 3), to_b(gradient + 6);
      to_a = slope * by_u;
      to_p = -slope * (by_u + by_v);
      to_b = slope * by_v;
    }
    if (curvature) {
      const auto same = [cosine](const Vector3d& own, const Vector3d& other, double length) -> Matrix3 {
        return (3.0 * cosine * own * own.transpose() - own * other.transpose() - other * own.transpose() -
                cosine * Matrix3::Identity()) /
               (length * length);
      };
      const Matrix3 mixed = (Matrix3::Identity() - along_v * along_v.transpose() -
                             along_u * (along_u - cosine * along_v).transpose()) /
                            (length_u * length_v);
      const Matrix3 uu = slope * same(along_u, along_v, length_u) + bend * by_u * by_u.transpose(),
                    vv = slope * same(along_v, along_u, length_v) + bend * by_v * by_v.transpose(),
                    uv = slope * mixed + bend * by_u * by_v.transpose();
      Eigen::Matrix<double, 9, 9> full;
      full << uu, -uu - uv, uv,                                           //
          -uu - uv.transpose(), uu + uv + uv.transpose() + vv, -uv - vv,  //
          uv.transpose(), -uv.transpose() - vv, vv;
      store_lower<9>(full, curvature);
    }
    return hinge.value;
  }

  static double shortness(const double* x, double* gradient, double* curvature) {
    constexpr double squared_length = kShortLength * kShortLength;
    const Eigen::Map<const Vector3d> a(x), b(x + 3);
    const Vector3d edge = a - b, by_edge = -2.0 / squared_length * edge;  // slope of the hinge
    const SquaredHinge hinge = squared(1.0 - edge.squaredNorm() / squared_length);
    if (gradient) {
      Eigen::Map<Vector3d> to_a(gradient), to_b(gradient + 3);
      to_a = hinge.slope * by_edge;
      to_b = -to_a;
    }
    if (curvature) {
      const Eigen::Matrix3d same = hinge.bend * by_edge * by_edge.transpose() -
                                   2.0 / squared_length * hinge.slope * Eigen::Matrix3d::Identity();
      Eigen::Matrix<double, 6, 6> full;
      full << same, -same, -same, same;
      store_lower<6>(full, curvature);
    }
    return hinge.value;
  }

  std::vector<std::array<int, 9>> corners_;
  std::vector<std::array<int, 6>> edges_;
};

}  // namespace

std::unique_ptr<Energy> make_corner_angle_energy(const EnergyContext& context) {
  return std::make_unique<CornerAngleEnergy>(context.complex, context.layout);
}

}  // namespace planewright
