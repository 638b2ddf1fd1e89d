#include "core/problem/contradictions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/problem/demands/separation.h"

namespace planewright {
namespace {

// Edges (or unit-free): below this a contradiction is rounding.
constexpr double kRounding = 1e-7;
// Shares of a row's slope: less than the first left over is none; from the second on it is a direction. What
// lies between is left to the solver: it could be either, for all that rounding tells.
constexpr double kNoneLeft = 1e-9, kDirectionLeft = 1e-3;
// Of unit vectors: 1 - |cosine| at which they are parallel.
constexpr double kParallel = 1e-12;

// What a linear row asks of one block of unknowns: low <= slope . (the block) <= high.
struct Range {
  int source;  // row of the problem; kFixed: what the stage keeps fixed
  Vector3d slope;
  double low, high;
};
constexpr int kFixed = -1;

// Blocks of unknowns that belong together: the points, the planes' normals, the planes' offsets.
class Blocks {
 public:
  explicit Blocks(const Layout& layout) : points_(layout.points), planes_(layout.planes) {}
  int count() const { return points_ + 2 * planes_; }
  int point(int j) const { return j; }
  int normal(int i) const { return points_ + i; }
  int offset(int i) const { return points_ + planes_ + i; }
  int of(int variable) const {
    return variable < 3 * (points_ + planes_) ? variable / 3 : variable - 2 * (points_ + planes_);
  }
  int axis(int variable) const { return variable < 3 * (points_ + planes_) ? variable % 3 : 0; }
  std::string text(int block) const {
    if (block < points_) return "the fixed planes of point " + std::to_string(block);
    if (block < points_ + planes_) return "the fixed normal of panel " + std::to_string(block - points_);
    return "the fixed offset of panel " + std::to_string(block - points_ - planes_);
  }

 private:
  int points_, planes_;
};

// The directions in which equations hold a block, orthonormal, and where.
class Held {
 public:
  struct Rest {
    Vector3d slope;  // of what is not held
    double value;    // of what is
    int source;      // of what counts most in it
    bool none;       // nothing is left
  };
  Rest rest(const Vector3d& slope) const {
    Rest rest{slope, 0.0, kFixed, false};
    double most = -1.0;
    for (int pass = 0; pass < 2; ++pass)  // twice, so that rounding is not taken for a direction
      for (int k = 0; k < dimension_; ++k) {
        const double share = rest.slope.dot(directions_[k]);
        rest.slope -= share * directions_[k];
        rest.value += share * values_[k];
        if (std::abs(share) > most) {
          most = std::abs(share);
          rest.source = sources_[k];
        }
      }
    rest.none = rest.slope.norm() <= kNoneLeft * slope.norm();
    return rest;
  }
  void hold(const Rest& rest, double target, int source) {
    const double length = rest.slope.norm();
    directions_[dimension_] = rest.slope / length;
    values_[dimension_] = (target - rest.value) / length;
    sources_[dimension_++] = source;
  }
  int dimension() const { return dimension_; }
  int source() const { return sources_[0]; }
  // The unit vector that the directions leave, the one nearer to `guess`; none if they leave more.
  std::optional<Vector3d> unit_vector(const Vector3d& guess) const {
    if (dimension_ < 2) return {};
    Vector3d n = values_[0] * directions_[0] + values_[1] * directions_[1];
    if (dimension_ == 3) return Vector3d(n + values_[2] * directions_[2]);
    const Vector3d third = directions_[0].cross(directions_[1]);
    n += std::copysign(std::sqrt(std::max(0.0, 1.0 - n.squaredNorm())), third.dot(guess)) * third;
    return n;
  }

 private:
  std::array<Vector3d, 3> directions_;
  std::array<double, 3> values_;
  std::array<int, 3> sources_;
  int dimension_ = 0;
};

class Contradictions {
 public:
  explicit Contradictions(const Problem& problem)
      : problem_(problem),
        blocks_(problem.layout()),
        held_(static_cast<size_t>(blocks_.count())),
        ranges_(static_cast<size_t>(blocks_.count())) {}

  Result<void> check() {
    collect();
    hold_what_the_stage_fixes();
    // Offsets and normals before points: planes that are held hold their points.
    for (int block = blocks_.count() - 1; block >= 0; --block) {
      if (block == problem_.layout().points - 1) hold_points_of_held_planes();
      if (auto possible = hold(block); !possible) return possible;
    }
    for (int block = 0; block < blocks_.count(); ++block)
      if (auto possible = compare(block); !possible) return possible;
    return check_rows_of_several_blocks();
  }

 private:
  // Rows that ask something of one block alone, by block; those of several blocks, whole.
  void collect() {
    const SparsePattern& pattern = problem_.jacobian_pattern();
    const Vector zero = Vector::Zero(problem_.variables());
    slopes_.resize(pattern.size());
    Vector values(problem_.rows());
    problem_.jacobian_values(zero.data(), slopes_.data());
    problem_.constraint_values(zero.data(), values.data());
    for (int begin = 0, end; begin < pattern.size(); begin = end) {
      const int row = pattern.rows[static_cast<size_t>(begin)];
      for (end = begin; end < pattern.size() && pattern.rows[static_cast<size_t>(end)] == row;) ++end;
      const Bounds bounds = problem_.bounds(row);
      const bool has_low = bounds.low > -kNoLimit, has_high = bounds.high < kNoLimit;
      if (!(has_low || has_high) || !problem_.row_is_linear(row) || problem_.row_name(row) == kSeparationName)
        continue;
      const double low = has_low ? bounds.low - values[row] : -kUnbounded;
      const double high = has_high ? bounds.high - values[row] : kUnbounded;
      int block = -1;
      bool alone = true;
      Vector3d slope = Vector3d::Zero();
      for (int k = begin; k < end; ++k) {
        const int variable = pattern.columns[static_cast<size_t>(k)];
        if (slopes_[k] == 0.0) continue;
        if (block >= 0 && block != blocks_.of(variable)) alone = false;
        block = blocks_.of(variable);
        slope[blocks_.axis(variable)] += slopes_[k];
      }
      if (block < 0) continue;
      if (alone)
        ranges_[static_cast<size_t>(block)].push_back({row, slope, low, high});
      else
        several_.push_back({row, begin, end, low, high});
    }
  }

  void hold_what_the_stage_fixes() {
    const TangentComplex& complex = problem_.normalised();
    const auto fix = [this](int block, int axis, double value) {
      const Vector3d slope = Vector3d::Unit(axis);
      Held& held = held_[static_cast<size_t>(block)];
      held.hold(held.rest(slope), value, kFixed);
    };
    const Layout& layout = problem_.layout();
    for (int i = 0; i < layout.planes; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        if (!layout.is_free(layout.n(i, axis))) fix(blocks_.normal(i), axis, complex.normals(i, axis));
      if (!layout.is_free(layout.h(i))) fix(blocks_.offset(i), 0, complex.offsets[i]);
    }
  }

  // n . x = n . v + h for the points of planes whose normal and offset are held. At stage fixed the rows of
  // incidence say so already.
  void hold_points_of_held_planes() {
    const TangentComplex& complex = problem_.normalised();
    if (problem_.layout().freedom == Freedom::Fixed) return;
    std::vector<std::optional<Vector3d>> normals(static_cast<size_t>(complex.plane_count()));
    for (int i = 0; i < complex.plane_count(); ++i)
      if (held_[static_cast<size_t>(blocks_.offset(i))].dimension() > 0)
        normals[static_cast<size_t>(i)] =
            held_[static_cast<size_t>(blocks_.normal(i))].unit_vector(complex.normals.row(i));
    for (int j = 0; j < complex.point_count(); ++j)
      for (int i : complex.planes_of_point[j]) {
        const auto& normal = normals[static_cast<size_t>(i)];
        if (!normal) continue;
        const Held::Rest offset = held_[static_cast<size_t>(blocks_.offset(i))].rest(Vector3d::UnitX());
        const double distance = normal->dot(complex.anchors.row(i)) + offset.value;
        // Held by the pin: with the offset fixed by the stage, by that of the normal.
        const int source =
            offset.source != kFixed ? offset.source : held_[static_cast<size_t>(blocks_.normal(i))].source();
        ranges_[static_cast<size_t>(blocks_.point(j))].push_back({source, *normal, distance, distance});
      }
  }

  // Takes the equations of a block; fails where they contradict each other.
  Result<void> hold(int block) {
    Held& held = held_[static_cast<size_t>(block)];
    for (const Range& range : ranges_[static_cast<size_t>(block)]) {
      if (range.low != range.high) continue;
      const Held::Rest rest = held.rest(range.slope);
      const double size = range.slope.norm();
      if (rest.slope.norm() >= kDirectionLeft * size)
        held.hold(rest, range.low, range.source);
      else if (rest.none && std::abs(rest.value - range.low) > kRounding * std::max(1.0, size))
        return refuse(block, range.source, rest.source);
    }
    return {};
  }

  // Ranges of a block against what is held, and against each other.
  Result<void> compare(int block) {
    const Held& held = held_[static_cast<size_t>(block)];
    std::vector<Range> seen;  // of unit slopes
    for (const Range& range : ranges_[static_cast<size_t>(block)]) {
      if (range.low == range.high) continue;
      const Held::Rest rest = held.rest(range.slope);
      const double size = range.slope.norm(), left = rest.slope.norm();
      if (rest.none) {
        if (std::max(range.low - rest.value, rest.value - range.high) > kRounding * std::max(1.0, size))
          return refuse(block, range.source, rest.source);
        continue;
      }
      if (left < kDirectionLeft * size) continue;
      Range unit{range.source, rest.slope / left, -kUnbounded, kUnbounded};
      if (range.low > -kNoLimit) unit.low = (range.low - rest.value) / left;
      if (range.high < kNoLimit) unit.high = (range.high - rest.value) / left;
      for (const Range& other : seen) {
        const double cosine = other.slope.dot(unit.slope);
        if (1.0 - std::abs(cosine) > kParallel) continue;
        const double low = cosine > 0.0 ? other.low : -other.high;
        const double high = cosine > 0.0 ? other.high : -other.low;
        if (std::max(low, unit.low) > std::min(high, unit.high) + kRounding)
          return refuse(block, range.source, other.source);
      }
      seen.push_back(unit);
    }
    return {};
  }

  Result<void> check_rows_of_several_blocks() const {
    const SparsePattern& pattern = problem_.jacobian_pattern();
    for (const Several& row : several_) {
      double value = 0.0, scale = 1.0;
      bool settled = true;
      int source = kFixed, block = -1;
      for (int k = row.begin; k < row.end && settled; ++k) {
        // Unknown by unknown: the slopes of one block may cancel out along what is free, but demands on
        // several points mostly ask for differences, whose points are held whole or not.
        const int variable = pattern.columns[static_cast<size_t>(k)];
        if (slopes_[k] == 0.0) continue;
        block = blocks_.of(variable);
        const Held::Rest rest =
            held_[static_cast<size_t>(block)].rest(slopes_[k] * Vector3d::Unit(blocks_.axis(variable)));
        settled = rest.none;
        value += rest.value;
        scale = std::max(scale, std::abs(slopes_[k]));
        source = rest.source;
      }
      if (settled && std::max(row.low - value, value - row.high) > kRounding * scale)
        return refuse(block, row.row, source);
    }
    return {};
  }

  std::string describe(int block, int source) const {
    if (source == kFixed) return blocks_.text(block);
    if (problem_.row_name(source) == "incidence") return blocks_.text(problem_.row_element(source).index);
    std::string description = "'";
    return description.append(problem_.row_name(source))
        .append("' at ")
        .append(text(problem_.row_element(source)));
  }

  tl::unexpected<Error> refuse(int block, int row, int other) const {
    const std::string one = describe(block, row), two = describe(block, other);
    return fail(ErrorCode::Infeasible,
                (one == two ? "two demands " + one : one + " and " + two) + " contradict each other",
                text(problem_.row_element(row != kFixed ? row : other)), "Change or remove one of the two");
  }

  struct Several {
    int row, begin, end;  // slots of the Jacobian
    double low, high;
  };
  const Problem& problem_;
  Blocks blocks_;
  Vector slopes_;
  std::vector<Held> held_;
  std::vector<std::vector<Range>> ranges_;
  std::vector<Several> several_;
};

}  // namespace

Result<void> check_contradictions(const Problem& problem) {
  if (!problem.has_demands()) return {};
  return Contradictions(problem).check();
}

}  // namespace planewright
