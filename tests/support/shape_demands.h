// Problems with one demand on the panels' shapes, and designs that violate such demands.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "core/diagnose/panel_shape.h"
#include "core/problem/derivative_check.h"
#include "support/solves.h"

namespace planewright::test {

inline Result<SharedProblem> try_with_demand(SharedComplex complex, const Demand& demand,
                                             std::vector<Selection> selections = {},
                                             const FrozenGeometry& frozen = {}) {
  ProblemSettings settings;
  settings.demands.list = {demand};
  settings.selections = std::move(selections);
  return Problem::create(std::move(complex), settings, frozen);
}
inline SharedProblem with_demand(SharedComplex complex, const Demand& demand,
                                 std::vector<Selection> selections = {}, const FrozenGeometry& frozen = {}) {
  return try_with_demand(std::move(complex), demand, std::move(selections), frozen).value();
}

inline std::vector<int> rows_of(const Problem& problem, const std::string& name) {
  std::vector<int> rows;
  for (int row = 0; row < problem.rows(); ++row)
    if (problem.row_name(row) == name) rows.push_back(row);
  return rows;
}
inline std::vector<int> rows_of(const Problem& problem, const std::string& name, ElementKind kind) {
  std::vector<int> rows = rows_of(problem, name);
  std::erase_if(rows, [&](int row) { return problem.row_element(row).kind != kind; });
  return rows;
}

// Largest violation of a demand; -1 if the problem does not have it.
inline double violation(const Problem& problem, const State& state, const std::string& name) {
  const Vector z = problem.from_state(state);
  for (const auto& entry : problem.violations(z.data(), 1e-9))
    if (entry.name == name) return entry.max_violation;
  return -1.0;
}

// One panel in the plane z = 0, of these corners.
inline Shape flat_polygon(const std::vector<std::array<double, 2>>& corners) {
  Shape shape;
  shape.positions.resize(static_cast<Eigen::Index>(corners.size()), 3);
  std::vector<int> face;
  for (size_t c = 0; c < corners.size(); ++c) {
    shape.positions.row(static_cast<Eigen::Index>(c)) << corners[c][0], corners[c][1], 0.0;
    face.push_back(static_cast<int>(c));
  }
  shape.faces.push_back(face);
  return shape;
}

// A flat grid of 3 x 3 quads, one of whose inner corners lies beyond the next corner of its row: of the quads
// at it one is folded over and others cross themselves.
inline Shape pushed_grid() {
  Shape shape = grid(3, 3);
  shape.positions(5, 0) += 1.3;
  shape.positions(5, 1) += 0.3;
  return shape;
}

inline Shape jittered(Shape shape, double across, double up, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&] { return 2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0; };
  for (Eigen::Index v = 0; v < shape.positions.rows(); ++v) {
    shape.positions(v, 0) += across * next();
    shape.positions(v, 1) += across * next();
    shape.positions(v, 2) += up * next();
  }
  return shape;
}

// An L of three unit quads round vertex 4: its panel in the dual has a reflex corner there.
inline Shape reflex_outline() {
  return {make_points(
              {{-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}}),
          {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}}};
}

// Compares every derivative with differences on meshes with panels of 2 to 14 points, at the start, near it,
// with crossed panels and with collapsed ones.
inline void expect_derivatives(const Demand& demand,
                               const std::function<FrozenGeometry(SharedComplex)>& frozen = {}) {
  auto complexes = small_complexes();
  complexes.push_back({"fourteen_dual", dual_of(fan(14).mesh())});
  complexes.push_back({"reflex_dual", dual_of(reflex_outline().mesh(), {0.2, BorderPolicy::Closed})});
  complexes.push_back({"pushed_planarize", planarize_of(pushed_grid().mesh())});
  double hessian = 0.0;
  for (const auto& [name, complex] : complexes) {
    const SharedProblem problem =
        with_demand(complex, demand, {}, frozen ? frozen(complex) : FrozenGeometry{});
    State collapsed = perturbed(*complex, 0.1);
    collapsed.x.row(complex->panel_edges[0].a) = collapsed.x.row(complex->panel_edges[0].b);
    State point = initial_state(*complex);
    point.x.rowwise() = Eigen::RowVector3d(point.x.row(0));
    State turned = perturbed(*complex, 0.1);
    turned.n *= -2.0;
    for (const State& state : {initial_state(*complex), perturbed(*complex, 0.2), perturbed(*complex, 2.0),
                               collapsed, point, turned}) {
      const DerivativeCheck check = check_derivatives(*problem, problem->from_state(state));
      EXPECT_LT(check.jacobian_error, 1e-6) << name << " " << check.worst;
      EXPECT_LT(check.hessian_error, 1e-6) << name << " " << check.worst;
      hessian = std::max(hessian, check.hessian_norm);
    }
  }
  EXPECT_GT(hessian, 0.1);
}

}  // namespace planewright::test
