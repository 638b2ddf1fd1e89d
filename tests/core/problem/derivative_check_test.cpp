// Every derivative of every problem we can state, against differences: several meshes, all stages of freedom,
// several weights, and states where something degenerates.
#include "core/problem/derivative_check.h"

#include <gtest/gtest.h>

#include "support/problems.h"

namespace planewright {
namespace {

using namespace test;

enum class Place { Start, Perturbed, Far, CoincidentPoints, ZeroLengthEdge, FlatPlane, LongNormals };
const char* name(Place place) {
  switch (place) {
    case Place::Start:
      return "start";
    case Place::Perturbed:
      return "perturbed";
    case Place::Far:
      return "far";
    case Place::CoincidentPoints:
      return "coincident_points";
    case Place::ZeroLengthEdge:
      return "zero_length_edge";
    case Place::FlatPlane:
      return "flat_plane";
    case Place::LongNormals:
      return "long_normals";
  }
  return "";
}
constexpr Place kPlaces[] = {
    Place::Start,          Place::Perturbed, Place::Far,        Place::CoincidentPoints,
    Place::ZeroLengthEdge, Place::FlatPlane, Place::LongNormals};

Vector at(Place place, const Problem& problem) {
  const TangentComplex& complex = problem.complex();
  State state = initial_state(complex);
  switch (place) {
    case Place::Start:
      break;
    case Place::Perturbed:
      state = perturbed(complex, 0.2);
      break;
    case Place::Far:
      state = perturbed(complex, 5.0);
      break;
    case Place::CoincidentPoints:
      state.x.rowwise() = Eigen::RowVector3d(state.x.row(0));
      break;
    case Place::ZeroLengthEdge:
      state = perturbed(complex, 0.1);
      state.x.row(complex.panel_edges[0].a) = state.x.row(complex.panel_edges[0].b);
      break;
    case Place::FlatPlane:
      state.x.col(2).setZero();
      state.n.rowwise() = Eigen::RowVector3d(0, 0, 1);
      state.h.setZero();
      break;
    case Place::LongNormals:
      state = perturbed(complex, 0.1);
      state.n *= 3.0;
      break;
  }
  return problem.from_state(state);
}

using Weights = std::map<std::string, double>;
const std::vector<Weights> kWeights = {
    {{"position", 1.0}}, {{"fairing", 1.0}}, {{"position", 0.3}, {"fairing", 7.0}}, {}};

class Derivatives : public testing::TestWithParam<int> {};

TEST_P(Derivatives, AgreeWithDifferences) {
  const NamedComplex named = small_complexes()[static_cast<size_t>(GetParam())];
  for (const Freedom freedom : {Freedom::NormalsAndOffsets, Freedom::Normals, Freedom::Fixed})
    for (const Weights& weights : kWeights) {
      const auto problem = Problem::create(named.complex, {freedom, weights});
      if (!problem) {
        // Planes that have no common point: valence 4 and more, fixed. Tested in
        // fixed_planes_constraint_test.
        EXPECT_EQ(freedom, Freedom::Fixed);
        continue;
      }
      for (const Place place : kPlaces) {
        SCOPED_TRACE(named.name + " " + name(place) + " freedom " +
                     std::to_string(static_cast<int>(freedom)) + " energies " +
                     std::to_string(weights.size()));
        const Vector z = at(place, **problem);
        const DerivativeCheck check = check_derivatives(**problem, z);
        EXPECT_LT(check.gradient_error, 1e-6) << check.worst;
        EXPECT_LT(check.jacobian_error, 1e-8) << check.worst;
        EXPECT_LT(check.hessian_error, 1e-6) << check.worst;
        EXPECT_GT(check.jacobian_norm, 0.1);
        if (!weights.empty()) {
          EXPECT_GT(check.hessian_norm, 0.1);
          // The start is the minimum of the position energy alone.
          const bool at_minimum = place == Place::Start && !weights.contains("fairing");
          const bool no_slope = place == Place::CoincidentPoints && !weights.contains("position");
          if (at_minimum || no_slope) {
            EXPECT_LT(check.gradient_norm, 1e-12);
          } else {
            EXPECT_GT(check.gradient_norm, 1e-4);
          }
        } else {
          EXPECT_EQ(check.gradient_norm, 0.0);
          // The constraints' own curvature; fixed planes have none.
          if (freedom == Freedom::Fixed) {
            EXPECT_EQ(check.hessian_norm, 0.0);
          } else {
            EXPECT_GT(check.hessian_norm, 0.1);
          }
        }
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Derivatives, testing::Range(0, static_cast<int>(small_complexes().size())),
                         [](const auto& mesh) {
                           return small_complexes()[static_cast<size_t>(mesh.param)].name;
                         });

// The check itself: norms are those of the analytic derivatives.
TEST(DerivativeCheck, ReportsNorms) {
  const auto problem = problem_of(planarize_of(grid(1, 1).mesh()), {{"position", 2.0}});
  State state = initial_state(problem->complex());
  state.x(2, 1) += 0.75;
  const DerivativeCheck check = check_derivatives(*problem, problem->from_state(state));
  EXPECT_DOUBLE_EQ(check.gradient_norm, 2.0 * 2.0 * 0.75);
  EXPECT_FALSE(check.worst.empty());
}

// Differences of a step that is far too coarse for rounding to matter, but exact for quadratics: any error
// would be one of the derivatives.
TEST(DerivativeCheck, IsExactForQuadraticsAtAnyStep) {
  const auto problem =
      problem_of(planarize_of(twisted_grid(2, 2).mesh()), {{"position", 1.0}, {"fairing", 0.5}});
  const DerivativeCheck check = check_derivatives(*problem, at(Place::Perturbed, *problem), 0.5);
  EXPECT_LT(check.gradient_error, 1e-12);
  EXPECT_LT(check.hessian_error, 1e-12);
  EXPECT_LT(check.jacobian_error, 1e-12);
}

}  // namespace
}  // namespace planewright
