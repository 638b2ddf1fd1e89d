#include "core/complex/explicit_intersection.h"

#include <gtest/gtest.h>

#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

TEST(ExplicitIntersection, OfAnOctahedronIsTheCube) {
  const Shape shape = octahedron();
  const TangentComplex complex = build_dual(shape.mesh()).value();
  const TpiResult result = explicit_intersection(complex);
  EXPECT_TRUE(result.failed.empty());
  for (int f = 0; f < 8; ++f) {
    // The face of the octant (+,+,+) gives the corner (1, 1, 1), and so on.
    const Vector3d corner = (3.0 * centroid(shape.positions, shape.faces[f])).array().round();
    EXPECT_NEAR((result.state.x.row(f).transpose() - corner).norm(), 0.0, 1e-14) << f;
  }
  EXPECT_LE(off_plane(complex, result.state), 1e-15);
}

// Planes tangent to a sphere: x = r^2 n / (n . v), n the face's normal, v one of its corners.
TEST(ExplicitIntersection, OfASphereIsItsExactDual) {
  const double radius = 2.5, offset = 0.2;
  const Shape shape = icosahedron(radius);
  const TangentComplex complex = build_dual(shape.mesh(), {offset}).value();
  const TpiResult result = explicit_intersection(complex);
  EXPECT_TRUE(result.failed.empty());
  for (int f = 0; f < 20; ++f) {
    const Vector3d n = newell_vector(shape.positions, shape.faces[f]).normalized();
    const double cosine = n.dot(shape.positions.row(shape.faces[f][0])) / radius;
    EXPECT_NEAR((result.state.x.row(f).transpose() - n * ((radius + offset) / cosine)).norm(), 0.0, 1e-14);
  }
  // Planes stay as they were.
  EXPECT_TRUE(same_bits(result.state.n, complex.normals));
  EXPECT_TRUE(same_bits(result.state.h, complex.offsets));
}

TEST(ExplicitIntersection, NamesTooFewPlanes) {
  const TangentComplex complex = build_dual(fan(5).mesh()).value();
  const TpiResult result = explicit_intersection(complex);
  // Every point of the outline: 5 border edges, 5 corners.
  ASSERT_EQ(result.failed.size(), 10u);
  int before = -1;
  for (const auto& failed : result.failed) {
    EXPECT_EQ(failed.why, TpiFailure::TooFewPlanes);
    EXPECT_LT(complex.planes_of_point.valence(failed.point), 3);
    EXPECT_GT(failed.point, before);
    before = failed.point;
    EXPECT_EQ(result.state.x.row(failed.point), complex.preferred.row(failed.point));
  }
}

TEST(ExplicitIntersection, NamesParallelPlanes) {
  const TangentComplex complex = build_dual(triangle_grid(3, 3).mesh()).value();
  const TpiResult result = explicit_intersection(complex);
  int parallel = 0;
  for (const auto& failed : result.failed) {
    if (complex.planes_of_point.valence(failed.point) < 3) continue;
    ++parallel;
    EXPECT_EQ(failed.why, TpiFailure::Parallel);
    EXPECT_LT(failed.smallest_singular_value, 1e-6);
    EXPECT_EQ(result.state.x.row(failed.point), complex.preferred.row(failed.point));
  }
  EXPECT_EQ(parallel, 18);  // each face of the flat grid
}

// A cylinder's planes are parallel to its axis: two directions determined, the third not.
TEST(ExplicitIntersection, NamesPlanesThatMeetInALine) {
  Shape shape = triangle_grid(3, 3);
  for (Eigen::Index v = 0; v < shape.positions.rows(); ++v)
    shape.positions(v, 2) = -0.2 * shape.positions(v, 0) * shape.positions(v, 0);
  TangentComplex complex = build_dual(shape.mesh()).value();
  for (int i = 0; i < complex.plane_count(); ++i) {
    const double x = complex.anchors(i, 0) + complex.origin.x();
    complex.normals.row(i) = Eigen::RowVector3d(0.4 * x, 0, 1).normalized();
  }
  const TpiResult result = explicit_intersection(complex);
  for (const auto& failed : result.failed) EXPECT_NE(failed.why, TpiFailure::Overdetermined);
  const auto count = std::count_if(result.failed.begin(), result.failed.end(),
                                   [](const auto& f) { return f.why == TpiFailure::Parallel; });
  EXPECT_EQ(count, 18);
}

TEST(ExplicitIntersection, NamesOverdeterminedPoints) {
  const TangentComplex complex = build_planarize(twisted_grid(3, 3).mesh()).value();
  const TpiResult result = explicit_intersection(complex);
  int overdetermined = 0;
  for (const auto& failed : result.failed) {
    if (complex.planes_of_point.valence(failed.point) < 4) continue;
    ++overdetermined;
    EXPECT_EQ(failed.why, TpiFailure::Overdetermined);
    EXPECT_GT(failed.residual, 1e-9);
    EXPECT_GT(failed.smallest_singular_value, 1e-6);
    EXPECT_EQ(result.state.x.row(failed.point), complex.preferred.row(failed.point));
  }
  EXPECT_EQ(overdetermined, 4);  // the inner vertices
}

// Four planes that do have a common point are as good as three.
TEST(ExplicitIntersection, TakesFourPlanesThatAgree) {
  const TangentComplex complex = build_dual(cube().mesh()).value();
  const TpiResult result = explicit_intersection(complex);
  EXPECT_TRUE(result.failed.empty());
  // About the cube's middle, the planes of the upper corners meet above it at three halves.
  EXPECT_NEAR((result.state.x.row(1) - Eigen::RowVector3d(0, 0, 1.5)).norm(), 0.0, 1e-14);
}

TEST(ExplicitIntersection, FailuresHaveNames) {
  EXPECT_STREQ(name(TpiFailure::TooFewPlanes), "fewer than three planes");
  EXPECT_NE(std::string(name(TpiFailure::Parallel)).find("parallel"), std::string::npos);
  EXPECT_NE(std::string(name(TpiFailure::Overdetermined)).find("more than three"), std::string::npos);
}

}  // namespace
}  // namespace planewright
