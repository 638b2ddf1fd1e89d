#include "core/workshop/panel_rows.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "core/workshop/panel_rectangle.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

constexpr double kLevel = 0.5;                 // sine of the mean slope below which a model counts as flat
constexpr double kRowGap = 0.55;               // of a panel's height: a gap between middles that parts rows
constexpr double kRowHeight = 0.9;             // of a panel's height: middles of a row are no farther apart
constexpr double kLeastBand = 0.1;             // of the mean height of panels: bands are no lower
constexpr double kWidestGap = 150.0;           // degrees: a row that leaves no wider one open goes round
constexpr double kNearlyUpright = 1.02;        // area, of the smallest rectangle
constexpr double kGrid = 1.618033988749895e6;  // steps of the model's size; no round number, nor near one
constexpr double kRound = 1e-5;  // what is nearer than this (radians, model sizes) counts as equal

// What the rules look at, of each panel. x: along rows, y: across them, z: up.
struct Plan {
  Points middles;         // #P x 3
  Points extents;         // #P x 3
  double slope = 0.0;     // sine, mean weighted by area
  double size = 0.0;      // diagonal of the model
  Vector2d centre{0, 0};  // of the middles' box
  Vector2d east{1, 0};    // the model's first axis: where numbers round the middle begin
};

// Whole multiples of a small part of the model's size. Regular designs lie on the edge of many a rule below
// (heights that are equal, gaps that are as large as a panel): rounded first, they are decided alike in every
// unit of length.
Points on_grid(const Points& points, const Polygons& panels) {
  Eigen::RowVector3d low = points.row(panels.indices()[0]), high = low;
  for (const int v : panels.indices()) {
    low = low.cwiseMin(points.row(v));
    high = high.cwiseMax(points.row(v));
  }
  const double size = (high - low).norm();
  if (!(size > 0.0)) return Points::Zero(points.rows(), 3);
  return ((points.rowwise() - 0.5 * (low + high)) * (kGrid / size)).array().round().matrix();
}

// Horizontal: the model's first axis as it is seen from above, or its second if that is upright. Unit.
Vector3d first_axis(const Vector3d& up) {
  Vector3d u = Vector3d::UnitX() - up * up.x();
  if (u.norm() < 0.1) u = Vector3d::UnitY() - up * up.y();
  return u.normalized();
}

// Axes: rows of z = up; x is the model's longer horizontal direction, from left to right seen from outside
// where the model has an outside to speak of, else towards the first axis.
Matrix3d plan_axes(const Points& points, const Polygons& panels, const Vector3d& up, const Vector3d& facing) {
  const Vector3d u = first_axis(up), v = up.cross(u);
  std::vector<Vector2d> flat;
  for (const int p : panels.indices()) flat.emplace_back(points.row(p).dot(u), points.row(p).dot(v));
  Vector2d low = flat[0], high = flat[0];
  for (const Vector2d& p : flat) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector2d box = high - low;
  const SmallestRectangle smallest = smallest_rectangle(flat);
  Vector2d along = box.y() > box.x() * (1.0 + kRound) ? Vector2d::UnitY() : Vector2d::UnitX();
  if (box.x() * box.y() > kNearlyUpright * smallest.width * smallest.height) along = smallest.along;
  Vector3d x = along.x() * u + along.y() * v;
  const double right = up.cross(facing).dot(x);
  const bool lies_back = std::abs(along.x()) > 1e-3 ? along.x() < 0.0 : along.y() < 0.0;
  if (std::abs(right) > 0.3 ? right < 0.0 : lies_back) x = -x;
  Matrix3d axes;
  axes << x, up.cross(x), up;
  return axes;
}

Plan make_plan(const Points& points, const Polygons& panels, const Vector3d& up) {
  Vector3d sum = Vector3d::Zero();
  double area = 0.0, horizontal = 0.0;
  for (int p = 0; p < panels.size(); ++p) {
    const Vector3d newell = newell_vector(points, panels[p]);
    sum += newell;
    area += newell.norm();
    horizontal += (newell - up * up.dot(newell)).norm();
  }
  Vector3d facing = area > 0.0 ? Vector3d(sum / area) : Vector3d(Vector3d::Zero());
  facing -= up * up.dot(facing);

  Plan plan;
  plan.slope = area > 0.0 ? horizontal / area : 0.0;
  const Matrix3d axes = plan_axes(points, panels, up, facing);
  const Points turned = points * axes;
  plan.east = (axes.transpose() * first_axis(up)).head<2>();
  plan.middles.resize(panels.size(), 3);
  plan.extents.resize(panels.size(), 3);
  for (int p = 0; p < panels.size(); ++p) {
    const auto corners = panels[p];
    plan.middles.row(p) = centroid(turned, corners).transpose();
    Vector3d low = turned.row(corners[0]), high = low;
    for (const int v : corners) {
      low = low.cwiseMin(turned.row(v).transpose());
      high = high.cwiseMax(turned.row(v).transpose());
    }
    plan.extents.row(p) = (high - low).transpose();
  }
  const Eigen::RowVector3d low = plan.middles.colwise().minCoeff(), high = plan.middles.colwise().maxCoeff();
  plan.size = (high - low).norm() + plan.extents.rowwise().norm().maxCoeff();
  if (!(plan.size > 0.0)) plan.size = 1.0;
  plan.centre = 0.5 * (low + high).head<2>().transpose();
  return plan;
}

// Cuts into bands along one axis, from below.
std::vector<std::vector<int>> cut_bands(const Plan& plan, int axis) {
  const int count = static_cast<int>(plan.middles.rows());
  std::vector<int> order(static_cast<size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int p, int q) { return plan.middles(p, axis) < plan.middles(q, axis); });
  const auto at = [&](size_t i) { return plan.middles(order[i], axis); };
  const double mean = plan.extents.col(axis).mean();
  std::vector<std::vector<int>> rows;
  for (size_t first = 0, last; first < order.size(); first = last) {
    // Panels of a shell get flatter towards its top: a band is as high as those that it begins among.
    double sum = 0.0;
    int among = 0;
    for (size_t i = first; i < order.size() && at(i) <= at(first) + mean; ++i, ++among)
      sum += plan.extents(order[i], axis);
    const double band = std::max(sum / among, kLeastBand * mean);
    for (last = first + 1; last < order.size(); ++last)
      if (at(last) - at(last - 1) > kRowGap * band || at(last) - at(first) > kRowHeight * band) break;
    rows.emplace_back(order.begin() + static_cast<std::ptrdiff_t>(first),
                      order.begin() + static_cast<std::ptrdiff_t>(last));
  }
  return rows;
}

// Anticlockwise from `east`, seen from above; what rounding leaves before that is on it.
double angle_of(const Plan& plan, int panel) {
  const Vector2d arm = plan.middles.row(panel).head<2>().transpose() - plan.centre;
  const double angle = std::atan2(plan.east.x() * arm.y() - plan.east.y() * arm.x(), plan.east.dot(arm));
  return angle < -kRound ? angle + 2.0 * std::numbers::pi : angle;
}

double radius_of(const Plan& plan, int panel) {
  return (plan.middles.row(panel).head<2>().transpose() - plan.centre).norm();
}

bool goes_round(const Plan& plan, const std::vector<int>& panels) {
  if (panels.size() < 3) return false;
  std::vector<double> angles;
  for (const int p : panels) angles.push_back(angle_of(plan, p));
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + 2.0 * std::numbers::pi - angles.back();
  for (size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
  return widest < kWidestGap * std::numbers::pi / 180.0;
}

// Sorts by whole multiples of kRound: what is nearer than that is decided by the next key.
void sort_row(const Plan& plan, std::vector<int>& row, bool round) {
  const auto steps = [&](double value) { return std::llround(value / (kRound * plan.size)); };
  const auto key = [&](int p) {
    if (round)
      return std::tuple(std::llround(angle_of(plan, p) / kRound), -steps(radius_of(plan, p)),
                        steps(plan.middles(p, 2)), p);
    return std::tuple(steps(plan.middles(p, 0)), steps(plan.middles(p, 2)), steps(plan.middles(p, 1)), p);
  };
  std::vector<std::pair<decltype(key(0)), int>> keyed;
  for (const int p : row) keyed.emplace_back(key(p), p);
  std::sort(keyed.begin(), keyed.end());
  std::transform(keyed.begin(), keyed.end(), row.begin(), [](const auto& pair) { return pair.second; });
}

// Panels of the same row that hang together by sides: a label for each panel.
std::vector<int> label_pieces(const Polygons& panels, const std::vector<std::vector<int>>& rows) {
  const auto count = static_cast<size_t>(panels.size());
  std::vector<int> row_of(count), parent(count);
  for (size_t r = 0; r < rows.size(); ++r)
    for (const int p : rows[r]) row_of[static_cast<size_t>(p)] = static_cast<int>(r);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int p) {
    while (parent[static_cast<size_t>(p)] != p)
      p = parent[static_cast<size_t>(p)] = parent[static_cast<size_t>(parent[static_cast<size_t>(p)])];
    return p;
  };
  std::vector<std::array<int, 3>> sides;  // lower end, higher end, panel
  for (int p = 0; p < panels.size(); ++p) {
    const auto corners = panels[p];
    for (size_t k = 0; k < corners.size(); ++k) {
      const int a = corners[k], b = corners[(k + 1) % corners.size()];
      sides.push_back({std::min(a, b), std::max(a, b), p});
    }
  }
  std::sort(sides.begin(), sides.end());
  for (size_t i = 1; i < sides.size(); ++i) {
    const auto &s = sides[i - 1], &t = sides[i];
    if (s[0] == t[0] && s[1] == t[1] &&
        row_of[static_cast<size_t>(s[2])] == row_of[static_cast<size_t>(t[2])])
      parent[static_cast<size_t>(root(t[2]))] = root(s[2]);
  }
  std::vector<int> labels(count);
  for (int p = 0; p < panels.size(); ++p) labels[static_cast<size_t>(p)] = root(p);
  return labels;
}

// Of a row with several rings inside one another (a torus) the outer ring comes first, whole; panels of no
// ring go with the ring that is nearest in radius.
std::vector<int> order_row(const Plan& plan, std::vector<int> row, const std::vector<int>& piece_of) {
  if (!goes_round(plan, row)) {
    sort_row(plan, row, false);
    return row;
  }
  struct Ring {
    double radius;
    std::vector<int> panels;
  };
  std::vector<std::pair<int, std::vector<int>>> pieces;
  std::stable_sort(row.begin(), row.end(), [&](int p, int q) {
    return piece_of[static_cast<size_t>(p)] < piece_of[static_cast<size_t>(q)];
  });
  for (const int p : row) {
    const int piece = piece_of[static_cast<size_t>(p)];
    if (pieces.empty() || pieces.back().first != piece) pieces.emplace_back(piece, std::vector<int>());
    pieces.back().second.push_back(p);
  }
  const auto mean_radius = [&](const std::vector<int>& panels) {
    double sum = 0.0;
    for (const int p : panels) sum += radius_of(plan, p);
    return sum / static_cast<double>(panels.size());
  };
  std::vector<Ring> rings;
  for (const auto& [piece, panels] : pieces)
    if (goes_round(plan, panels)) rings.push_back({mean_radius(panels), panels});
  if (rings.size() < 2) {
    sort_row(plan, row, true);
    return row;
  }
  std::stable_sort(rings.begin(), rings.end(),
                   [&](const Ring& r, const Ring& s) { return r.radius > s.radius + kRound * plan.size; });
  for (const auto& [piece, panels] : pieces) {
    if (goes_round(plan, panels)) continue;
    const double radius = mean_radius(panels);
    auto nearest = std::min_element(rings.begin(), rings.end(), [&](const Ring& r, const Ring& s) {
      return std::abs(r.radius - radius) < std::abs(s.radius - radius);
    });
    nearest->panels.insert(nearest->panels.end(), panels.begin(), panels.end());
  }
  std::vector<int> ordered;
  for (Ring& ring : rings) {
    sort_row(plan, ring.panels, true);
    ordered.insert(ordered.end(), ring.panels.begin(), ring.panels.end());
  }
  return ordered;
}

}  // namespace

std::vector<std::vector<int>> panel_rows(const Points& points, const Polygons& panels, const Vector3d& up) {
  if (panels.empty()) return {};
  const Plan plan = make_plan(on_grid(points, panels), panels, up);
  const bool flat = plan.slope < kLevel;
  std::vector<std::vector<int>> rows = cut_bands(plan, flat ? 1 : 2);
  if (flat) {
    for (auto& row : rows) sort_row(plan, row, false);
    return rows;
  }
  const std::vector<int> piece_of = label_pieces(panels, rows);
  for (auto& row : rows) row = order_row(plan, std::move(row), piece_of);
  return rows;
}

}  // namespace planewright
