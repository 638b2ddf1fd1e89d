#include "core/certify/exact_signs.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

namespace planewright {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Rational = boost::multiprecision::cpp_rational;
using Eigen::Vector2d;

Kernel::Point_2 exact(const Vector2d& p) {
  return {p.x(), p.y()};
}
Kernel::Point_3 exact(const Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

// A sum in doubles whose sign is certain if it exceeds what rounding can have done to `operations` operations
// on terms of this total size.
int certain_sign(double sum, double size, int operations) {
  const double doubt = 2.0 * operations * std::numeric_limits<double>::epsilon() * size;
  // Tiny terms may have been rounded to nothing.
  if (!std::isfinite(sum) || std::abs(sum) <= doubt + 1e-290) return 0;
  return sum > 0.0 ? 1 : -1;
}

bool within_box(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
         std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

bool boxes_apart(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  return std::max(a.x(), b.x()) < std::min(c.x(), d.x()) || std::max(c.x(), d.x()) < std::min(a.x(), b.x()) ||
         std::max(a.y(), b.y()) < std::min(c.y(), d.y()) || std::max(c.y(), d.y()) < std::min(a.y(), b.y());
}

}  // namespace

int orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return static_cast<int>(CGAL::orientation(exact(a), exact(b), exact(c)));
}

int orientation(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  return static_cast<int>(CGAL::orientation(exact(a), exact(b), exact(c), exact(d)));
}

bool segments_meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  if (boxes_apart(a, b, c, d)) return false;
  const int abc = orientation(a, b, c), abd = orientation(a, b, d);
  const int cda = orientation(c, d, a), cdb = orientation(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && within_box(c, a, b)) || (abd == 0 && within_box(d, a, b)) ||
         (cda == 0 && within_box(a, c, d)) || (cdb == 0 && within_box(b, c, d));
}

bool is_simple(const Contour& contour) {
  const Eigen::Index n = contour.rows();
  if (n < 3) return false;
  const auto at = [&](Eigen::Index i) { return Vector2d(contour.row(i % n)); };
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vector2d a = at(i), b = at(i + 1), c = at(i + 2);
    if (a == b) return false;
    // The next side must not run back along this one.
    if (orientation(a, b, c) == 0 && (within_box(c, a, b) || within_box(a, b, c))) return false;
    for (Eigen::Index k = i + 2; k < n; ++k) {
      if (i == 0 && k == n - 1) continue;  // neighbours, too
      if (segments_meet(a, b, at(k), at(k + 1))) return false;
    }
  }
  return true;
}

int area_sign(const Contour& contour) {
  const Eigen::Index n = contour.rows();
  double sum = 0.0, size = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index k = (i + 1) % n;
    const double plus = contour(i, 0) * contour(k, 1), minus = contour(k, 0) * contour(i, 1);
    sum += plus - minus;
    size += std::abs(plus) + std::abs(minus);
  }
  if (const int sign = certain_sign(sum, size, static_cast<int>(3 * n)); sign != 0) return sign;
  Rational exact_sum = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index k = (i + 1) % n;
    exact_sum +=
        Rational(contour(i, 0)) * Rational(contour(k, 1)) - Rational(contour(k, 0)) * Rational(contour(i, 1));
  }
  return exact_sum.sign();
}

bool covers(const Contour& contour, const Vector2d& p) {
  const Eigen::Index n = contour.rows();
  bool inside = false;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vector2d a = contour.row(i), b = contour.row((i + 1) % n);
    const int turn = orientation(a, b, p);
    if (turn == 0 && within_box(p, a, b)) return true;
    // Sides that the ray to the right of p crosses; each includes its lower end alone.
    if ((a.y() <= p.y()) != (b.y() <= p.y()) && (turn > 0) == (b.y() > a.y())) inside = !inside;
  }
  return inside;
}

int volume_sign(const Points& points, const std::vector<std::array<int, 3>>& triangles) {
  if (triangles.empty()) return 0;
  // Differences from one corner are rounded; that error is part of the doubt, relative to the coordinates.
  const Vector3d origin = points.row(triangles[0][0]);
  double reach = 0.0, offset = origin.cwiseAbs().maxCoeff();
  double sum = 0.0, size = 0.0;
  for (const auto& t : triangles) {
    const Vector3d a = points.row(t[0]).transpose() - origin, b = points.row(t[1]).transpose() - origin,
                   c = points.row(t[2]).transpose() - origin;
    sum += a.dot(b.cross(c));
    size += a.norm() * b.norm() * c.norm();
    reach = std::max({reach, a.norm(), b.norm(), c.norm()});
  }
  const double shift = reach > 0.0 ? 1.0 + offset / reach : 1.0;
  const int operations = static_cast<int>(triangles.size()) + 30;
  if (const int sign = certain_sign(sum, 6.0 * size * shift, operations); sign != 0) return sign;
  Rational exact_sum = 0;
  for (const auto& t : triangles) {
    std::array<std::array<Rational, 3>, 3> m;
    for (size_t i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) m[i][static_cast<size_t>(k)] = Rational(points(t[i], k));
    exact_sum += m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                 m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
  return exact_sum.sign();
}

}  // namespace planewright
