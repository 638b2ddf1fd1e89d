#include "core/complex/planarize.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

TEST(Planarize, HasAPlanePerFaceAndAPointPerVertex) {
  const PolygonMesh mesh = twisted_grid(3, 2).mesh();
  const TangentComplex complex = build_planarize(mesh).value();
  EXPECT_EQ(complex.kind, ComplexKind::Planarize);
  ASSERT_EQ(complex.plane_count(), 6);
  ASSERT_EQ(complex.point_count(), 12);
  EXPECT_EQ(complex.incidence_count(), 24);
  EXPECT_EQ(complex.panels, mesh.faces());
  const Polygons faces = mesh.faces();
  for (int f = 0; f < 6; ++f) {
    EXPECT_EQ(complex.plane_origin[f], f);
    EXPECT_NEAR(
        (complex.anchors.row(f).transpose() + complex.origin - centroid(mesh.positions(), faces[f])).norm(),
        0.0, 1e-15);
    EXPECT_NEAR(
        (complex.normals.row(f).transpose() - newell_vector(mesh.positions(), faces[f]).normalized()).norm(),
        0.0, 1e-15);
    EXPECT_EQ(complex.offsets[f], 0.0);
  }
  for (int v = 0; v < 12; ++v) {
    EXPECT_EQ(complex.point_origin[v], (PointOrigin{PointKind::Vertex, v}));
    EXPECT_EQ(complex.preferred.row(v) + complex.origin.transpose(), mesh.positions().row(v));
    std::vector<int> around = mesh.faces_around(v);
    std::sort(around.begin(), around.end());
    const auto planes = complex.planes_of_point[v];
    EXPECT_EQ(std::vector<int>(planes.begin(), planes.end()), around);
  }
  EXPECT_EQ(complex.panel_edges.size(), static_cast<size_t>(mesh.edge_count()));
}

TEST(Planarize, TakesFacesOfAnyValence) {
  // A triangle, a quad and a pentagon round one vertex.
  const Shape shape{
      make_points(
          {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {-1, 2, 1}, {-2, 0, 0}, {-2, -2, 0}, {0, -3, 1}, {2, -2, 0}}),
      {{0, 1, 2}, {0, 2, 3, 4}, {0, 4, 5, 6, 7}}};
  const TangentComplex complex = build_planarize(shape.mesh()).value();
  EXPECT_EQ(complex.panels.valence(0), 3);
  EXPECT_EQ(complex.panels.valence(1), 4);
  EXPECT_EQ(complex.panels.valence(2), 5);
  EXPECT_EQ(complex.planes_of_point.valence(0), 3);
  EXPECT_EQ(complex.planes_of_point.valence(1), 1);
  EXPECT_EQ(complex.planes_of_point.valence(2), 2);
  for (int i = 0; i < 3; ++i)
    EXPECT_GT(newell_vector(complex.preferred, complex.panels[i]).dot(complex.normals.row(i)), 0.0);
}

TEST(Planarize, OffsetMovesPointsAndPlanesAlongTheNormals) {
  for (const double offset : {0.5, -0.25}) {
    const TangentComplex complex = build_planarize(grid(2, 2).mesh(), {offset}).value();
    for (int j = 0; j < 9; ++j) EXPECT_DOUBLE_EQ(complex.preferred(j, 2) + complex.origin.z(), offset);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(complex.offsets[i], offset);
    EXPECT_NEAR(incidence_residuals(complex, initial_state(complex)).cwiseAbs().maxCoeff(), 0.0, 1e-15);
  }
}

TEST(Planarize, LeavesOutIsolatedVertices) {
  const Shape shape{make_points({{50, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}}), {{1, 2, 3, 4}}};
  const TangentComplex complex = build_planarize(shape.mesh()).value();
  ASSERT_EQ(complex.point_count(), 4);
  EXPECT_EQ(complex.point_origin[0], (PointOrigin{PointKind::Vertex, 1}));
  EXPECT_EQ(complex.panels, (Polygons{{0, 1, 2, 3}}));
  EXPECT_EQ(complex.origin, Vector3d(0.5, 0.5, 0.25));
}

TEST(Planarize, FacesWithoutAreaGetAUnitNormal) {
  const Shape shape{make_points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 2, 0}}),
                    {{0, 1, 2, 3}, {0, 3, 4}}};
  const TangentComplex complex = build_planarize(shape.mesh()).value();
  EXPECT_TRUE(all_finite(complex));
  EXPECT_NEAR((complex.normals.row(0) - Eigen::RowVector3d(0, 0, 1)).norm(), 0.0, 1e-15);
}

TEST(Planarize, RefusesAMeshWithoutFaces) {
  const auto complex = build_planarize(PolygonMesh());
  ASSERT_FALSE(complex);
  EXPECT_EQ(complex.error().code, ErrorCode::Refused);
}

TEST(Planarize, RefusesAnOffsetThatIsNoNumber) {
  const auto complex = build_planarize(cube().mesh(), {std::numeric_limits<double>::quiet_NaN()});
  ASSERT_FALSE(complex);
  EXPECT_EQ(complex.error().code, ErrorCode::Usage);
}

TEST(Planarize, IsTheSameFarFromTheOrigin) {
  Shape shape = twisted_grid(3, 3);
  shape.positions = (shape.positions * 1024.0).array().round() / 1024.0;
  const TangentComplex near = build_planarize(shape.mesh()).value();
  const Vector3d shift(-(1 << 21), 1 << 20, 1 << 22);
  shape.positions.rowwise() += shift.transpose();
  const TangentComplex far = build_planarize(shape.mesh()).value();
  EXPECT_EQ(far.origin, near.origin + shift);
  EXPECT_TRUE(same_bits(far.anchors, near.anchors));
  EXPECT_TRUE(same_bits(far.normals, near.normals));
  EXPECT_TRUE(same_bits(far.preferred, near.preferred));
}

}  // namespace
}  // namespace planewright
