#include "core/mesh/health_report.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/mesh/sample_shapes.h"
#include "support/shapes.h"

namespace planewright {
namespace {

using test::cube;
using test::make_points;
using test::Shape;
using test::tetrahedron;

CheckedMesh checked(const Points& positions, const Polygons& faces) {
  auto result = check_and_repair(positions, faces);
  EXPECT_TRUE(result) << result.error().text();
  if (!result) return {};
  EXPECT_EQ(static_cast<int>(result->vertex_origin.size()), result->mesh.vertex_count());
  EXPECT_EQ(static_cast<int>(result->face_origin.size()), result->mesh.face_count());
  for (int v = 0; v < result->mesh.vertex_count(); ++v)
    EXPECT_EQ(result->mesh.positions().row(v), positions.row(result->vertex_origin[v]));
  return std::move(*result);
}

// n x 1 quads along a strip whose ends are joined, with a half turn if `twisted`.
Shape band(int n, bool twisted) {
  Shape shape;
  shape.positions.resize(2 * n, 3);
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * 3.141592653589793 * k / n, turn = twisted ? angle / 2.0 : 0.0;
    for (int side : {-1, 1}) {
      const double across = 0.4 * side;
      shape.positions.row(2 * k + (side + 1) / 2) << (2.0 + across * std::cos(turn)) * std::cos(angle),
          (2.0 + across * std::cos(turn)) * std::sin(angle),
          across * std::sin(turn) + (twisted ? 0.0 : across);
    }
  }
  for (int k = 0; k + 1 < n; ++k) shape.faces.push_back(std::array{2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1});
  const int last = 2 * n - 2;
  if (twisted)
    shape.faces.push_back(std::array{last, 1, 0, last + 1});
  else
    shape.faces.push_back(std::array{last, 0, 1, last + 1});
  return shape;
}

TEST(HealthReport, HealthyMeshesStayAsTheyAre) {
  for (const Shape& shape : {tetrahedron(), cube(), test::grid(4, 3), test::fan(6), band(8, false)}) {
    const CheckedMesh result = checked(shape.positions, shape.faces);
    EXPECT_TRUE(result.health.healthy()) << result.health.summary();
    EXPECT_FALSE(result.health.repaired);
    EXPECT_EQ(result.health.summary(), "healthy");
    EXPECT_EQ(result.mesh.faces(), shape.faces);
    EXPECT_EQ(result.mesh.positions(), shape.positions);
    EXPECT_EQ(result.health.components, 1);
  }
}

TEST(HealthReport, CountsBorder) {
  const CheckedMesh closed = checked(cube().positions, cube().faces);
  EXPECT_EQ(closed.health.border_loops, 0);
  EXPECT_EQ(closed.health.border_edges, 0);
  const Shape ring = band(8, false);
  const CheckedMesh open = checked(ring.positions, ring.faces);
  EXPECT_EQ(open.health.border_loops, 2);
  EXPECT_EQ(open.health.border_edges, 16);
}

TEST(HealthReport, NonManifoldEdgeIsDetached) {
  const Points p = make_points({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}});
  const CheckedMesh result = checked(p, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  const Defect* d = result.health.find(DefectKind::NonManifoldEdge);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->count, 1);
  EXPECT_EQ(d->elements, (std::vector{0, 1}));
  EXPECT_EQ(result.health.find(DefectKind::NonManifoldVertex), nullptr);
  EXPECT_EQ(result.mesh.face_count(), 3);
  EXPECT_EQ(result.mesh.vertex_count(), 9);
  EXPECT_EQ(result.health.components, 3);
  EXPECT_TRUE(result.health.repaired);
}

TEST(HealthReport, SolidsThatTouchAlongAnEdgeStaySolids) {
  // Two cubes with one common edge, at x = y = 1.
  Shape shape = cube();
  Points p(14, 3);
  p.topRows(8) = shape.positions;
  const std::array<std::array<double, 3>, 6> more{
      {{2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}}};
  for (int i = 0; i < 6; ++i) p.row(8 + i) << more[i][0], more[i][1], more[i][2];
  const std::array<int, 8> second{2, 8, 9, 10, 6, 11, 12, 13};
  Polygons faces = shape.faces;
  for (int f = 0; f < 6; ++f) {
    std::vector<int> corners;
    for (int v : shape.faces[f]) corners.push_back(second[v]);
    faces.push_back(corners);
  }
  const CheckedMesh result = checked(p, faces);
  ASSERT_TRUE(result.health.find(DefectKind::NonManifoldEdge));
  EXPECT_EQ(result.mesh.vertex_count(), 16);
  EXPECT_EQ(result.health.components, 2);
  EXPECT_EQ(result.health.border_edges, 0);
}

TEST(HealthReport, NonManifoldVertexIsSplit) {
  const Points p = make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}});
  const CheckedMesh result = checked(p, {{0, 1, 2}, {0, 3, 4}});
  const Defect* d = result.health.find(DefectKind::NonManifoldVertex);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->count, 1);
  EXPECT_EQ(d->elements, std::vector{0});
  EXPECT_EQ(d->action, "split into 2 vertices");
  EXPECT_EQ(result.mesh.vertex_count(), 6);
  EXPECT_EQ(result.vertex_origin[5], 0);
  EXPECT_EQ(result.health.components, 2);
}

TEST(HealthReport, MinorityIsTurnedRound) {
  Shape shape = cube();
  std::reverse(shape.faces[2].begin(), shape.faces[2].end());
  std::reverse(shape.faces[4].begin(), shape.faces[4].end());
  const CheckedMesh result = checked(shape.positions, shape.faces);
  const Defect* d = result.health.find(DefectKind::InconsistentOrientation);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->count, 2);
  EXPECT_EQ(d->elements, (std::vector{2, 4}));
  double volume = 0.0;
  const Polygons faces = result.mesh.faces();
  for (int f = 0; f < faces.size(); ++f)
    volume +=
        newell_vector(result.mesh.positions(), faces[f]).dot(centroid(result.mesh.positions(), faces[f]));
  EXPECT_NEAR(volume / 6.0, 1.0, 1e-12);
  EXPECT_EQ(result.health.border_edges, 0);
}

TEST(HealthReport, EachComponentIsOrientedOnItsOwn) {
  // A second cube that is inside out as a whole is consistent, and stays.
  Shape shape = cube();
  Points p(16, 3);
  p << shape.positions, shape.positions.array() + 5.0;
  Polygons faces = shape.faces;
  for (int f = 0; f < 6; ++f) {
    std::vector<int> corners(shape.faces[f].begin(), shape.faces[f].end());
    for (int& v : corners) v += 8;
    std::reverse(corners.begin(), corners.end());
    faces.push_back(corners);
  }
  const CheckedMesh result = checked(p, faces);
  EXPECT_TRUE(result.health.healthy());
  EXPECT_EQ(result.health.components, 2);
}

TEST(HealthReport, OneSidedIsCutWhereTheFileBreaks) {
  const Shape shape = band(16, true);
  const CheckedMesh result = checked(shape.positions, shape.faces);
  const Defect* d = result.health.find(DefectKind::OneSided);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->count, 1);
  EXPECT_EQ(d->action, "cut open along 1 edge");
  EXPECT_EQ(d->elements, (std::vector{1, 0}));
  EXPECT_EQ(result.health.find(DefectKind::InconsistentOrientation), nullptr);
  EXPECT_EQ(result.mesh.face_count(), 16);
  EXPECT_EQ(result.mesh.vertex_count(), 34);
  EXPECT_EQ(result.health.border_loops, 1);
  EXPECT_EQ(result.health.border_edges, 34);
}

TEST(HealthReport, OneSidedWithMixedOrientationIsCutToo) {
  Shape shape = band(16, true);
  for (int f : {3, 7, 8, 12}) std::reverse(shape.faces[f].begin(), shape.faces[f].end());
  const CheckedMesh result = checked(shape.positions, shape.faces);
  ASSERT_TRUE(result.health.find(DefectKind::OneSided));
  EXPECT_EQ(result.health.components, 1);
  EXPECT_EQ(result.health.border_edges, 34);
}

TEST(HealthReport, RepeatedCornersAreDropped) {
  const Shape shape = cube();
  // Next to each other, and a bow tie that comes back to its second corner.
  const Points p = make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}});
  const CheckedMesh result = checked(p, {{0, 1, 1, 2, 3}, {4, 5, 6, 5}});
  const Defect* d = result.health.find(DefectKind::RepeatedCorner);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->count, 2);
  EXPECT_EQ(d->elements, (std::vector{0, 1}));
  EXPECT_EQ(result.mesh.faces(), (Polygons{{0, 1, 2, 3}, {4, 5, 6}}));
}

TEST(HealthReport, FacesWithoutThreeCornersAreDropped) {
  const CheckedMesh result = checked(tetrahedron().positions, {{0, 1}, {0, 1, 2}, {3, 3, 3}, {}});
  const Defect* d = result.health.find(DefectKind::DegenerateFace);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->count, 3);
  EXPECT_EQ(d->elements, (std::vector{0, 2, 3}));
  EXPECT_EQ(d->action, "dropped");
  EXPECT_EQ(result.face_origin, std::vector{1});
}

TEST(HealthReport, FacesWithoutAreaAreKept) {
  const Points p = make_points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}});
  const CheckedMesh result = checked(p, {{0, 1, 2}, {0, 2, 3}});
  const Defect* d = result.health.find(DefectKind::DegenerateFace);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->elements, std::vector{0});
  EXPECT_EQ(d->action, "kept");
  EXPECT_EQ(result.mesh.face_count(), 2);
  EXPECT_FALSE(result.health.repaired);

  const CheckedMesh both = checked(p, {{0, 1, 2}, {0, 2, 3}, {1, 1, 3}});
  EXPECT_EQ(both.health.find(DefectKind::DegenerateFace)->action, "1 dropped, 1 kept");
  const CheckedMesh one_point = checked(make_points({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), {{0, 1, 2}});
  EXPECT_TRUE(one_point.health.find(DefectKind::DegenerateFace));
}

TEST(HealthReport, DuplicateFacesAreDropped) {
  const Shape shape = cube();
  Polygons faces = shape.faces;
  faces.push_back(std::array{1, 0, 3, 2});  // face 0 from another corner
  faces.push_back(std::array{7, 6, 5, 4});  // face 1 from below
  const CheckedMesh result = checked(shape.positions, faces);
  const Defect* d = result.health.find(DefectKind::DuplicateFace);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->count, 2);
  EXPECT_EQ(d->elements, (std::vector{6, 7}));
  EXPECT_EQ(result.mesh.faces(), shape.faces);
}

TEST(HealthReport, DuplicateAndIsolatedVerticesAreNamed) {
  const Points p = make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {1, 0, 0}});
  const CheckedMesh result = checked(p, {{0, 1, 2}, {3, 2, 1}});
  const Defect* duplicates = result.health.find(DefectKind::DuplicateVertex);
  ASSERT_TRUE(duplicates);
  EXPECT_EQ(duplicates->elements, (std::vector{3, 4}));
  const Defect* isolated = result.health.find(DefectKind::IsolatedVertex);
  ASSERT_TRUE(isolated);
  EXPECT_EQ(isolated->elements, std::vector{4});
  EXPECT_EQ(result.mesh.vertex_count(), 5);
  EXPECT_FALSE(result.health.repaired);
  EXPECT_EQ(result.health.summary(), "2 duplicate vertices (kept), 1 isolated vertex (kept)");
}

TEST(HealthReport, ListsAreCappedButCountsAreWhole) {
  Points p(1003, 3);
  p.setZero();
  p.col(0).setLinSpaced(0.0, 1.0);
  p.row(1) << 0, 1, 0;
  const CheckedMesh result = checked(p, {{0, 1, 2}});
  const Defect* d = result.health.find(DefectKind::IsolatedVertex);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->count, 1000);
  EXPECT_EQ(static_cast<int>(d->elements.size()), Defect::kMaxListed);
}

TEST(HealthReport, RefusesWhatIsNoMesh) {
  const Shape shape = tetrahedron();
  auto where = [](const Points& p, const Polygons& f) {
    const auto result = check_and_repair(p, f);
    EXPECT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
    return result.error().where;
  };
  EXPECT_EQ(where(shape.positions, {}), "");
  EXPECT_EQ(where(shape.positions, {{0, 0, 1}, {2, 3}}), "");
  EXPECT_EQ(where(shape.positions, {{0, 1, 2}, {0, 1, 4}}), "face 1");
  Points bad = shape.positions;
  bad(3, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(where(bad, shape.faces), "vertex 3");
}

// Whatever the polygons, the repaired mesh is one that PolygonMesh takes, and the same every time.
TEST(HealthReport, RepairsAnyPolygonSoup) {
  unsigned state = 3;
  auto random = [&](int n) {
    state = state * 1664525u + 1013904223u;
    return static_cast<int>((state >> 8) % static_cast<unsigned>(n));
  };
  for (int round = 0; round < 3000; ++round) {
    const int vertices = 3 + random(12), face_count = 1 + random(30);
    Points p(vertices, 3);
    for (int v = 0; v < vertices; ++v) p.row(v) << random(5), random(5), random(5);
    Polygons faces;
    for (int f = 0; f < face_count; ++f) {
      std::vector<int> corners(static_cast<size_t>(random(7)));
      for (int& v : corners) v = random(vertices);
      faces.push_back(corners);
    }
    const auto first = check_and_repair(p, faces), second = check_and_repair(p, faces);
    ASSERT_EQ(first.has_value(), second.has_value());
    if (!first) {
      EXPECT_NE(first.error().what.find("face"), std::string::npos) << first.error().text();
      continue;
    }
    EXPECT_EQ(first->mesh.faces(), second->mesh.faces());
    EXPECT_EQ(first->health.summary(), second->health.summary());
    // What is repaired needs no second repair.
    const CheckedMesh again = checked(first->mesh.positions(), first->mesh.faces());
    EXPECT_FALSE(again.health.repaired) << again.health.summary();
    EXPECT_EQ(again.health.components, first->health.components);
  }
}

TEST(HealthReport, TakesLargeMeshesInReasonableTime) {
  const PolygonMesh torus = make_torus(400, 500);
  const CheckedMesh result = checked(torus.positions(), torus.faces());
  EXPECT_TRUE(result.health.healthy());
}

TEST(HealthReport, NamesEveryKind) {
  EXPECT_STREQ(name(DefectKind::NonManifoldEdge), "non-manifold edge");
  EXPECT_STREQ(name(DefectKind::IndexBase), "index list that counts from 1");
}

}  // namespace
}  // namespace planewright
