// Edge length and diagonal length: which pairs, at which lengths, with which derivatives.
#include <gtest/gtest.h>

#include <set>

#include "core/problem/energies/diagonal_length_energy.h"
#include "core/problem/energies/edge_length_energy.h"
#include "energy_rows.h"

namespace planewright {
namespace {

using namespace test;

Layout layout_of(const TangentComplex& complex) {
  return {complex.point_count(), complex.plane_count(), Freedom::NormalsAndOffsets};
}

// The pairs of points that an energy's rows touch.
std::multiset<std::pair<int, int>> pairs(const Energy& energy, const Layout& layout) {
  std::multiset<std::pair<int, int>> result;
  for (int row = 0; row < energy.rows(); ++row) {
    const auto variables = stencil(energy, row);
    EXPECT_EQ(variables.size(), 6u);
    const int a = variables[0] / 3, b = variables[3] / 3;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(variables[static_cast<size_t>(axis)], layout.x(a, axis));
      EXPECT_EQ(variables[static_cast<size_t>(3 + axis)], layout.x(b, axis));
    }
    result.insert({std::min(a, b), std::max(a, b)});
  }
  return result;
}

TEST(EdgeLengthEnergy, HasATermPerPanelEdge) {
  const TangentComplex complex = build_planarize(mixed_polygons().mesh()).value();
  const Layout layout = layout_of(complex);
  const auto energy = make_edge_length_energy({complex, layout});
  EXPECT_EQ(energy->name(), "edge-length");
  EXPECT_EQ(energy->terms(), 14);
  EXPECT_EQ(energy->rows(), 14);
  EXPECT_EQ(pairs(*energy, layout), (std::multiset<std::pair<int, int>>{{0, 1},
                                                                        {1, 2},
                                                                        {2, 3},
                                                                        {0, 3},
                                                                        {2, 4},
                                                                        {3, 4},
                                                                        {1, 6},
                                                                        {5, 6},
                                                                        {4, 5},
                                                                        {5, 10},
                                                                        {9, 10},
                                                                        {8, 9},
                                                                        {7, 8},
                                                                        {3, 7}}))
      << "an edge of two panels is one";
}

TEST(DiagonalLengthEnergy, TakesEverySecondCornerOfEachPanel) {
  const TangentComplex complex = build_planarize(mixed_polygons().mesh()).value();
  const Layout layout = layout_of(complex);
  const auto energy = make_diagonal_length_energy({complex, layout});
  EXPECT_EQ(energy->name(), "diagonal-length");
  EXPECT_EQ(pairs(*energy, layout), (std::multiset<std::pair<int, int>>{{0, 2},
                                                                        {1, 3},  // the quad's
                                                                        {2, 6},
                                                                        {1, 5},
                                                                        {4, 6},
                                                                        {2, 5},
                                                                        {1, 4},  // the pentagon's
                                                                        {3, 5},
                                                                        {4, 10},
                                                                        {5, 9},
                                                                        {8, 10},
                                                                        {7, 9},
                                                                        {3, 8},
                                                                        {4, 7}}))  // the heptagon's
      << "none of the triangle";
  EXPECT_EQ(energy->terms(), 14);
}

TEST(DiagonalLengthEnergy, HasNoneOnTriangles) {
  const TangentComplex complex = build_planarize(octahedron().mesh()).value();
  const Layout layout = layout_of(complex);
  const auto energy = make_diagonal_length_energy({complex, layout});
  EXPECT_EQ(energy->rows(), 0);
  EXPECT_EQ(energy->terms(), 0);
  // No terms: no contribution, and nothing is divided by 0.
  const auto problem = problem_of(planarize_of(octahedron().mesh()), {{"diagonal-length", 2.0}});
  EXPECT_EQ(objective(*problem, perturbed(problem->complex(), 0.2)), 0.0);
}

// Two quads that share two edges, round a point of valence 2, share the diagonal between their other ends.
TEST(DiagonalLengthEnergy, CountsASharedDiagonalOnce) {
  const Shape shape{make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0.3}}),
                    {{0, 1, 2, 4}, {0, 4, 2, 3}}};
  const TangentComplex complex = build_planarize(shape.mesh()).value();
  const Layout layout = layout_of(complex);
  EXPECT_EQ(pairs(*make_diagonal_length_energy({complex, layout}), layout),
            (std::multiset<std::pair<int, int>>{{0, 2}, {1, 4}, {3, 4}}));
}

// (s^2 - L^2) / (2 L) by hand, with slope and curvature.
TEST(LengthEnergies, MeasureTheChangeOfLength) {
  Shape shape = grid(1, 1);
  shape.positions.row(1) << 2, 0, 0;
  shape.positions.row(3) << 2, 1, 0;  // a rectangle, 2 x 1
  TangentComplex complex = build_planarize(shape.mesh()).value();
  const Layout layout = layout_of(complex);
  const auto edges = make_edge_length_energy({complex, layout}),
             diagonals = make_diagonal_length_energy({complex, layout});
  Vector z = Vector::Zero(layout.size());
  const Vector3d a(0.5, -1, 2), b(0.5 + 2, -1 + 3, 2 + 6);  // 7 apart
  for (const auto& [energy, lengths] :
       {std::pair{edges.get(), std::vector{2.0, 1.0, 1.0, 2.0}},
        std::pair{diagonals.get(), std::vector{std::sqrt(5), std::sqrt(5)}}}) {
    ASSERT_EQ(energy->rows(), static_cast<int>(lengths.size()));
    double sum = 0.0, expected_sum = 0.0;
    for (int row = 0; row < energy->rows(); ++row) {
      const auto variables = stencil(*energy, row);
      z.segment<3>(variables[0]) = a;
      z.segment<3>(variables[3]) = b;
      const double length =
          (complex.preferred.row(variables[0] / 3) - complex.preferred.row(variables[3] / 3)).norm();
      EXPECT_DOUBLE_EQ(value(*energy, row, z), (49.0 - length * length) / (2.0 * length));
      Vector expected(6);
      expected << (a - b) / length, (b - a) / length;
      EXPECT_NEAR((slope(*energy, row, z) - expected).norm(), 0.0, 1e-14);
      const auto bent = energy->curvature(row);
      ASSERT_EQ(bent.size(), 9u);
      std::vector<double> bend(bent.size(), 1e9);
      energy->evaluate(row, gather(*energy, row, z).data(), nullptr, bend.data());
      Eigen::MatrixXd full = Eigen::MatrixXd::Zero(6, 6), wanted = full;
      for (size_t k = 0; k < bent.size(); ++k) {
        EXPECT_GE(bent[k].first, bent[k].second);
        full(bent[k].first, bent[k].second) += bend[k];
      }
      for (int axis = 0; axis < 3; ++axis) {
        wanted(axis, axis) = wanted(3 + axis, 3 + axis) = 1.0 / length;
        wanted(3 + axis, axis) = -1.0 / length;
      }
      EXPECT_NEAR((full - wanted).norm(), 0.0, 1e-14);
      sum += length;
      expected_sum += lengths[static_cast<size_t>(row)];
    }
    EXPECT_DOUBLE_EQ(sum, expected_sum);
  }
}

TEST(LengthEnergies, AreZeroAtTheWantedPositionsAndUnderMotions) {
  const TangentComplex complex = build_planarize(mixed_polygons().mesh()).value();
  const Layout layout = layout_of(complex);
  State state = initial_state(complex);
  for (auto make : {make_edge_length_energy, make_diagonal_length_energy}) {
    const auto energy = make({complex, layout});
    EXPECT_NEAR(mean_square(*energy, unknowns(layout, state)), 0.0, 1e-28);
    State moved = state;
    moved.x.col(0) = -state.x.col(1);  // a quarter turn
    moved.x.col(1) = state.x.col(0);
    moved.x.col(2).array() += 3.0;
    EXPECT_NEAR(mean_square(*energy, unknowns(layout, moved)), 0.0, 1e-28);
    // To first order a length's change: 1 % longer edges of length L give L / 100.
    moved.x = 1.01 * state.x;
    double expected = 0.0;
    for (int row = 0; row < energy->rows(); ++row) {
      const auto variables = stencil(*energy, row);
      const double length = (state.x.row(variables[0] / 3) - state.x.row(variables[3] / 3)).norm();
      expected += std::pow(0.01005 * length, 2);
    }
    EXPECT_NEAR(mean_square(*energy, unknowns(layout, moved)), expected / energy->terms(), 1e-12);
  }
}

// Points that should coincide: L is 1e-3, nothing is divided by 0.
TEST(LengthEnergies, FloorTheReferenceLength) {
  TangentComplex complex = build_planarize(grid(1, 1).mesh()).value();
  complex.preferred.row(1) = complex.preferred.row(0);
  const Layout layout = layout_of(complex);
  const auto energy = make_edge_length_energy({complex, layout});
  Vector z = unknowns(layout, initial_state(complex));
  const auto row_of_edge = [&] {
    for (int row = 0; row < energy->rows(); ++row)
      if (std::set{stencil(*energy, row)[0] / 3, stencil(*energy, row)[3] / 3} == std::set{0, 1}) return row;
    return -1;
  }();
  ASSERT_GE(row_of_edge, 0);
  EXPECT_DOUBLE_EQ(value(*energy, row_of_edge, z), -0.5e-3);
  z[layout.x(1, 0)] += 0.1;
  EXPECT_NEAR(value(*energy, row_of_edge, z), (0.01 - 1e-6) / 2e-3, 1e-12);
}

}  // namespace
}  // namespace planewright
