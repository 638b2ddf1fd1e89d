#include "core/pattern/contours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <polyclipping/clipper.hpp>
#include <queue>

namespace planewright {
namespace {

using Eigen::Vector2d;

constexpr double kGrid = 1e-6;  // mm, of a union's corners

ClipperLib::Path path_of(const Contour& contour) {
  ClipperLib::Path path;
  for (Eigen::Index k = 0; k < contour.rows(); ++k)
    path.emplace_back(std::llround(contour(k, 0) / kGrid), std::llround(contour(k, 1) / kGrid));
  return path;
}

Vector2d corner(const Contour& contour, Eigen::Index k) {
  return contour.row(k % contour.rows()).transpose();
}

double distance_to_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d edge = b - a;
  const double square = edge.squaredNorm();
  const double along = square > 0.0 ? std::clamp((p - a).dot(edge) / square, 0.0, 1.0) : 0.0;
  return (a + along * edge - p).norm();
}

// Whether the segments a b and c d pass through each other by more than slack at all four ends.
bool cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d, double slack) {
  const auto beside = [](const Vector2d& p, const Vector2d& q, const Vector2d& of) {
    const Vector2d edge = q - p, to = of - p;
    return (edge.x() * to.y() - edge.y() * to.x()) / std::max(edge.norm(), 1e-300);
  };
  const auto opposite = [&](double s, double t) {
    return (s > slack && t < -slack) || (s < -slack && t > slack);
  };
  return opposite(beside(a, b, c), beside(a, b, d)) && opposite(beside(c, d, a), beside(c, d, b));
}

struct Square {
  Vector2d middle;
  double half, depth, bound;  // bound: no point of the square is deeper
};

}  // namespace

double depth_in(const Contour& contour, const Vector2d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (Eigen::Index k = 0; k < contour.rows(); ++k) {
    const Vector2d a = corner(contour, k), b = corner(contour, k + 1);
    nearest = std::min(nearest, distance_to_segment(point, a, b));
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside ? nearest : -nearest;
}

bool contains(const Contour& outer, const Contour& inner, double slack) {
  for (Eigen::Index k = 0; k < inner.rows(); ++k)
    if (depth_in(outer, corner(inner, k)) < -slack) return false;
  // All corners are inside; a side may still pass over a notch.
  for (Eigen::Index k = 0; k < outer.rows(); ++k)
    if (depth_in(inner, corner(outer, k)) > slack) return false;
  for (Eigen::Index k = 0; k < inner.rows(); ++k)
    for (Eigen::Index j = 0; j < outer.rows(); ++j)
      if (cross(corner(inner, k), corner(inner, k + 1), corner(outer, j), corner(outer, j + 1), slack))
        return false;
  return true;
}

// Where sides of both contours lie on one line, rounding to the grid leaves corners a few steps apart, and
// both become the same corner of one of them.
Contour without_repeats(const Contour& contour) {
  Contour kept(contour.rows(), 2);
  Eigen::Index count = 0;
  for (Eigen::Index k = 0; k < contour.rows(); ++k) {
    const Eigen::Index before = (k + contour.rows() - 1) % contour.rows();
    if ((contour.row(k) - contour.row(before)).norm() > 4 * kGrid) kept.row(count++) = contour.row(k);
  }
  return kept.topRows(count);
}

Contour united(const Contour& a, const Contour& b) {
  constexpr double kSame = 1e-9;  // mm
  if (contains(a, b, kSame)) return a;
  if (contains(b, a, kSame)) return b;
  ClipperLib::Clipper clipper;
  clipper.AddPath(path_of(a), ClipperLib::ptSubject, true);
  clipper.AddPath(path_of(b), ClipperLib::ptClip, true);
  ClipperLib::Paths paths;
  clipper.Execute(ClipperLib::ctUnion, paths, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  const auto largest = std::max_element(paths.begin(), paths.end(), [](const auto& p, const auto& q) {
    return ClipperLib::Area(p) < ClipperLib::Area(q);
  });
  if (largest == paths.end()) return a;
  Contour result(static_cast<Eigen::Index>(largest->size()), 2);
  for (size_t k = 0; k < largest->size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    result.row(row) << kGrid * static_cast<double>((*largest)[k].X),
        kGrid * static_cast<double>((*largest)[k].Y);
    for (const Contour* own : {&a, &b})
      for (Eigen::Index j = 0; j < own->rows(); ++j)
        if ((own->row(j) - result.row(row)).norm() < 2 * kGrid) result.row(row) = own->row(j);
  }
  return without_repeats(result);
}

DeepestPoint deepest_point(const std::vector<const Contour*>& contours) {
  Vector2d low = contours[0]->colwise().minCoeff().transpose(),
           high = contours[0]->colwise().maxCoeff().transpose();
  const auto square = [&](const Vector2d& middle, double half) {
    double depth = std::numeric_limits<double>::infinity();
    for (const Contour* contour : contours) depth = std::min(depth, depth_in(*contour, middle));
    return Square{middle, half, depth, depth + half * std::sqrt(2.0)};
  };
  const auto shallower = [](const Square& a, const Square& b) { return a.bound < b.bound; };
  std::priority_queue<Square, std::vector<Square>, decltype(shallower)> open(shallower);
  const Vector2d size = high - low;
  const double half = std::max(size.minCoeff(), size.maxCoeff() / 16) / 2;
  for (double x = low.x() + half; x - half < high.x(); x += 2 * half)
    for (double y = low.y() + half; y - half < high.y(); y += 2 * half) open.push(square({x, y}, half));

  DeepestPoint best{(low + high) / 2, -std::numeric_limits<double>::infinity()};
  const double finest = 1e-6 * size.maxCoeff();
  while (!open.empty()) {
    const Square at = open.top();
    open.pop();
    if (at.depth > best.depth) best = {at.middle, at.depth};
    if (at.bound <= best.depth + std::max(0.01 * std::abs(best.depth), finest)) break;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) open.push(square(at.middle + at.half * Vector2d(x, y), at.half / 2));
  }
  return best;
}

}  // namespace planewright
