// Each energy's rows by hand: what they touch, their values, their slopes.
#include "core/problem/energies/energy_catalogue.h"

#include <gtest/gtest.h>

#include "core/problem/energies/fairing_energy.h"
#include "core/problem/energies/position_energy.h"
#include "support/problems.h"

namespace planewright {
namespace {

using namespace test;

TEST(PositionEnergy, HasARowPerCoordinate) {
  const TangentComplex complex = build_planarize(grid(2, 1).mesh()).value();
  const Layout layout{complex.point_count(), complex.plane_count(), Freedom::NormalsAndOffsets};
  const auto energy = make_position_energy({complex, layout});
  EXPECT_EQ(energy->terms(), 6);
  ASSERT_EQ(energy->rows(), 18);
  for (int j = 0; j < 6; ++j)
    for (int c = 0; c < 3; ++c) {
      const int row = 3 * j + c;
      ASSERT_EQ(energy->stencil(row).size(), 1u);
      EXPECT_EQ(energy->stencil(row)[0], layout.x(j, c));
      EXPECT_TRUE(energy->curvature(row).empty());
      const double x = 7.0;
      double slope = 0.0;
      EXPECT_EQ(energy->evaluate(row, &x, &slope, nullptr), 7.0 - complex.preferred(j, c));
      EXPECT_EQ(slope, 1.0);
    }
}

TEST(PositionEnergy, PullsTowardsTheWantedPoint) {
  const auto problem = problem_of(planarize_of(grid(2, 2).mesh()), {{"position", 1.5}});
  State state = initial_state(problem->complex());
  state.x.row(5) += Eigen::RowVector3d(0.1, -0.2, 0.3);
  const Vector slope = gradient(*problem, problem->from_state(state));
  Vector expected = Vector::Zero(problem->variables());
  expected.segment<3>(problem->layout().x(5)) = 2.0 * 1.5 * Vector3d(0.1, -0.2, 0.3);
  EXPECT_NEAR((slope - expected).norm(), 0.0, 1e-14);
}

// 6-7-8
// 3-4-5
// 0-1-2
TEST(FairingEnergy, ComparesWithTheMeanOfTheNeighbours) {
  const TangentComplex complex = build_planarize(grid(2, 2).mesh()).value();
  const Layout layout{9, 4, Freedom::NormalsAndOffsets};
  const auto energy = make_fairing_energy({complex, layout});
  EXPECT_EQ(energy->terms(), 9);
  ASSERT_EQ(energy->rows(), 27);
  const auto stencil = energy->stencil(3 * 4 + 1);  // y of the middle
  EXPECT_EQ(std::vector<int>(stencil.begin(), stencil.end()),
            (std::vector{layout.x(4, 1), layout.x(1, 1), layout.x(3, 1), layout.x(5, 1), layout.x(7, 1)}));
  const double y[] = {10.0, 1.0, 2.0, 3.0, 6.0};
  double slope[5];
  EXPECT_DOUBLE_EQ(energy->evaluate(3 * 4 + 1, y, slope, nullptr), 7.0);
  EXPECT_EQ(slope[0], 1.0);
  for (int k = 1; k < 5; ++k) EXPECT_DOUBLE_EQ(slope[k], -0.25);
}

TEST(FairingEnergy, OfTheOutlineDoesNotPullItInwards) {
  const SharedComplex complex = planarize_of(grid(2, 2).mesh());
  const auto problem = problem_of(complex, {{"fairing", 1.0}});
  // The middle moves: only its own term changes, no border point's.
  State state = initial_state(*complex);
  const double before = objective(*problem, state);
  EXPECT_DOUBLE_EQ(before, 4 * 0.5);  // the corners of the outline
  state.x(4, 2) += 2.0;
  EXPECT_DOUBLE_EQ(objective(*problem, state) - before, 4.0);
  // The middle of a side moves inwards by d: its own term d^2, two corners' terms (1/2 -+ d/2)^2 ..., and the
  // middle's (d/4)^2.
  state = initial_state(*complex);
  const double d = 0.5;
  state.x(1, 1) += d;
  // Corner 0 = (0, 0) against the mean of 1 = (1, d) and 3 = (0, 1): (-1/2, -(1 + d)/2); corner 2 alike.
  const double corners = 2 * (0.25 + 0.25 * (1 + d) * (1 + d)) + 2 * 0.5;
  EXPECT_DOUBLE_EQ(objective(*problem, state), d * d + corners + d * d / 16);
}

TEST(FairingEnergy, IsZeroWhereEveryPointIsTheMeanOfItsNeighbours) {
  const auto problem = problem_of(dual_of(tetrahedron().mesh()), {{"fairing", 1.0}});
  State state = initial_state(problem->complex());
  EXPECT_GT(objective(*problem, state), 0.1);
  state.x.setConstant(3.0);
  EXPECT_NEAR(objective(*problem, state), 0.0, 1e-25);
}

TEST(FindEnergy, NamesTheKnownOnes) {
  const auto found = find_energy("Position");  // names are exact
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::Usage);
  EXPECT_NE(found.error().remedy.find("position, fairing"), std::string::npos);
}

TEST(EnergyCatalogue, HasEveryEnergyOfThePaperAndOurs) {
  for (const char* name : {"position", "fairing", "edge-length", "diagonal-length", "edge-direction",
                           "normal-smoothness", "proxy-normal", "offset", "closeness", "corner-angle"}) {
    const auto found = find_energy(name);
    ASSERT_TRUE(found) << name;
    EXPECT_EQ((*found)->default_weight, std::string(name) == "position" ? 1.0 : 0.0);
    EXPECT_EQ((*found)->source.empty(),
              std::string(name) == "closeness" || std::string(name) == "corner-angle");
    EXPECT_EQ((*found)->description.back(), '.');
  }
}

}  // namespace
}  // namespace planewright
