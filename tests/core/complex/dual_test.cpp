#include "core/complex/dual.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

int border_edges(const PolygonMesh& mesh) {
  int count = 0;
  for (int e = 0; e < mesh.edge_count(); ++e) count += mesh.edge(e).border();
  return count;
}
int border_vertices(const PolygonMesh& mesh) {
  int count = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) count += !mesh.is_isolated(v) && mesh.is_border_vertex(v);
  return count;
}

// Every panel runs counter-clockwise about its plane's normal.
void expect_counter_clockwise(const TangentComplex& complex, const std::string& what) {
  for (int i = 0; i < complex.plane_count(); ++i)
    EXPECT_GT(newell_vector(complex.preferred, complex.panels[i]).dot(complex.normals.row(i)), 0.0)
        << what << ", panel " << i;
}

TEST(Dual, OfAClosedMeshHasAPlanePerVertexAndAPointPerFace) {
  const PolygonMesh mesh = octahedron().mesh();
  const TangentComplex complex = build_dual(mesh).value();
  EXPECT_EQ(complex.kind, ComplexKind::Dual);
  ASSERT_EQ(complex.plane_count(), 6);
  ASSERT_EQ(complex.point_count(), 8);
  EXPECT_EQ(complex.incidence_count(), 24);
  EXPECT_EQ(complex.panel_edges.size(), 12u);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(complex.panels.valence(i), 4);
    EXPECT_EQ(complex.plane_origin[i], i);
    EXPECT_EQ(complex.offsets[i], 0.0);
    // By symmetry the normals point outwards along the axes.
    EXPECT_NEAR((complex.normals.row(i) - mesh.positions().row(i)).norm(), 0.0, 1e-15);
    EXPECT_EQ(complex.anchors.row(i) + complex.origin.transpose(), mesh.positions().row(i));
  }
  const Polygons faces = mesh.faces();
  for (int f = 0; f < 8; ++f) {
    EXPECT_EQ(complex.point_origin[f], (PointOrigin{PointKind::Face, f}));
    const Vector3d middle = centroid(mesh.positions(), faces[f]);
    EXPECT_NEAR((complex.preferred.row(f).transpose() + complex.origin - middle).norm(), 0.0, 1e-15);
    std::vector<int> corners(faces[f].begin(), faces[f].end());
    std::sort(corners.begin(), corners.end());
    const auto planes = complex.planes_of_point[f];
    EXPECT_EQ(std::vector<int>(planes.begin(), planes.end()), corners);
  }
  expect_counter_clockwise(complex, "octahedron");
}

TEST(Dual, OfQuadsGivesPointsOfValenceFour) {
  const TangentComplex complex = build_dual(cube().mesh()).value();
  EXPECT_EQ(complex.plane_count(), 8);
  EXPECT_EQ(complex.point_count(), 6);
  for (int j = 0; j < 6; ++j) EXPECT_EQ(complex.planes_of_point.valence(j), 4);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(complex.panels.valence(i), 3);
  expect_counter_clockwise(complex, "cube");
}

// One triangle: three planes; the face's point, three border points, three corners.
TEST(Dual, OfOneTriangleKeepsItsOutline) {
  const Shape triangle{make_points({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}), {{0, 1, 2}}};
  const PolygonMesh mesh = triangle.mesh();
  const TangentComplex complex = build_dual(mesh).value();
  ASSERT_EQ(complex.plane_count(), 3);
  ASSERT_EQ(complex.point_count(), 7);
  for (int j = 0; j < 7; ++j) {
    const Vector3d at = complex.preferred.row(j).transpose() + complex.origin;
    switch (complex.point_origin[j].kind) {
      case PointKind::Face:
        EXPECT_EQ(complex.planes_of_point.valence(j), 3);
        EXPECT_NEAR((at - Vector3d(2, 2, 0) / 3).norm(), 0.0, 1e-15);
        break;
      case PointKind::BorderEdge: {
        const MeshEdge edge = mesh.edge(complex.point_origin[j].element);
        ASSERT_EQ(complex.planes_of_point.valence(j), 2);
        EXPECT_EQ(complex.planes_of_point[j][0], std::min(edge.a, edge.b));
        EXPECT_EQ(complex.planes_of_point[j][1], std::max(edge.a, edge.b));
        EXPECT_EQ(at, Vector3d(0.5 * (mesh.positions().row(edge.a) + mesh.positions().row(edge.b))));
        break;
      }
      case PointKind::Corner:
        ASSERT_EQ(complex.planes_of_point.valence(j), 1);
        EXPECT_EQ(complex.planes_of_point[j][0], complex.point_origin[j].element);
        EXPECT_EQ(at, Vector3d(mesh.positions().row(complex.point_origin[j].element)));
        break;
      case PointKind::Vertex:
        ADD_FAILURE() << "a dual has no such points";
    }
  }
  // The panel of a corner of the triangle is the quadrilateral face point, border point, corner, border
  // point.
  for (int i = 0; i < 3; ++i) EXPECT_EQ(complex.panels.valence(i), 4);
  expect_counter_clockwise(complex, "triangle");
  // The panels tile the triangle.
  double area = 0.0;
  for (int i = 0; i < 3; ++i) area += 0.5 * newell_vector(complex.preferred, complex.panels[i]).z();
  EXPECT_NEAR(area, 2.0, 1e-14);
}

TEST(Dual, CountsAndValencesWithAClosedBorder) {
  for (const Shape& shape : {fan(6), fan(5, true), domed_triangle_grid(4, 3), twisted_grid(3, 3),
                             honeycomb(3, 2), shape_of(make_sample("train-station", 100).value())}) {
    const PolygonMesh mesh = shape.mesh();
    const TangentComplex complex = build_dual(mesh).value();
    EXPECT_EQ(complex.plane_count(), mesh.vertex_count());
    EXPECT_EQ(complex.point_count(), mesh.face_count() + border_edges(mesh) + border_vertices(mesh));
    std::set<std::pair<PointKind, int>> seen;
    for (int j = 0; j < complex.point_count(); ++j) {
      const PointOrigin origin = complex.point_origin[j];
      EXPECT_TRUE(seen.insert({origin.kind, origin.element}).second);
      const int valence = complex.planes_of_point.valence(j);
      const int expected = origin.kind == PointKind::Face         ? shape.faces.valence(origin.element)
                           : origin.kind == PointKind::BorderEdge ? 2
                                                                  : 1;
      EXPECT_EQ(valence, expected);
    }
    // Panels of inner vertices are the faces round them; at the border the outline adds three points.
    for (int i = 0; i < complex.plane_count(); ++i) {
      const int v = complex.plane_origin[i];
      const int faces = static_cast<int>(mesh.faces_around(v).size());
      EXPECT_EQ(complex.panels.valence(i), mesh.is_border_vertex(v) ? faces + 3 : faces);
    }
    // The outline: one border panel edge on each side of each border vertex.
    int outline = 0;
    for (const PanelEdge& edge : complex.panel_edges) outline += edge.border();
    EXPECT_EQ(outline, 2 * border_vertices(mesh));
  }
}

TEST(Dual, PanelsRunCounterClockwise) {
  expect_counter_clockwise(build_dual(tetrahedron().mesh()).value(), "tetrahedron");
  expect_counter_clockwise(build_dual(icosahedron().mesh()).value(), "icosahedron");
  expect_counter_clockwise(build_dual(fan(6, true).mesh()).value(), "open fan");
  expect_counter_clockwise(build_dual(honeycomb(3, 3).mesh()).value(), "honeycomb");
  expect_counter_clockwise(build_dual(domed_triangle_grid(5, 4).mesh()).value(), "domed grid");
  for (const SampleInfo& info : samples())
    expect_counter_clockwise(build_dual(make_sample(info.name, 200).value()).value(), std::string(info.name));
}

// Each panel lies among the planes it says: its points name its plane.
TEST(Dual, PanelsAndPlanesOfPointsAgree) {
  const PolygonMesh mesh = make_sample("alpine-hut", 120).value();
  for (const BorderPolicy border : {BorderPolicy::Closed, BorderPolicy::Interior}) {
    const TangentComplex complex = build_dual(mesh, {0.0, border}).value();
    int corners = 0;
    for (int i = 0; i < complex.panels.size(); ++i)
      for (const int j : complex.panels[i]) {
        const auto planes = complex.planes_of_point[j];
        EXPECT_TRUE(std::binary_search(planes.begin(), planes.end(), i));
        ++corners;
      }
    EXPECT_EQ(corners, complex.incidence_count());
  }
}

// The mesh edge that a panel edge crosses lies between the faces of its ends, the left one on the left.
TEST(Dual, PanelEdgesNameTheMeshEdgeThatTheyCross) {
  for (const Shape& shape : {icosahedron(), fan(6, true), domed_triangle_grid(4, 3), twisted_grid(3, 3),
                             shape_of(make_sample("train-station", 100).value())})
    for (const BorderPolicy border : {BorderPolicy::Closed, BorderPolicy::Interior}) {
      const PolygonMesh mesh = shape.mesh();
      const auto built = build_dual(mesh, {0.0, border});
      if (!built) continue;  // no inner vertex
      const TangentComplex& complex = *built;
      ASSERT_EQ(complex.crossed_edge.size(), complex.panel_edges.size());
      std::set<int> crossed;
      for (size_t e = 0; e < complex.panel_edges.size(); ++e) {
        const PanelEdge& edge = complex.panel_edges[e];
        const auto [i, j] = complex.crossed_edge[e];
        const PointKind kinds[] = {complex.point_origin[edge.a].kind, complex.point_origin[edge.b].kind};
        if (kinds[0] == PointKind::Corner || kinds[1] == PointKind::Corner) {  // along the border
          EXPECT_EQ(i, -1);
          EXPECT_EQ(j, -1);
          continue;
        }
        const int found = mesh.find_edge(i, j);
        ASSERT_GE(found, 0);
        EXPECT_TRUE(crossed.insert(found).second);
        if (edge.left >= 0) {
          EXPECT_EQ(complex.plane_origin[edge.left], i);
        }
        if (edge.right >= 0) {
          EXPECT_EQ(complex.plane_origin[edge.right], j);
        }
        // b on the left of i -> j, a on the right; the border point stands for the face that is not there.
        MeshEdge across = mesh.edge(found);
        if (across.a != i) std::swap(across.left, across.right);
        for (const auto& [point, face] : {std::pair(edge.b, across.left), std::pair(edge.a, across.right)}) {
          const PointOrigin expected =
              face >= 0 ? PointOrigin{PointKind::Face, face} : PointOrigin{PointKind::BorderEdge, found};
          EXPECT_EQ(complex.point_origin[point], expected);
        }
      }
      for (int e = 0; e < mesh.edge_count(); ++e) {
        const auto has_panel = [&](int v) {
          return border == BorderPolicy::Closed || !mesh.is_border_vertex(v);
        };
        EXPECT_EQ(crossed.contains(e), has_panel(mesh.edge(e).a) || has_panel(mesh.edge(e).b)) << e;
      }
    }
}

TEST(Dual, PointsNameTheirFace) {
  const PolygonMesh mesh = domed_triangle_grid(4, 3).mesh();
  const TangentComplex complex = build_dual(mesh).value();
  for (int j = 0; j < complex.point_count(); ++j) {
    const PointOrigin origin = complex.point_origin[j];
    int face = -1;
    if (origin.kind == PointKind::Face) face = origin.element;
    if (origin.kind == PointKind::BorderEdge)
      face = std::max(mesh.edge(origin.element).left, mesh.edge(origin.element).right);
    EXPECT_EQ(complex.face_of_point[j], face);
  }
}

TEST(Dual, KeepsTheMeshAsItsInput) {
  const Shape shape = twisted_grid(3, 2);
  const PolygonMesh mesh = shape.mesh();
  for (const TangentComplex& complex : {build_dual(mesh).value(), *planarize_of(mesh)}) {
    const InputSurface& input = complex.input;
    EXPECT_NEAR((input.vertices.rowwise() + complex.origin.transpose() - shape.positions).norm(), 0.0, 1e-14);
    EXPECT_EQ(input.faces, shape.faces);
    ASSERT_EQ(static_cast<int>(input.edges.size()), mesh.edge_count());
    for (int e = 0; e < mesh.edge_count(); ++e)
      EXPECT_EQ(input.edges[static_cast<size_t>(e)], (std::array{mesh.edge(e).a, mesh.edge(e).b}));
    for (int f = 0; f < mesh.face_count(); ++f)
      EXPECT_NEAR((input.face_normals.row(f).transpose() -
                   newell_vector(shape.positions, shape.faces[f]).normalized())
                      .norm(),
                  0.0, 1e-14);
    EXPECT_NEAR((input.vertex_normals.rowwise().norm().array() - 1.0).abs().maxCoeff(), 0.0, 1e-14);
  }
}

TEST(Dual, InteriorPolicyMakesPanelsOfInnerVerticesAlone) {
  const PolygonMesh mesh = domed_triangle_grid(4, 3).mesh();
  const TangentComplex complex = build_dual(mesh, {0.0, BorderPolicy::Interior}).value();
  ASSERT_EQ(complex.plane_count(), 6);
  std::set<int> faces;
  for (int i = 0; i < 6; ++i) {
    const int v = complex.plane_origin[i];
    EXPECT_FALSE(mesh.is_border_vertex(v));
    EXPECT_EQ(complex.panels.valence(i), 6);
    for (const int f : mesh.faces_around(v)) faces.insert(f);
  }
  // The faces that only border vertices have (two of the grid's corners) give no point.
  EXPECT_LT(static_cast<int>(faces.size()), mesh.face_count());
  ASSERT_EQ(complex.point_count(), static_cast<int>(faces.size()));
  for (int j = 0; j < complex.point_count(); ++j) {
    EXPECT_EQ(complex.point_origin[j].kind, PointKind::Face);
    EXPECT_TRUE(faces.contains(complex.point_origin[j].element));
    EXPECT_GE(complex.planes_of_point.valence(j), 1);
    EXPECT_LE(complex.planes_of_point.valence(j), 3);
  }
  expect_counter_clockwise(complex, "interior");
}

TEST(Dual, InteriorPolicyWithoutInnerVerticesIsRefused) {
  const auto complex = build_dual(fan(5, true).mesh(), {0.0, BorderPolicy::Interior});
  ASSERT_FALSE(complex);
  EXPECT_EQ(complex.error().code, ErrorCode::Refused);
  EXPECT_NE(complex.error().remedy.find("closed"), std::string::npos);
}

TEST(Dual, AnEmptyMeshIsRefused) {
  const auto complex = build_dual(PolygonMesh());
  ASSERT_FALSE(complex);
  EXPECT_EQ(complex.error().code, ErrorCode::Refused);
}

// A positive offset lies on the side that the faces look to, and is a solution already where all is flat.
TEST(Dual, OffsetLiftsPlanesAndPointsAlongTheNormals) {
  for (const double offset : {0.25, -0.5}) {
    const TangentComplex complex = build_dual(triangle_grid(3, 2).mesh(), {offset}).value();
    for (int j = 0; j < complex.point_count(); ++j)
      EXPECT_DOUBLE_EQ(complex.preferred(j, 2) + complex.origin.z(), offset);
    for (int i = 0; i < complex.plane_count(); ++i) {
      EXPECT_EQ(complex.offsets[i], offset);
      EXPECT_EQ(complex.anchors(i, 2), 0.0);
    }
    EXPECT_NEAR(incidence_residuals(complex, initial_state(complex)).cwiseAbs().maxCoeff(), 0.0, 1e-15);
  }
  const TangentComplex outside = build_dual(icosahedron().mesh(), {0.1}).value();
  const TangentComplex on = build_dual(icosahedron().mesh()).value();
  for (int j = 0; j < on.point_count(); ++j)
    EXPECT_NEAR(outside.preferred.row(j).norm() - on.preferred.row(j).norm(), 0.1, 1e-14);
}

TEST(Dual, AnOffsetThatIsNoNumberIsRefused) {
  for (const double offset :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto complex = build_dual(cube().mesh(), {offset});
    ASSERT_FALSE(complex);
    EXPECT_EQ(complex.error().code, ErrorCode::Usage);
    EXPECT_EQ(complex.error().where, "offset");
  }
}

TEST(Dual, IsolatedVerticesGetNoPlane) {
  Shape shape = fan(5);
  Points more(shape.positions.rows() + 2, 3);
  more << Eigen::RowVector3d(9, 9, 9), shape.positions, Eigen::RowVector3d(-9, 0, 0);
  Polygons faces;
  for (int f = 0; f < shape.faces.size(); ++f) {
    std::vector<int> face(shape.faces[f].begin(), shape.faces[f].end());
    for (int& v : face) ++v;
    faces.push_back(face);
  }
  const TangentComplex complex = build_dual(Shape{more, faces}.mesh()).value();
  const TangentComplex without = build_dual(shape.mesh()).value();
  ASSERT_EQ(complex.plane_count(), 6);
  EXPECT_EQ(complex.plane_origin, (std::vector<int>{1, 2, 3, 4, 5, 6}));
  // Nor do they move the frame.
  EXPECT_EQ(complex.origin, without.origin);
  EXPECT_TRUE(same_bits(complex.preferred, without.preferred));
  EXPECT_EQ(complex.panels, without.panels);
}

TEST(Dual, FacesWithoutAreaBorrowTheirNeighboursNormal) {
  // The sliver 0-1-2 is a line; its neighbour lies in z = 0.
  const Shape shape{make_points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}), {{0, 1, 2}, {0, 2, 3}}};
  const TangentComplex complex = build_dual(shape.mesh(), {0.5}).value();
  EXPECT_TRUE(all_finite(complex));
  for (int i = 0; i < complex.plane_count(); ++i)
    EXPECT_NEAR((complex.normals.row(i) - Eigen::RowVector3d(0, 0, 1)).norm(), 0.0, 1e-15) << i;
  for (int j = 0; j < complex.point_count(); ++j)
    EXPECT_NEAR(complex.preferred(j, 2) + complex.origin.z(), 0.5, 1e-15);
}

TEST(Dual, AMeshWithoutAnyAreaStillHasUnitNormals) {
  const Shape shape{make_points({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), {{0, 1, 2}}};
  const TangentComplex complex = build_dual(shape.mesh()).value();
  EXPECT_TRUE(all_finite(complex));
  EXPECT_EQ(complex.mean_edge, 1.0);
  for (int i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(complex.normals.row(i).norm(), 1.0);
}

// Two equal triangles back to back along an edge: at its ends the area vectors cancel out.
TEST(Dual, AFoldTakesTheNormalOfItsLargestFace) {
  const Shape shape{make_points({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 1, 0}}), {{0, 1, 2}, {1, 0, 3}}};
  const TangentComplex complex = build_dual(shape.mesh()).value();
  EXPECT_TRUE(all_finite(complex));
  for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(std::abs(complex.normals(i, 2)), 1.0) << i;
  EXPECT_DOUBLE_EQ(complex.normals(2, 2), 1.0);   // only in the face that looks up
  EXPECT_DOUBLE_EQ(complex.normals(3, 2), -1.0);  // only in the one that looks down
}

// 2^20 and multiples of 2^-10 add up without rounding, so nothing at all may change but the origin.
TEST(Dual, IsTheSameFarFromTheOrigin) {
  Shape shape = domed_triangle_grid(4, 3);
  shape.positions = (shape.positions * 1024.0).array().round() / 1024.0;
  const TangentComplex near = build_dual(shape.mesh(), {0.125}).value();
  const Vector3d shift(1 << 20, -(1 << 21), 1 << 19);
  shape.positions.rowwise() += shift.transpose();
  const TangentComplex far = build_dual(shape.mesh(), {0.125}).value();
  EXPECT_EQ(far.origin, near.origin + shift);
  EXPECT_TRUE(same_bits(far.anchors, near.anchors));
  EXPECT_TRUE(same_bits(far.normals, near.normals));
  EXPECT_TRUE(same_bits(far.preferred, near.preferred));
  EXPECT_EQ(far.panels, near.panels);
  EXPECT_EQ(far.mean_edge, near.mean_edge);
}

}  // namespace
}  // namespace planewright
