#include "core/problem/demands/outline_curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace planewright {
namespace {

// Sides that stray less than this from one line (turns times length) are one piece; mean edges, as the
// complexes that demands see are normalised.
constexpr double kStraight = 1e-6;
// Shorter sides have no direction.
constexpr double kNoLength = 1e-12;

double angle_between(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double distance(const CurvePiece& piece, const Vector3d& at) {
  const Vector3d along = piece.end - piece.start;
  const double t = std::clamp((at - piece.start).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (piece.start + t * along - at).norm();
}

}  // namespace

std::vector<std::vector<int>> outlines(const TangentComplex& complex) {
  std::vector<int> next(static_cast<size_t>(complex.point_count()), -1);
  for (const PanelEdge& edge : complex.panel_edges) {
    if (!edge.border()) continue;
    const auto [from, to] = edge.left >= 0 ? std::pair(edge.a, edge.b) : std::pair(edge.b, edge.a);
    next[static_cast<size_t>(from)] = to;
  }
  std::vector<std::vector<int>> found;
  for (int first = 0; first < complex.point_count(); ++first) {
    std::vector<int> outline;
    for (int j = first; j >= 0 && next[static_cast<size_t>(j)] >= 0;) {
      outline.push_back(j);
      j = std::exchange(next[static_cast<size_t>(j)], -1);
    }
    if (!outline.empty()) found.push_back(std::move(outline));
  }
  return found;
}

OutlineCurve::OutlineCurve(const Points& points, const std::vector<int>& outline)
    : kink_(outline.size(), 0), piece_(outline.size(), -1) {
  // Corners with a side of positive length before them; the others lie where the last such one lies.
  const auto at = [&](size_t k) -> Vector3d { return points.row(outline[k]); };
  std::vector<size_t> corners;
  for (size_t k = 0; k < outline.size(); ++k)
    if (corners.empty() || (at(k) - at(corners.back())).norm() > kNoLength) corners.push_back(k);
  while (corners.size() > 1 && (at(corners.back()) - at(corners.front())).norm() <= kNoLength)
    corners.pop_back();
  const size_t n = corners.size();
  if (n < 2) return;

  std::vector<double> turns(n);
  const auto corner = [&](size_t c) { return at(corners[c % n]); };
  for (size_t c = 0; c < n; ++c)
    turns[c] = angle_between(corner(c) - corner(c + n - 1), corner(c + 1) - corner(c));
  const auto side = [&](size_t c) { return (corner(c + 1) - corner(c)).norm(); };
  // A closed curve turns somewhere; pieces are collected from there on.
  const size_t first = static_cast<size_t>(std::max_element(turns.begin(), turns.end()) - turns.begin());
  std::vector<int> piece_after(n, -1);
  for (size_t c = first; c < first + n;) {
    const size_t start = c;
    double turned = 0.0, length = 0.0;
    do {
      piece_after[c % n] = static_cast<int>(pieces_.size());
      length += side(c++);
      turned += turns[c % n];
    } while (c < first + n && turns[c % n] <= kKinkTurn && turned * (length + side(c)) <= kStraight);
    pieces_.push_back({corner(start), corner(c), turns[start % n], turns[c % n], -1, -1});
  }
  const int count = static_cast<int>(pieces_.size());
  for (int p = 0; p < count; ++p) {
    CurvePiece& piece = pieces_[static_cast<size_t>(p)];
    if (piece.turn_at_start <= kKinkTurn) piece.before = (p + count - 1) % count;
    if (piece.turn_at_end <= kKinkTurn) piece.after = (p + 1) % count;
  }

  for (size_t c = 0; c < n; ++c) {
    const size_t last = c + 1 < n ? corners[c + 1] : outline.size();
    for (size_t k = corners[c]; k < last; ++k) {
      kink_[k] = turns[c] > kKinkTurn;
      piece_[k] = piece_after[c];
    }
  }
}

int OutlineCurve::nearest_piece(int piece, const Vector3d& at) const {
  if (piece < 0) return piece;
  double nearest = distance(pieces_[static_cast<size_t>(piece)], at);
  for (int CurvePiece::*way : {&CurvePiece::after, &CurvePiece::before})
    while (true) {
      const int next = pieces_[static_cast<size_t>(piece)].*way;
      if (next < 0) break;
      const double d = distance(pieces_[static_cast<size_t>(next)], at);
      if (!(d < nearest)) break;
      nearest = d;
      piece = next;
    }
  return piece;
}

}  // namespace planewright
