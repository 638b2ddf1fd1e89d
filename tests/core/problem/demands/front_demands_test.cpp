// Vertex, face and edge: what [Z 3] asks of layers outside and inside.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

const std::vector<std::string> kFront = {"vertex", "face", "edge"};

// A triangle and its mirror image across the edge 0-1 (length 2), bent down on both sides by `drop`.
Shape roof(double drop) {
  return {make_points({{0, 0, 0}, {2, 0, 0}, {1, 1.5, -drop}, {1, -1.5, -drop}}), {{0, 1, 2}, {1, 0, 3}}};
}

TEST(VertexDemand, IsTheHeightOverTheFace) {
  const SharedComplex complex = dual_of(roof(0.4).mesh(), {0.3});
  const auto problem = Problem::create(complex, demanding({demand("vertex")})).value();
  const State state = initial_state(*complex);
  const Vector values = row_values(*problem, state);
  int rows = 0;
  for (int j = 0; j < complex->point_count(); ++j) {
    const auto found = rows_of(*problem, "vertex", {ElementKind::Point, j});
    if (complex->point_origin[j].kind == PointKind::Corner) {
      EXPECT_TRUE(found.empty());
      continue;
    }
    ASSERT_EQ(found.size(), 1u);
    ++rows;
    // Every wanted point lies 0.3 over its face.
    EXPECT_NEAR(room(*problem, values, found[0]), 0.3 / complex->mean_edge - 1e-4, 1e-12);
    EXPECT_EQ(problem->bounds(found[0]).high, kUnbounded);
  }
  EXPECT_EQ(rows, 2 + 4);
}

// A face that is not planar: in front of the corner that stands out most.
TEST(VertexDemand, OfABentQuadHoldsForAllCorners) {
  const Shape bent{make_points({{0, 0, 0.3}, {1, 0, -0.3}, {1, 1, 0.3}, {0, 1, -0.3}}), {{0, 1, 2, 3}}};
  for (const double side : {1.0, -1.0}) {
    const SharedComplex complex = dual_of(bent.mesh());
    const auto problem = Problem::create(complex, demanding({demand("vertex")}, {}, side)).value();
    State state = initial_state(*complex);
    const int row = rows_of(*problem, "vertex", {ElementKind::Point, 0}).at(0);
    state.x(0, 2) = side * 0.5 - complex->origin.z();
    EXPECT_NEAR(room(*problem, row_values(*problem, state), row), 0.2 / complex->mean_edge - 1e-4, 1e-12);
  }
}

TEST(FaceDemand, IsTheOffset) {
  const SharedComplex complex = dual_of(roof(0.4).mesh(), {0.3});
  for (const double side : {1.0, -1.0}) {
    const auto problem = Problem::create(complex, demanding({demand("face")}, {}, side)).value();
    const auto rows = rows_of(*problem, "face");
    ASSERT_EQ(rows.size(), 4u);
    const Vector values = row_values(*problem, initial_state(*complex));
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(problem->row_element(rows[static_cast<size_t>(i)]), (ElementRef{ElementKind::Panel, i}));
      EXPECT_NEAR(room(*problem, values, rows[static_cast<size_t>(i)]),
                  side * 0.3 / complex->mean_edge - 1e-4, 1e-12);
    }
  }
}

// The panel edge over the edge 0-1: its height over it, whatever the mesh's numbering. L = its wanted length.
TEST(EdgeDemand, IsTheHeightOverTheMeshEdge) {
  const SharedComplex complex = dual_of(roof(0.0).mesh());
  for (const double side : {1.0, -1.0}) {
    const auto problem = Problem::create(complex, demanding({demand("edge")}, {}, side)).value();
    int across = -1;
    for (size_t e = 0; e < complex->panel_edges.size(); ++e)
      if (complex->crossed_edge[e] == std::array{0, 1} || complex->crossed_edge[e] == std::array{1, 0})
        across = static_cast<int>(e);
    ASSERT_GE(across, 0);
    const auto rows = rows_of(*problem, "edge", {ElementKind::PanelEdge, across});
    ASSERT_EQ(rows.size(), 1u);
    State state = initial_state(*complex);
    for (int j : {0, 1}) state.x(j, 2) += side * 0.2;
    EXPECT_NEAR(room(*problem, row_values(*problem, state), rows[0]), 0.2 / complex->mean_edge - 1e-4, 1e-12);
    for (int j : {0, 1}) state.x(j, 2) -= side * 0.5;
    EXPECT_NEAR(room(*problem, row_values(*problem, state), rows[0]), -0.3 / complex->mean_edge - 1e-4,
                1e-12);
  }
}

// Every edge row counts, on closed and open convex caps, their border edges, both border policies, outside
// and inside: panels that float 0.2 edges off the mesh are in front of it.
TEST(FrontDemands, HoldWherePanelsFloatOffAConvexCap) {
  for (const double side : {1.0, -1.0})
    for (const BorderPolicy border : {BorderPolicy::Closed, BorderPolicy::Interior})
      for (const PolygonMesh& mesh :
           {domed_triangle_grid(6, 5, 0.02).mesh(), make_sample("dome", 120).value(), icosahedron().mesh(),
            fan(6).mesh()}) {
        const double edge = dual_of(mesh, {0.0, border})->mean_edge;
        const SharedComplex complex = dual_of(mesh, {side * 0.2 * edge, border});
        const auto problem =
            Problem::create(complex, demanding({demand("vertex"), demand("face"), demand("edge")}, {}, side))
                .value();
        State state = initial_state(*complex);
        const Vector values = row_values(*problem, state);
        const bool wide = mesh.vertex_count() > 12;  // bends little from face to face
        for (const std::string& name : kFront) {
          const auto rows = rows_of(*problem, name);
          EXPECT_FALSE(rows.empty());
          for (int r : rows) {
            if (!wide && name == "edge") continue;
            EXPECT_GT(room(*problem, values, r), 0.0) << name << ' ' << r;
          }
        }
        // One row per mesh edge that panels touch, border edges included.
        size_t crossed = 0;
        for (int e = 0; e < mesh.edge_count(); ++e) {
          const auto touched = [&](int v) {
            return border == BorderPolicy::Closed || !mesh.is_border_vertex(v);
          };
          crossed += touched(mesh.edge(e).a) || touched(mesh.edge(e).b);
        }
        EXPECT_EQ(rows_of(*problem, "edge").size(), crossed);
        // On the other side of the mesh, none is in front.
        state.x = (2.0 * dual_of(mesh, {0.0, border})->preferred - complex->preferred).eval();
        const Vector mirrored = row_values(*problem, state);
        for (int r : rows_of(*problem, "vertex")) EXPECT_LT(room(*problem, mirrored, r), 0.0);
        if (!wide) continue;
        for (int r : rows_of(*problem, "edge")) EXPECT_LT(room(*problem, mirrored, r), 0.0);
      }
}

TEST(FrontDemands, KeepToTheirSelection) {
  const PolygonMesh mesh = domed_triangle_grid(5, 4).mesh();
  const SharedComplex complex = dual_of(mesh, {0.1});
  int inner = -1;
  for (int v = 0; v < mesh.vertex_count() && inner < 0; ++v)
    if (!mesh.is_border_vertex(v)) inner = v;
  const Selection selection{"one", {inner}, {}, {}};
  const auto problem =
      Problem::create(complex, demanding({demand("vertex", {}, "one"), demand("face", {}, "one"),
                                          demand("edge", {}, "one")},
                                         {selection}))
          .value();
  // One hexagon: six points and edges.
  EXPECT_EQ(rows_of(*problem, "vertex").size(), 6u);
  EXPECT_EQ(rows_of(*problem, "edge").size(), 6u);
  const auto face = rows_of(*problem, "face");
  ASSERT_EQ(face.size(), 1u);
  EXPECT_EQ(complex->plane_origin[problem->row_element(face[0]).index], inner);
  for (int r : rows_of(*problem, "edge")) {
    const auto crossed = complex->crossed_edge[problem->row_element(r).index];
    EXPECT_TRUE(crossed[0] == inner || crossed[1] == inner);
  }
}

TEST(FrontDemands, HaveRightDerivatives) {
  for (const auto& [what, complex] : small_complexes())
    if (complex->kind == ComplexKind::Dual && complex->panel_edges.size() > 6)
      for (const double side : {1.0, -1.0})
        expect_right_derivatives(
            complex, demanding({demand("vertex"), demand("face"), demand("edge")}, {}, side), what);
}

TEST(FrontDemands, MeanNothingWhenPlanarizing) {
  for (const std::string& name : kFront) {
    const auto problem = Problem::create(planarize_of(cube().mesh()), demanding({demand(name)}));
    ASSERT_FALSE(problem);
    EXPECT_EQ(problem.error().code, ErrorCode::Usage);
    EXPECT_NE(problem.error().what.find(name), std::string::npos);
  }
}

// Each alone, outside and inside: violated without it, met with it.
TEST(FrontDemands, AreMetByASolve) {
  for (const double side : {1.0, -1.0})
    for (const std::string& name : kFront) {
      SCOPED_TRACE(name + (side > 0.0 ? " outside" : " inside"));
      expect_demands_take_effect(dual_of(make_sample("saddle-roof", 80).value()),
                                 demanding({demand(name)}, {}, side), 1e-3);
    }
}

TEST(FrontDemands, AreMetTogether) {
  for (const double side : {1.0, -1.0}) {
    const PolygonMesh mesh = make_sample("dome", 80).value();
    const double edge = dual_of(mesh)->mean_edge;
    expect_demands_take_effect(dual_of(mesh, {side * 0.01 * edge}),
                               demanding({demand("vertex"), demand("face"), demand("edge")}, {}, side), 0.0);
  }
}

}  // namespace
}  // namespace planewright
