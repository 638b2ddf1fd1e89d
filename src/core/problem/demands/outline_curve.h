// OutlineCurve: the polyline that the wanted points of an outline make, cut into straight pieces. Internal to
// demands/border_curve_demand.cpp.
//
// A point where the curve turns by more than kKinkDegrees is a kink. Between two kinks the curve is smooth;
// sides in one line are one piece. Units: those of the points.
#pragma once

#include <numbers>
#include <vector>

#include "core/complex/tangent_complex.h"

namespace planewright {

inline constexpr double kKinkDegrees = 5.0;
inline constexpr double kKinkTurn = kKinkDegrees * std::numbers::pi / 180.0;

struct CurvePiece {
  Vector3d start, end;
  double turn_at_start, turn_at_end;  // radians
  int before, after;                  // pieces; -1 where a kink or nothing lies between
  double length() const { return (end - start).norm(); }
};

// The outlines of a complex's panels: lists of points in the direction of the panels' sides, closed.
std::vector<std::vector<int>> outlines(const TangentComplex& complex);

class OutlineCurve {
 public:
  // points: where the curve's corners are, #X x 3; outline: its corners in order, closed.
  OutlineCurve(const Points& points, const std::vector<int>& outline);

  const std::vector<CurvePiece>& pieces() const { return pieces_; }
  // Of the k-th corner of the outline: whether it is a kink, and a piece that it lies on (-1: the whole
  // outline is one place).
  bool is_kink(size_t k) const { return kink_[k] != 0; }
  int piece_of(size_t k) const { return piece_[k]; }

  // The piece nearest to `at` that one comes to from `piece` by going along the curve, never past a kink and
  // never away from `at`; so a point that slides along the curve is followed, and does not jump to where the
  // curve comes by again.
  int nearest_piece(int piece, const Vector3d& at) const;

 private:
  std::vector<CurvePiece> pieces_;
  std::vector<char> kink_;
  std::vector<int> piece_;
};

}  // namespace planewright
