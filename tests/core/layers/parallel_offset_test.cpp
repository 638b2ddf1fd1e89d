#include "core/layers/parallel_offset.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/solves.h"

namespace planewright {
namespace {

using namespace test;

// Panels that a solve has made planar to rounding.
struct Solved {
  SharedComplex complex;
  State state;
};
Solved solved(SharedComplex complex) {
  const SolveReport report = solve(*problem_of(complex, {{"position", 1.0}, {"fairing", 0.1}}));
  EXPECT_LE(off_plane(*complex, report.state), 1e-12);
  return {complex, report.state};
}
Solved solved_dome() {
  return solved(dual_of(make_sample("dome", 80).value(), {0.1, BorderPolicy::Closed}));
}
Solved solved_quads() {
  return solved(planarize_of(twisted_grid(4, 3, 0.15).mesh()));
}

Vector3d move_of(const Solved& design, const ParallelOffset& offset, int j) {
  return (offset.state.x.row(j) - design.state.x.row(j)).transpose();
}

// Largest distance of the moved corners from the moved planes.
double off_moved_planes(const Solved& design, const ParallelOffset& offset) {
  return incidence_residuals(*design.complex, offset.state).cwiseAbs().maxCoeff();
}

double largest_edge_angle(const Solved& design, const ParallelOffset& offset, bool border_only = false) {
  double largest = 0.0;
  for (const PanelEdge& e : design.complex->panel_edges) {
    if (border_only && !e.border()) continue;
    const Vector3d before = (design.state.x.row(e.b) - design.state.x.row(e.a)).transpose();
    const Vector3d after = (offset.state.x.row(e.b) - offset.state.x.row(e.a)).transpose();
    largest = std::max(largest, before.normalized().cross(after.normalized()).norm());
    EXPECT_GT(before.dot(after), 0.0);
  }
  return largest;
}

TEST(ParallelOffset, OfACubeIsALargerCube) {
  const Solved design{planarize_of(cube().mesh()), initial_state(*planarize_of(cube().mesh()))};
  for (const double t : {0.1, -0.1}) {
    const ParallelOffset offset = parallel_offset(*design.complex, design.state, t);
    EXPECT_NEAR((offset.state.x - design.state.x * (1 + 2 * t)).norm(), 0.0, 1e-14);
    EXPECT_TRUE(offset.blunted.empty());
    EXPECT_TRUE(offset.residuals.empty());
    EXPECT_TRUE(same_bits(offset.state.n, design.state.n));
    EXPECT_NEAR((offset.state.h - design.state.h).minCoeff(), t, 1e-16);
  }
}

TEST(ParallelOffset, ByNothingIsTheStateItself) {
  const Solved design = solved_dome();
  const ParallelOffset offset = parallel_offset(*design.complex, design.state, 0.0);
  EXPECT_TRUE(same_bits(offset.state.x, design.state.x));
  EXPECT_TRUE(same_bits(offset.state.h, design.state.h));
  EXPECT_TRUE(offset.blunted.empty() && offset.residuals.empty());
}

// Valence 3 inside; 2 and 1 along the open border.
TEST(ParallelOffset, OfSolvedPanelsIsPlanarParallelAndAtTheThickness) {
  const Solved design = solved_dome();
  const double edge = design.complex->mean_edge, size = bounding_diagonal(design.state.x);
  for (const double t : {0.05 * edge, -0.05 * edge}) {
    const ParallelOffset offset = parallel_offset(*design.complex, design.state, t);
    EXPECT_TRUE(offset.blunted.empty());
    EXPECT_TRUE(offset.residuals.empty());
    EXPECT_LE(off_moved_planes(design, offset), 1e-12 * size);
    // Each corner at exactly t from each of its panels as they were.
    for (int j = 0; j < design.complex->point_count(); ++j)
      for (int i : design.complex->planes_of_point[j])
        EXPECT_NEAR(design.state.n.row(i).dot(offset.state.x.row(j) - design.complex->anchors.row(i)) -
                        design.state.h[i],
                    t, 1e-12 * size);
    EXPECT_LE(largest_edge_angle(design, offset), 1e-9);
  }
}

// The outline has a choice: no slide along it would keep the edges parallel and be shorter.
TEST(ParallelOffset, MovesTheOutlineNoFartherThanNeeded) {
  const Solved design = solved_dome();
  const double t = 0.05 * design.complex->mean_edge;
  const ParallelOffset offset = parallel_offset(*design.complex, design.state, t);
  for (int j = 0; j < design.complex->point_count(); ++j)
    EXPECT_LE(move_of(design, offset, j).norm(), 1.2 * t) << j;
}

TEST(ParallelOffset, OfALonePanelMovesItAlongItsNormal) {
  const SharedComplex complex = planarize_of(grid(1, 1).mesh());
  const Solved design{complex, initial_state(*complex)};
  const ParallelOffset offset = parallel_offset(*complex, design.state, 0.3);
  for (int j = 0; j < 4; ++j)
    EXPECT_NEAR((move_of(design, offset, j) - Vector3d(0, 0, 0.3)).norm(), 0.0, 1e-14);
}

// Two panels like a gable roof: the ridge moves along the bisector, the eaves along their panels' normals.
TEST(ParallelOffset, OfAGableTakesTheSmallestMoves) {
  const Shape roof{make_points({{-2, 0, 0}, {-2, 3, 0}, {0, 0, 1}, {0, 3, 1}, {2, 0, 0}, {2, 3, 0}}),
                   {{0, 2, 3, 1}, {2, 4, 5, 3}}};
  const SharedComplex complex = planarize_of(roof.mesh());
  const Solved design{complex, initial_state(*complex)};
  const double t = 0.2;
  const ParallelOffset offset = parallel_offset(*complex, design.state, t);
  const Vector3d left = Vector3d(-1, 0, 2).normalized(), right = Vector3d(1, 0, 2).normalized();
  const Vector3d ridge(0, 0, 1 / left.z());
  const std::array<Vector3d, 6> expected{left, left, ridge, ridge, right, right};
  for (int j = 0; j < 6; ++j)
    EXPECT_NEAR((move_of(design, offset, j) - t * expected[j]).norm(), 0.0, 1e-12) << j;
}

// Planes that are one but for rounding: everything moves along the normal.
TEST(ParallelOffset, OfAFlatPlaceMovesAlongTheNormal) {
  const SharedComplex complex = dual_of(triangle_grid(4, 4).mesh());
  const Solved design{complex, perturbed(*complex, 1e-13)};
  const ParallelOffset offset = parallel_offset(*complex, design.state, 0.1);
  EXPECT_TRUE(offset.blunted.empty());
  EXPECT_TRUE(offset.residuals.empty());
  for (int j = 0; j < complex->point_count(); ++j)
    EXPECT_NEAR((move_of(design, offset, j) - Vector3d(0, 0, 0.1)).norm(), 0.0, 1e-9) << j;
}

TEST(ParallelOffset, GrowsWithTheThickness) {
  const Solved design = solved_quads();
  const ParallelOffset one = parallel_offset(*design.complex, design.state, 0.01);
  const ParallelOffset two = parallel_offset(*design.complex, design.state, -0.02);
  EXPECT_NEAR((2 * (one.state.x - design.state.x) + (two.state.x - design.state.x)).norm(), 0.0, 1e-13);
}

// --- Corners whose planes do not meet ----------------------------------------------------------------------

// Two planes that lean apart by 0.5 and a third that nearly contains their intersection: with m = (0, y, z)
// times the thickness, z cos 0.5 = 1 and y sin b + z cos b = 1.
TEST(ParallelOffset, NamesAndBluntsCornersThatMoveTooFar) {
  const SharedComplex complex = planarize_of(cube().mesh());
  State state = initial_state(*complex);
  const int corner = 6;
  const auto planes = complex->planes_of_point[corner];
  ASSERT_EQ(planes.size(), 3u);
  const double a = 0.5, b = 0.01, t = -0.02;
  state.n.row(planes[0]) << std::sin(a), 0, std::cos(a);
  state.n.row(planes[1]) << -std::sin(a), 0, std::cos(a);
  state.n.row(planes[2]) << 0, std::sin(b), std::cos(b);
  const double z = 1 / std::cos(a), y = (1 - z * std::cos(b)) / std::sin(b);
  const Vector3d wanted(0, y, z);
  ASSERT_GT(wanted.norm(), 10.0);
  const ParallelOffset offset = parallel_offset(*complex, state, t);
  const auto named = std::find_if(offset.blunted.begin(), offset.blunted.end(),
                                  [&](const auto& blunted) { return blunted.point == corner; });
  ASSERT_NE(named, offset.blunted.end());
  EXPECT_NEAR(named->wanted_move, wanted.norm() * std::abs(t), 1e-12);
  const Vector3d move = (offset.state.x.row(corner) - state.x.row(corner)).transpose();
  EXPECT_NEAR((move - kMostMove * t * wanted.normalized()).norm(), 0.0, 1e-12);
  for (const auto& residual : offset.residuals) EXPECT_NE(residual.point, corner);
}

// A corner of the outline that is nearly straight, between two that planes move apart: parallel edges would
// take it far along the outline. It slides as far as it may and stays on its plane.
TEST(ParallelOffset, BluntsASlideThatIsTooFarWithinThePlane) {
  const Shape panel{make_points({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1.01, 0}, {0, 1, 0}}),
                    {{0, 1, 2, 3, 4}}};
  TangentComplex complex = *planarize_of(panel.mesh());
  State state = initial_state(complex);
  // More planes than the panel's through the corners at both sides: they move by (1/3, -1/3, 1) and
  // (1/3, 1/3, 1) thicknesses.
  complex.planes_of_point = {{0}, {0}, {0, 1, 3}, {0}, {0, 1, 2}};
  state.n = make_points({{0, 0, 1}, {0.6, 0, 0.8}, {0, 0.6, 0.8}, {0, -0.6, 0.8}});
  state.h = Vector::Zero(4);
  complex.anchors = Points::Zero(4, 3);
  const double t = 0.1;
  const ParallelOffset offset = parallel_offset(complex, state, t);
  ASSERT_EQ(offset.blunted.size(), 1u);
  EXPECT_EQ(offset.blunted[0].point, 3);
  // (0.01, 1) . m = 0.01 / 3 - 1 / 3 and (-0.01, 1) . m = -0.01 / 3 + 1 / 3, but for the part along z.
  const double along = (0.01 / 3 - 1.0 / 3) / 0.01;
  EXPECT_NEAR(offset.blunted[0].wanted_move, t * std::hypot(along, 1.0), 1e-6);
  const Vector3d move = (offset.state.x.row(3) - state.x.row(3)).transpose();
  EXPECT_NEAR(move.z(), t, 1e-14);
  EXPECT_NEAR(move.norm(), kMostMove * t, 1e-14);
  EXPECT_LT(move.x(), 0.0);
  EXPECT_NEAR((offset.state.x.row(4) - state.x.row(4) - t * Eigen::RowVector3d(1.0 / 3, 1.0 / 3, 1)).norm(),
              0.0, 1e-14);
  EXPECT_TRUE(offset.residuals.empty());
}

TEST(ParallelOffset, ReportsWhatIsLeftAtFourPlanes) {
  const Solved design = solved_quads();
  const double t = 0.05;
  const ParallelOffset offset = parallel_offset(*design.complex, design.state, t);
  ASSERT_FALSE(offset.residuals.empty());
  const Vector residuals = incidence_residuals(*design.complex, offset.state);
  Eigen::Index row = 0;
  size_t named = 0;
  for (int j = 0; j < design.complex->point_count(); ++j) {
    const int valence = design.complex->planes_of_point.valence(j);
    const double left = residuals.segment(row, valence).cwiseAbs().maxCoeff();
    row += valence;
    if (named < offset.residuals.size() && offset.residuals[named].point == j) {
      EXPECT_EQ(valence, 4);
      EXPECT_GT(left, 1e-9 * t);
      EXPECT_NEAR(offset.residuals[named++].residual, left, 1e-12);
      // No other place is better in the least squares: the residual is perpendicular to what a move can do.
      Vector3d gradient = Vector3d::Zero();
      const auto planes = design.complex->planes_of_point[j];
      for (int k = 0; k < valence; ++k)
        gradient += residuals[row - valence + k] * design.state.n.row(planes[k]).transpose();
      EXPECT_NEAR(gradient.norm(), 0.0, 1e-11);
    } else {
      EXPECT_LE(left, 2e-9 * t);
    }
  }
  EXPECT_EQ(named, offset.residuals.size());
}

// The planes round the tip of a regular pyramid touch one cone: they meet again.
TEST(ParallelOffset, IsExactAtAConicalCornerOfFourPlanes) {
  const SharedComplex complex = planarize_of(fan(4).mesh());
  const Solved design{complex, initial_state(*complex)};
  const double t = 0.1;
  const ParallelOffset offset = parallel_offset(*complex, design.state, t);
  EXPECT_TRUE(offset.residuals.empty());
  EXPECT_TRUE(offset.blunted.empty());
  EXPECT_EQ(complex->planes_of_point.valence(0), 4);
  EXPECT_NEAR((move_of(design, offset, 0) - Vector3d(0, 0, t / design.state.n(0, 2))).norm(), 0.0, 1e-14);
  EXPECT_LE(largest_edge_angle(design, offset), 1e-12);
}

}  // namespace
}  // namespace planewright
