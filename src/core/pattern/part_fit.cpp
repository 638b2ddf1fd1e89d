#include "core/pattern/part_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace planewright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

constexpr double kSlack = 1e-6;  // mm

Vector2d corner(const Contour& contour, Eigen::Index k) {
  return contour.row(k % contour.rows()).transpose();
}

}  // namespace

Contour convex_hull(const Contour& contour) {
  std::vector<Vector2d> sorted;
  for (Eigen::Index k = 0; k < contour.rows(); ++k) sorted.push_back(corner(contour, k));
  std::sort(sorted.begin(), sorted.end(), [](const Vector2d& a, const Vector2d& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  std::vector<Vector2d> hull;
  const auto add = [&](const Vector2d& p, size_t keep) {
    while (hull.size() > keep) {
      const Vector2d u = hull.back() - hull[hull.size() - 2], v = p - hull.back();
      if (u.x() * v.y() - u.y() * v.x() > 0.0) break;
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vector2d& p : sorted) add(p, 1);
  const size_t lower = hull.size();
  for (auto p = sorted.rbegin() + 1; p != sorted.rend(); ++p) add(*p, lower);
  hull.pop_back();
  Contour result(static_cast<Eigen::Index>(hull.size()), 2);
  for (size_t k = 0; k < hull.size(); ++k) result.row(static_cast<Eigen::Index>(k)) = hull[k].transpose();
  return result;
}

Contour turned(const Contour& contour, double radians) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(radians).toRotationMatrix();
  return contour * turn.transpose();
}

Vector2d box_of(const Contour& contour) {
  return (contour.colwise().maxCoeff() - contour.colwise().minCoeff()).transpose();
}

double smallest_box_angle(const Contour& hull) {
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < hull.rows(); ++k) {
    const Vector2d side = corner(hull, k + 1) - corner(hull, k);
    double angle = -std::atan2(side.y(), side.x());
    const Vector2d box = box_of(turned(hull, angle));
    if (box.y() > box.x()) angle += pi / 2;
    // Boxes that are the same but for rounding: the first.
    if (box.prod() < least * (1 - 1e-9)) {
      least = box.prod();
      best = angle;
    }
  }
  return best;
}

std::optional<double> fitting_angle(const Contour& hull, double width, double height) {
  const auto fits = [&](double angle) {
    const Vector2d box = box_of(turned(hull, angle));
    return box.x() <= width + kSlack && box.y() <= height + kSlack;
  };
  // The box's width is the longest shadow of a diagonal, and so is its height: where that equals the
  // rectangle's, a diagonal's shadow does.
  std::vector<double> angles{0.0, pi / 2};
  for (Eigen::Index j = 0; j < hull.rows(); ++j) {
    const Vector2d side = corner(hull, j + 1) - corner(hull, j);
    for (const double quarter : {0.0, pi / 2}) angles.push_back(quarter - std::atan2(side.y(), side.x()));
    for (Eigen::Index k = 0; k < j; ++k) {
      const Vector2d diagonal = corner(hull, j) - corner(hull, k);
      const double at = std::atan2(diagonal.y(), diagonal.x()), length = diagonal.norm();
      for (const auto& [room, axis] : {std::pair(width, 0.0), std::pair(height, pi / 2)})
        if (room <= length)
          for (const double sign : {-1.0, 1.0}) angles.push_back(axis - at + sign * std::acos(room / length));
    }
  }
  for (const double angle : angles)
    if (fits(angle)) return angle;
  return std::nullopt;
}

}  // namespace planewright
