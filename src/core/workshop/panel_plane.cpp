#include "core/workshop/panel_plane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <map>
#include <utility>

namespace planewright {
namespace {

constexpr double kNoArea = 1e-12;  // Newell vector, of the sum of squared arms

// The direction in which corners scatter least. The matrix is scaled to 1: the solver would underflow on
// small panels.
Vector3d flattest_direction(const Points& points, std::span<const int> panel) {
  const Vector3d centre = centroid(points, panel);
  Matrix3d scatter = Matrix3d::Zero();
  for (const int v : panel) {
    const Vector3d arm = points.row(v).transpose() - centre;
    scatter += arm * arm.transpose();
  }
  const double size = scatter.trace();
  if (size <= 0.0) return Vector3d::Zero();
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(scatter / size).eigenvectors().col(0);
}

double spread(const Points& points, std::span<const int> panel) {
  const Vector3d centre = centroid(points, panel);
  double sum = 0.0;
  for (const int v : panel) sum += (points.row(v).transpose() - centre).squaredNorm();
  return sum;
}

// Zero: the panel has no area.
Vector3d own_normal(const Points& points, std::span<const int> panel) {
  const Vector3d newell = newell_vector(points, panel);
  if (!(newell.norm() > kNoArea * spread(points, panel))) return Vector3d::Zero();
  if (panel.size() == 3) return newell.normalized();
  const Vector3d flattest = flattest_direction(points, panel);
  return flattest.dot(newell) < 0.0 ? Vector3d(-flattest) : flattest;
}

// Sums of normals of the panels beyond the sides of those without area.
std::vector<Vector3d> neighbours_sum(const Polygons& panels, const std::vector<Vector3d>& own) {
  std::map<std::pair<int, int>, std::vector<int>> at_edge;
  const auto each_side = [&](int p, auto&& visit) {
    const auto corners = panels[p];
    for (size_t k = 0; k < corners.size(); ++k)
      visit(std::minmax(corners[k], corners[(k + 1) % corners.size()]));
  };
  for (int p = 0; p < panels.size(); ++p)
    if (own[static_cast<size_t>(p)].isZero())
      each_side(p, [&](const auto& edge) { at_edge[{edge.first, edge.second}].push_back(p); });
  std::vector<Vector3d> sums(own.size(), Vector3d::Zero());
  if (at_edge.empty()) return sums;
  for (int p = 0; p < panels.size(); ++p)
    each_side(p, [&](const auto& edge) {
      const auto found = at_edge.find({edge.first, edge.second});
      if (found == at_edge.end()) return;
      for (const int q : found->second) sums[static_cast<size_t>(q)] += own[static_cast<size_t>(p)];
    });
  return sums;
}

}  // namespace

PanelPlanes fit_panel_planes(const Points& points, const Polygons& panels, const Vector3d& up) {
  std::vector<Vector3d> own;
  for (int p = 0; p < panels.size(); ++p) own.push_back(own_normal(points, panels[p]));
  const std::vector<Vector3d> around = neighbours_sum(panels, own);
  PanelPlanes planes{Points(panels.size(), 3), Vector(panels.size())};
  for (int p = 0; p < panels.size(); ++p) {
    Vector3d normal = own[static_cast<size_t>(p)];
    if (normal.isZero()) normal = around[static_cast<size_t>(p)].stableNormalized();
    if (normal.isZero()) {
      normal = flattest_direction(points, panels[p]);
      if (normal.isZero()) normal = up;
      if (normal.dot(up) < 0.0) normal = -normal;
    }
    planes.normals.row(p) = normal.transpose();
    planes.offsets[p] = normal.dot(centroid(points, panels[p]));
  }
  return planes;
}

std::vector<Eigen::Vector2d> flat_outline(const Points& points, std::span<const int> panel,
                                          const Vector3d& normal) {
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  const Vector3d origin = points.row(panel[0]);
  std::vector<Eigen::Vector2d> flat;
  flat.reserve(panel.size());
  for (const int p : panel) {
    const Vector3d arm = points.row(p).transpose() - origin;
    flat.emplace_back(u.dot(arm), v.dot(arm));
  }
  return flat;
}

}  // namespace planewright
