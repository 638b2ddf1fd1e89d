#include "core/problem/demands/border_curve_demand.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/problem/demands/linear_rows.h"
#include "core/problem/demands/outline_curve.h"

namespace planewright {
namespace {

// Edges: how far off the curve a point may be that reaches beyond the end of a piece, where the curve goes on
// smoothly, and how far it may reach at most. Interior point methods stop short of a bound: so far that a
// reach of rounding would not show where the point wants to go.
constexpr double kOffCurve = 1e-6, kReach = 1e-3;
// Edges: shorter segments are one place.
constexpr double kNoLength = 1e-9;

class BorderRows {
 public:
  explicit BorderRows(const DemandContext& context) : context_(context), complex_(context.complex) {}

  // Points at vertices of the mesh: planarize and cluster.
  void at_vertices() {
    for (const std::vector<int>& outline : outlines(complex_)) {
      const OutlineCurve curve(complex_.preferred, outline);
      std::vector<int> on(outline.size(), -1);  // the piece that each corner slides on
      for (size_t k = 0; k < outline.size(); ++k) {
        const int j = outline[k];
        if (!selected(j)) continue;
        if (curve.is_kink(k) || curve.piece_of(k) < 0) {
          hold(j);
          continue;
        }
        const Vector3d now = context_.at ? context_.at->x.row(j) : complex_.preferred.row(j);
        on[k] = curve.nearest_piece(curve.piece_of(k), now);
        const CurvePiece& piece = curve.pieces()[static_cast<size_t>(on[k])];
        slide(j, piece.start, piece.end, from_end(piece.turn_at_start, piece.length()),
              from_end(piece.turn_at_end, piece.length()));
      }
      for (size_t k = 0; k < outline.size(); ++k) {
        const size_t next = (k + 1) % outline.size();
        if (on[k] >= 0 && on[k] == on[next] && k != next)
          keep_order(outline[k], outline[next], curve.pieces()[static_cast<size_t>(on[k])], outline.size());
      }
    }
  }

  Result<void> dual() {
    std::map<int, int> corner_at;  // by mesh vertex
    for (int j = 0; j < complex_.point_count(); ++j)
      if (origin(j).kind == PointKind::Corner) corner_at[origin(j).element] = j;
    if (corner_at.empty() && std::any_of(complex_.panel_edges.begin(), complex_.panel_edges.end(),
                                         [](const PanelEdge& edge) { return edge.border(); }))
      return fail(ErrorCode::Usage, "the demand 'border' needs panels that reach the border", "demands",
                  "Use the border policy 'closed'");
    for (int j = 0; j < complex_.point_count(); ++j) {
      if (!selected(j)) continue;
      if (origin(j).kind == PointKind::Corner) hold(j);
      if (origin(j).kind != PointKind::BorderEdge) continue;
      const auto [a, b] = complex_.input.edges[static_cast<size_t>(origin(j).element)];
      const Vector3d start = complex_.preferred.row(corner_at.at(a)),
                     end = complex_.preferred.row(corner_at.at(b));
      const double away = margin((end - start).norm());
      slide(j, start, end, away, away);
    }
    return {};
  }

  Constraints take() {
    Constraints constraints;
    constraints.push_back(std::move(rows_));
    return constraints;
  }

 private:
  bool selected(int j) const { return context_.where.points[static_cast<size_t>(j)] != 0; }
  const PointOrigin& origin(int j) const { return complex_.point_origin[static_cast<size_t>(j)]; }
  double margin(double length) const { return std::min(context_.margin, 0.25 * length); }
  // How far a sliding point stays from the end of a piece where the curve turns by so much.
  double from_end(double turn, double length) const {
    if (turn > kKinkTurn) return margin(length);
    return -std::min({kReach, kOffCurve / std::max(std::sin(turn), kOffCurve), 0.1 * length});
  }

  void hold(int j) {
    for (int axis = 0; axis < 3; ++axis) {
      const double place = complex_.preferred(j, axis);
      rows_->add(std::array{context_.layout.x(j, axis)}, std::array{1.0}, {place, place},
                 {ElementKind::Point, j});
    }
  }

  // On the line from start to end, at least `first` from the one and `last` from the other.
  void slide(int j, const Vector3d& start, const Vector3d& end, double first, double last) {
    const double length = (end - start).norm();
    const Vector3d along = length > kNoLength ? Vector3d((end - start) / length) : Vector3d::UnitX();
    const Vector3d u = along.unitOrthogonal(), v = along.cross(u);
    const int x = context_.layout.x(j);
    const ElementRef element{ElementKind::Point, j};
    for (const Vector3d& across : {u, v})
      rows_->add_point(x, across, {across.dot(start), across.dot(start)}, element);
    const double low = along.dot(start);
    if (length > kNoLength)
      rows_->add_point(x, along, {low + first, low + length - last}, element);
    else
      rows_->add_point(x, along, {low, low}, element);
  }

  void keep_order(int j, int next, const CurvePiece& piece, size_t corners) {
    const Vector3d along = (piece.end - piece.start) / piece.length();
    const int x = context_.layout.x(j), y = context_.layout.x(next);
    // All corners of the outline have to find room on one piece.
    const double apart = margin(piece.length() / static_cast<double>(corners));
    rows_->add(std::array{x, x + 1, x + 2, y, y + 1, y + 2},
               std::array{-along[0], -along[1], -along[2], along[0], along[1], along[2]}, {apart, kUnbounded},
               {ElementKind::Point, j});
  }

  const DemandContext& context_;
  const TangentComplex& complex_;
  std::unique_ptr<LinearRows> rows_ = std::make_unique<LinearRows>("border", "edges");
};

}  // namespace

Result<Constraints> make_border_curve_demand(const DemandContext& context) {
  BorderRows rows(context);
  if (context.complex.kind != ComplexKind::Dual)
    rows.at_vertices();
  else if (auto closed = rows.dual(); !closed)
    return tl::unexpected(closed.error());
  return rows.take();
}

}  // namespace planewright
