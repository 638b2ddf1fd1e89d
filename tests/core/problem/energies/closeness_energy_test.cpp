#include "core/problem/energies/closeness_energy.h"

#include <gtest/gtest.h>

#include "energy_rows.h"

namespace planewright {
namespace {

using namespace test;

SharedProblem closeness_problem(const SharedComplex& complex, const FrozenGeometry& geometry,
                                std::map<std::string, double> weights = {{"closeness", 1.0}}) {
  return Problem::create(complex, {Freedom::NormalsAndOffsets, std::move(weights)}, geometry).value();
}

FrozenGeometry frozen(std::shared_ptr<const ReferenceSurface> reference, const State* at = nullptr) {
  FrozenGeometry geometry;
  geometry.at = at;
  geometry.reference = std::move(reference);
  return geometry;
}

// The plane z = height under the unit grids.
std::shared_ptr<const ReferenceSurface> floor_at(double height) {
  return ReferenceSurface::create(
             make_points({{-9, -9, height}, {20, -9, height}, {20, 20, height}, {-9, 20, height}}),
             {{0, 1, 2, 3}}, "floor")
      .value();
}

TEST(ClosenessEnergy, IsTheSignedDistanceFromTheFrozenFoot) {
  TangentComplex complex = build_planarize(grid(1, 1).mesh(), {0.25}).value();
  const Layout layout{4, 1, Freedom::NormalsAndOffsets};
  FootPoints feet{Points(4, 3), Points(4, 3)};
  feet.foot << 0, 0, 1, 1, 0, 2, 1, 1, 3, 0, 1, 4;
  feet.normal << 0, 0, 1, 0, 1, 0, 0.6, 0, 0.8, 0, 0, -1;
  const auto energy = make_closeness_energy({complex, layout, &feet});
  EXPECT_EQ(energy->name(), "closeness");
  EXPECT_EQ(energy->terms(), 4);
  ASSERT_EQ(energy->rows(), 4);
  const FootPoints kept = feet;
  feet.foot.setConstant(1e9);  // only needed while it is made
  feet.normal.setConstant(1e9);
  const Vector z = unknowns(layout, perturbed(complex, 0.5));
  for (int j = 0; j < 4; ++j) {
    EXPECT_EQ(stencil(*energy, j), (std::vector{layout.x(j, 0), layout.x(j, 1), layout.x(j, 2)}));
    EXPECT_TRUE(energy->curvature(j).empty());
    const Vector3d x = z.segment<3>(layout.x(j)), foot = kept.foot.row(j), normal = kept.normal.row(j);
    EXPECT_NEAR(value(*energy, j, z), normal.dot(x - foot) - 0.25, 1e-14);
    EXPECT_NEAR((slope(*energy, j, z) - normal).norm(), 0.0, 0.0);
  }
}

TEST(ClosenessEnergy, TakesTheOffsetOfAPointFromItsPlanes) {
  TangentComplex complex = build_planarize(grid(2, 1).mesh()).value();
  complex.offsets << 0.5, 0.1;
  const Layout layout{6, 2, Freedom::NormalsAndOffsets};
  FootPoints feet{Points::Zero(6, 3), Points::Zero(6, 3)};
  feet.normal.col(2).setOnes();
  const auto energy = make_closeness_energy({complex, layout, &feet});
  const Vector z = Vector::Zero(layout.size());
  EXPECT_DOUBLE_EQ(value(*energy, 0, z), -0.5);
  EXPECT_DOUBLE_EQ(value(*energy, 1, z), -0.3);  // on both
  EXPECT_DOUBLE_EQ(value(*energy, 2, z), -0.1);
}

// Model units in, mean edges out, whatever the scale, the place and the frame of the reference.
TEST(ClosenessEnergy, MeasuresInEdgesFromTheReference) {
  Shape shape = grid(2, 2);
  shape.positions *= 4.0;
  for (const double offset : {0.0, 1.0, -2.0}) {
    const SharedComplex complex = planarize_of(shape.mesh(), {offset});
    const auto reference = floor_at(-3.0);
    const auto problem = closeness_problem(complex, frozen(reference));
    // Points lie at z = offset, 3 + offset over the floor: 3 more than they should be, 0.75 edges.
    EXPECT_NEAR(objective(*problem, initial_state(*complex)), 9 * 0.75 * 0.75, 1e-12);
    State state = initial_state(*complex);
    state.x.col(0).array() += 0.7;  // slides
    EXPECT_NEAR(objective(*problem, state), 9 * 0.75 * 0.75, 1e-12);
    state.x.col(2).array() -= 3.0;
    EXPECT_NEAR(objective(*problem, state), 0.0, 1e-24);
    const Vector slope = gradient(*problem, problem->from_state(initial_state(*complex)));
    EXPECT_NEAR(slope[problem->layout().x(4, 2)], 2 * 0.75, 1e-13);
    EXPECT_EQ(slope[problem->layout().x(4, 0)], 0.0);
  }
}

TEST(ClosenessEnergy, RefersToTheMeshItselfWithoutAReference) {
  // At the mesh's own offset from itself, outside and inside.
  for (const double offset : {0.0, 0.05, -0.05}) {
    const SharedComplex complex = dual_of(make_torus(16, 32), {offset});
    const auto problem = closeness_problem(complex, {});
    // Points are preferred at the faces' centroids, moved along their normals.
    EXPECT_NEAR(objective(*problem, initial_state(*complex)), 0.0, 1e-20) << offset;
    State state = initial_state(*complex);
    for (int j = 0; j < complex->point_count(); ++j)
      state.x.row(j) += 0.1 * complex->mean_edge * complex->input.face_normals.row(complex->face_of_point[j]);
    EXPECT_NEAR(objective(*problem, state), 0.01 * complex->point_count(), 1e-9) << offset;
  }
}

TEST(ClosenessEnergy, TakesFeetWhereTheFrozenStateIs) {
  // A roof of two slopes: over one slope or the other, the distance grows along other normals.
  const auto roof = ReferenceSurface::create(
                        make_points({{0, 0, 0}, {2, 0, 2}, {4, 0, 0}, {0, 9, 0}, {2, 9, 2}, {4, 9, 0}}),
                        {{0, 1, 4, 3}, {1, 2, 5, 4}}, "roof")
                        .value();
  const SharedComplex complex = planarize_of(grid(1, 1).mesh());
  State at = initial_state(*complex);
  const Vector3d left(1, 4, 3), right(3, 4, 3);
  for (const auto& [place, lean] : {std::pair{left, -1.0}, {right, 1.0}}) {
    at.x.rowwise() = (place - complex->origin).transpose();
    const auto problem = closeness_problem(complex, frozen(roof, &at));
    const Vector slope = gradient(*problem, problem->from_state(at));
    const Vector3d direction(lean * std::sqrt(0.5), 0, std::sqrt(0.5));
    EXPECT_NEAR((slope.segment<3>(problem->layout().x(2)) - 2 * std::sqrt(2.0) * direction).norm(), 0.0,
                1e-12);
  }
}

TEST(ClosenessEnergy, NeedsNoFeetWithoutAWeight) {
  const SharedComplex complex = planarize_of(grid(1, 1).mesh());
  State broken = initial_state(*complex);
  broken.x.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(Problem::create(complex, {Freedom::Normals, {{"closeness", 0.0}}}, frozen(nullptr, &broken)));
  const auto refused =
      Problem::create(complex, {Freedom::Normals, {{"closeness", 1.0}}}, frozen(nullptr, &broken));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Refused);
}

}  // namespace
}  // namespace planewright
