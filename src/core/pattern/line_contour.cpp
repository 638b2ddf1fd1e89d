#include "core/pattern/line_contour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace planewright {
namespace {

constexpr double kParallel = 1e-9;  // sine of the angle between lines
constexpr double kNoLength = 1e-9;  // of the outline

std::optional<Vector2d> meet(const SideLine& p, const SideLine& q) {
  const double sine = cross(p.normal, q.normal);
  if (!(std::abs(sine) > kParallel)) return std::nullopt;
  return Vector2d(p.offset * q.normal.y() - q.offset * p.normal.y(),
                  q.offset * p.normal.x() - p.offset * q.normal.x()) /
         sine;
}

class Contour {
 public:
  Contour(const std::vector<SideLine>& lines, const std::vector<Vector2d>& corners)
      : lines_(lines), outline_(outline_lines(corners)), corners_(corners) {
    for (size_t k = 0; k < corners.size(); ++k) around_ += (next(corners, k) - corners[k]).norm();
    for (size_t k = 0; k < lines.size(); ++k)
      if (lines[k].exists()) alive_.push_back(k);
  }

  // Drops sides until all that are left have length. False: fewer than three are left, or two that are
  // parallel and face each other.
  bool drop_sides() {
    while (alive_.size() >= 3) {
      if (drop_one_of_parallels()) continue;
      if (!place_points()) return false;
      if (!drop_first_to_vanish()) return true;
    }
    return false;
  }

  LineContour result(double limit, const std::vector<bool>& meets) const {
    LineContour contour;
    const size_t n = alive_.size();
    std::vector<double> begin(n), end(n), begin_wanted(n), end_wanted(n);
    std::vector<bool> cut(n, false);  // the corner where side i of alive_ begins
    for (size_t i = 0; i < n; ++i) {
      const Vector2d along = lines_[alive_[i]].along();
      begin[i] = begin_wanted[i] = along.dot(points_[i]);
      end[i] = end_wanted[i] = along.dot(next(points_, i));
    }
    for (size_t i = 0; i < n; ++i) {
      const size_t before = (i + n - 1) % n, side = alive_[i], previous = alive_[before];
      if ((previous + 1) % lines_.size() != side) continue;  // sides lost between: no corner of the panel
      const Vector2d& corner = corners_[side];
      const double distance = (points_[i] - corner).norm();
      const bool far = distance > limit, alone = !meets.empty() && !meets[side];
      if (!far && !alone) continue;
      const double on_previous = lines_[previous].along().dot(corner),
                   on_next = lines_[side].along().dot(corner);
      const double turn = cross(lines_[previous].normal, lines_[side].normal);
      const double slack = kNoLength * around_;
      const bool sticks_out = turn > kParallel && on_previous < end[before] && on_next > begin[i];
      // Reflex, and moved along one of its sides: what the other line encloses there is the neighbour's.
      const bool runs_on =
          turn < -kParallel && ((on_previous < end[before] - slack && on_next < begin[i] - slack) ||
                                (on_previous > end[before] + slack && on_next > begin[i] + slack));
      cut[i] = (far && sticks_out) || runs_on;
      if (far) contour.far.push_back({static_cast<int>(side), distance, cut[i]});
      if (!cut[i]) continue;
      end_wanted[before] = on_previous;
      begin_wanted[i] = on_next;
    }
    std::sort(contour.far.begin(), contour.far.end(),
              [](const FarCorner& a, const FarCorner& b) { return a.corner < b.corner; });

    contour.start.assign(lines_.size(), -1);
    contour.end.assign(lines_.size(), -1);
    const auto at = [&](size_t i, double t) {
      const SideLine& line = lines_[alive_[i]];
      return Vector2d(line.offset * line.normal + t * line.along());
    };
    for (size_t i = 0; i < n; ++i) {
      // A cut that would leave nothing of the side (its other end lies beyond the foot) is made within it.
      const double length = end[i] - begin[i];
      if (!(end_wanted[i] - begin_wanted[i] > kNoLength * around_)) {
        // Of an end that a reflex corner has moved outwards nothing is taken.
        if (begin_wanted[i] > begin[i]) begin_wanted[i] = begin[i] + length / 3;
        if (end_wanted[i] < end[i]) end_wanted[i] = end[i] - length / 3;
      }
    }
    for (size_t i = 0; i < n; ++i) {
      contour.start[alive_[i]] = static_cast<int>(contour.points.size());
      contour.points.push_back(cut[i] ? at(i, begin_wanted[i]) : points_[i]);
      if (cut[(i + 1) % n]) {
        contour.end[alive_[i]] = static_cast<int>(contour.points.size());
        contour.points.push_back(at(i, end_wanted[i]));
      }
    }
    for (size_t i = 0; i < n; ++i)
      if (contour.end[alive_[i]] < 0) contour.end[alive_[i]] = contour.start[alive_[(i + 1) % n]];
    // Lost sides are where the side before them ends.
    for (size_t i = 0; i < n; ++i)
      for (size_t k = (alive_[i] + 1) % lines_.size(); k != alive_[(i + 1) % n];
           k = (k + 1) % lines_.size()) {
        contour.start[k] = contour.end[k] = contour.end[alive_[i]];
        contour.lost.push_back(static_cast<int>(k));
      }
    std::sort(contour.lost.begin(), contour.lost.end());
    return contour;
  }

 private:
  template <class T>
  static const T& next(const std::vector<T>& list, size_t i) {
    return list[(i + 1) % list.size()];
  }

  // Lines that run on in one direction but not in the same place never meet: the outer one encloses nothing
  // that the inner one does not shut out.
  bool drop_one_of_parallels() {
    for (size_t i = 0; i < alive_.size(); ++i) {
      const size_t j = (i + 1) % alive_.size();
      const SideLine &p = lines_[alive_[i]], &q = lines_[alive_[j]];
      if (std::abs(cross(p.normal, q.normal)) > kParallel || p.normal.dot(q.normal) < 0) continue;
      if (std::abs(p.offset - q.offset) <= kNoLength * around_) continue;
      alive_.erase(alive_.begin() + static_cast<std::ptrdiff_t>(p.offset > q.offset ? i : j));
      return true;
    }
    return false;
  }

  // Where the line of alive side i meets that of the alive side before it.
  std::optional<Vector2d> corner(const std::vector<SideLine>& lines, size_t i) const {
    const size_t side = alive_[i], previous = alive_[(i + alive_.size() - 1) % alive_.size()];
    if (const auto point = meet(lines[previous], lines[side])) return point;
    if (lines[previous].normal.dot(lines[side].normal) < 0) return std::nullopt;
    return Vector2d((lines[previous].foot(corners_[side]) + lines[side].foot(corners_[side])) / 2);
  }

  bool place_points() {
    points_.clear();
    for (size_t i = 0; i < alive_.size(); ++i) {
      const auto point = corner(lines_, i);
      if (!point || !point->allFinite()) return false;
      points_.push_back(*point);
    }
    return true;
  }

  // Lengths change linearly while the lines move.
  bool drop_first_to_vanish() {
    double earliest = std::numeric_limits<double>::infinity();
    size_t first = 0;
    for (size_t i = 0; i < alive_.size(); ++i) {
      const Vector2d along = lines_[alive_[i]].along();
      const double length = along.dot(next(points_, i) - points_[i]);
      if (length > kNoLength * around_) continue;
      const auto a = corner(outline_, i), b = corner(outline_, (i + 1) % alive_.size());
      const double at_first = a && b ? along.dot(*b - *a) : 0.0;
      const double when = at_first > 0.0 ? at_first / (at_first - length) : 0.0;
      if (when < earliest) {
        earliest = when;
        first = i;
      }
    }
    if (!std::isfinite(earliest)) return false;
    alive_.erase(alive_.begin() + static_cast<std::ptrdiff_t>(first));
    return true;
  }

  const std::vector<SideLine>& lines_;
  std::vector<SideLine> outline_;
  const std::vector<Vector2d>& corners_;
  double around_ = 0.0;
  std::vector<size_t> alive_;     // sides, ascending
  std::vector<Vector2d> points_;  // where each alive side begins, uncut
};

}  // namespace

LineContour line_contour(const std::vector<SideLine>& lines, const std::vector<Vector2d>& corners,
                         double limit, const std::vector<bool>& meets) {
  Contour contour(lines, corners);
  if (!contour.drop_sides()) return {};
  LineContour result = contour.result(limit, meets);
  if (!(signed_area(result.points) > 0.0) || crosses_itself(result.points)) return {};
  return result;
}

}  // namespace planewright
