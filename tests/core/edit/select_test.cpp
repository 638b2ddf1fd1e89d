#include "core/edit/select.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/complex/cluster.h"
#include "core/complex/dual.h"
#include "core/complex/planarize.h"
#include "core/edit/element_names.h"
#include "core/mesh/sample_shapes.h"
#include "support/clusters.h"
#include "support/shapes.h"

namespace planewright {
namespace {

std::vector<int> sorted(std::vector<int> list) {
  std::sort(list.begin(), list.end());
  return list;
}

// Vertex (x, y) of test::grid(4, 3).
int at(int x, int y) {
  return y * 5 + x;
}
PolygonMesh grid() {
  return test::grid(4, 3).mesh();
}

TEST(Select, AFaceStripCrossesAQuadGridFromBorderToBorder) {
  const PolygonMesh mesh = grid();
  // The edge between (2,1) and (2,2) is crossed along x: the middle row of faces, 4 .. 7.
  const int upright = mesh.find_edge(at(2, 1), at(2, 2));
  EXPECT_EQ(sorted(face_strip(mesh, upright)), (std::vector<int>{4, 5, 6, 7}));
  const std::vector<int> strip = face_strip(mesh, upright);
  EXPECT_TRUE(std::is_sorted(strip.begin(), strip.end()) || std::is_sorted(strip.rbegin(), strip.rend()))
      << "in the order in which they lie";
  // Across the edge from (1,1) to (2,1): the second column.
  EXPECT_EQ(sorted(face_strip(mesh, mesh.find_edge(at(1, 1), at(2, 1)))), (std::vector<int>{1, 5, 9}));
  // From a border edge inwards.
  EXPECT_EQ(sorted(face_strip(mesh, mesh.find_edge(at(0, 0), at(1, 0)))), (std::vector<int>{0, 4, 8}));
}

TEST(Select, AStripRoundAClosedRingNamesEachFaceOnce) {
  const PolygonMesh cube = test::cube().mesh();
  const std::vector<int> ring = face_strip(cube, 0);
  EXPECT_EQ(ring.size(), 4u);
  const auto set = sorted(ring);
  EXPECT_EQ(std::adjacent_find(set.begin(), set.end()), set.end());
  const MeshEdge edge = cube.edge(0);
  EXPECT_TRUE(std::count(ring.begin(), ring.end(), edge.left) == 1);
  EXPECT_TRUE(std::count(ring.begin(), ring.end(), edge.right) == 1);
}

TEST(Select, AStripEndsInTriangles) {
  const PolygonMesh mesh = test::triangle_grid(2, 2).mesh();
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const MeshEdge edge = mesh.edge(e);
    EXPECT_EQ(face_strip(mesh, e).size(), edge.border() ? 1u : 2u);
  }
}

TEST(Select, AnEdgeLineRunsStraightThroughRegularVertices) {
  const PolygonMesh mesh = grid();
  std::vector<int> expected;
  for (int x = 0; x < 4; ++x) expected.push_back(mesh.find_edge(at(x, 1), at(x + 1, 1)));
  const auto line = edge_line(mesh, mesh.find_edge(at(1, 1), at(2, 1)));
  EXPECT_EQ(sorted(line), sorted(expected));
  EXPECT_TRUE(line == expected || line == std::vector<int>(expected.rbegin(), expected.rend()))
      << "from end to end";
  // Round a torus of triangles, valence 6: closed, each edge once.
  const PolygonMesh torus = make_torus(8, 10);
  for (const int e : {0, 1, 2}) {
    const auto ring = edge_line(torus, e);
    auto set = sorted(ring);
    EXPECT_EQ(std::adjacent_find(set.begin(), set.end()), set.end());
    EXPECT_GE(ring.size(), 8u);
    // Closed: both ends of every edge are ends of another one.
    std::vector<int> ends(static_cast<std::size_t>(torus.vertex_count()), 0);
    for (const int in : ring) {
      ++ends[torus.edge(in).a];
      ++ends[torus.edge(in).b];
    }
    EXPECT_EQ(std::count_if(ends.begin(), ends.end(), [](int n) { return n % 2 != 0; }), 0);
  }
}

TEST(Select, AnEdgeLineStopsAtOddVertices) {
  const PolygonMesh mesh = test::tetrahedron().mesh();  // valence 3
  EXPECT_EQ(edge_line(mesh, 2), std::vector<int>{2});
}

TEST(Select, BorderLoopsRunOnceRound) {
  const PolygonMesh mesh = grid();
  const int first = mesh.find_edge(at(1, 0), at(2, 0));
  const auto loop = border_loop(mesh, first);
  EXPECT_EQ(loop.size(), 14u);
  EXPECT_EQ(loop.front(), first);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const MeshEdge a = mesh.edge(loop[k]), b = mesh.edge(loop[(k + 1) % loop.size()]);
    EXPECT_TRUE(a.border());
    const int end = a.left >= 0 ? a.b : a.a, begin = b.left >= 0 ? b.a : b.b;
    EXPECT_EQ(end, begin);
  }
  EXPECT_TRUE(border_loop(mesh, mesh.find_edge(at(1, 1), at(2, 1))).empty());
  EXPECT_EQ(border_edges(mesh).size(), 14u);
  EXPECT_TRUE(border_edges(make_torus(6, 6)).empty());
}

TEST(Select, TheBorderMeansPanelsOrCornersAsTheModeSays) {
  const PolygonMesh mesh = grid();
  const auto edges = border_edges(mesh);
  const auto inner_vertices = std::vector<int>{at(1, 1), at(2, 1), at(3, 1), at(1, 2), at(2, 2), at(3, 2)};
  const Selection dual = along_border(mesh, ComplexKind::Dual, SelectWhat::Panels, edges);
  EXPECT_EQ(dual.vertices.size(), 20u - inner_vertices.size());
  for (const int v : inner_vertices) EXPECT_EQ(std::count(dual.vertices.begin(), dual.vertices.end(), v), 0);
  EXPECT_TRUE(dual.edges.empty() && dual.faces.empty());
  EXPECT_EQ(along_border(mesh, ComplexKind::Dual, SelectWhat::Corners, edges).edges, sorted(edges));
  const Selection faces = along_border(mesh, ComplexKind::Planarize, SelectWhat::Panels, edges);
  EXPECT_EQ(faces.faces, (std::vector<int>{0, 1, 2, 3, 4, 7, 8, 9, 10, 11}));
  EXPECT_EQ(along_border(mesh, ComplexKind::Planarize, SelectWhat::Corners, edges).vertices, dual.vertices);
}

TEST(Select, LoopsThroughAnEdge) {
  const PolygonMesh mesh = grid();
  const int upright = mesh.find_edge(at(2, 1), at(2, 2));
  EXPECT_EQ(loop_through(mesh, ComplexKind::Planarize, SelectWhat::Panels, upright).faces,
            (std::vector<int>{4, 5, 6, 7}));
  const std::vector<int> column{at(2, 0), at(2, 1), at(2, 2), at(2, 3)};
  EXPECT_EQ(loop_through(mesh, ComplexKind::Planarize, SelectWhat::Corners, upright).vertices, column);
  EXPECT_EQ(loop_through(mesh, ComplexKind::Dual, SelectWhat::Panels, upright).vertices, column);
  EXPECT_EQ(loop_through(mesh, ComplexKind::Dual, SelectWhat::Corners, upright).faces,
            (std::vector<int>{4, 5, 6, 7}));
  const int border = mesh.find_edge(at(0, 0), at(1, 0));
  EXPECT_EQ(loop_through(mesh, ComplexKind::Planarize, SelectWhat::Corners, border).vertices.size(), 14u);
}

TEST(Select, GrowsAndShrinksByOneRing) {
  const PolygonMesh mesh = test::grid(5, 5).mesh();
  Selection middle;
  middle.faces = {12};
  const Selection ring = grown(mesh, middle);
  EXPECT_EQ(ring.faces, (std::vector<int>{7, 11, 12, 13, 17}));
  EXPECT_TRUE(ring.vertices.empty() && ring.edges.empty());
  EXPECT_EQ(shrunk(mesh, ring).faces, middle.faces);

  Selection vertex;
  vertex.name = "peak";
  vertex.vertices = {14};  // (2, 2) of 6 x 6
  EXPECT_EQ(grown(mesh, vertex).vertices, (std::vector<int>{8, 13, 14, 15, 20}));
  EXPECT_EQ(grown(mesh, vertex).name, "peak");
  EXPECT_EQ(shrunk(mesh, grown(mesh, vertex)).vertices, vertex.vertices);
  EXPECT_TRUE(shrunk(mesh, vertex).empty());

  // All of it has no neighbour outside, border or not.
  const Selection all = everything(mesh, ComplexKind::Planarize, SelectWhat::Panels);
  EXPECT_EQ(shrunk(mesh, all).faces, all.faces);
}

TEST(Select, BorderEdgesGrowAlongTheBorder) {
  const PolygonMesh mesh = grid();
  Selection one;
  one.edges = {mesh.find_edge(at(1, 0), at(2, 0))};
  const Selection three = grown(mesh, one);
  EXPECT_EQ(three.edges,
            sorted({mesh.find_edge(at(0, 0), at(1, 0)), one.edges[0], mesh.find_edge(at(2, 0), at(3, 0))}));
  EXPECT_EQ(shrunk(mesh, three).edges, one.edges);
  EXPECT_EQ(whole_components(mesh, one).edges, sorted(border_edges(mesh)));
}

TEST(Select, InvertsWhatIsAskedFor) {
  const PolygonMesh mesh = grid();
  Selection two;
  two.vertices = {0, 19};
  const Selection rest = inverted(mesh, ComplexKind::Dual, SelectWhat::Panels, two);
  EXPECT_EQ(rest.vertices.size(), 18u);
  EXPECT_EQ(rest.vertices.front(), 1);
  EXPECT_EQ(inverted(mesh, ComplexKind::Dual, SelectWhat::Panels, rest).vertices, two.vertices);
  const Selection corners = inverted(mesh, ComplexKind::Dual, SelectWhat::Corners, {});
  EXPECT_EQ(corners.faces.size(), 12u);
  EXPECT_EQ(corners.edges.size(), 14u);
}

TEST(Select, CombinesAsSets) {
  Selection a, b;
  a.name = "a";
  a.vertices = {1, 3, 5};
  b.vertices = {3, 4};
  b.faces = {0};
  const Selection both = combined(a, b, Combine::Add);
  EXPECT_EQ(both.vertices, (std::vector<int>{1, 3, 4, 5}));
  EXPECT_EQ(both.faces, std::vector<int>{0});
  EXPECT_EQ(both.name, "a");
  EXPECT_EQ(element_count(both), 5);
  EXPECT_EQ(combined(a, b, Combine::Remove).vertices, (std::vector<int>{1, 5}));
  EXPECT_EQ(combined(a, b, Combine::Replace).vertices, b.vertices);
}

TEST(Select, WholeComponents) {
  // Two tetrahedra that do not touch.
  const test::Shape one = test::tetrahedron();
  Points positions(8, 3);
  positions << one.positions, one.positions.array() + 5.0;
  Polygons faces = one.faces;
  for (int f = 0; f < 4; ++f) {
    const auto corners = one.faces[f];
    faces.push_back(std::array{corners[0] + 4, corners[1] + 4, corners[2] + 4});
  }
  const PolygonMesh mesh = PolygonMesh::from_polygons(positions, faces).value();
  Selection pick;
  pick.vertices = {6};
  EXPECT_EQ(whole_components(mesh, pick).vertices, (std::vector<int>{4, 5, 6, 7}));
  EXPECT_TRUE(whole_components(mesh, pick).faces.empty());
  pick = {};
  pick.faces = {1};
  EXPECT_EQ(whole_components(mesh, pick).faces, (std::vector<int>{0, 1, 2, 3}));
}

TEST(Select, PanelEdgesAreFoundOnTheMesh) {
  const PolygonMesh mesh = grid();
  const TangentComplex faces = build_planarize(mesh).value();
  for (std::size_t e = 0; e < faces.panel_edges.size(); ++e) {
    const PanelEdge& edge = faces.panel_edges[e];
    const MeshEdge on = mesh.edge(mesh_edge_of(mesh, faces, static_cast<int>(e)));
    EXPECT_EQ(std::minmax(on.a, on.b), std::minmax(edge.a, edge.b));
  }
  const TangentComplex dual = build_dual(mesh).value();
  for (std::size_t e = 0; e < dual.panel_edges.size(); ++e) {
    const PanelEdge& edge = dual.panel_edges[e];
    const int found = mesh_edge_of(mesh, dual, static_cast<int>(e));
    ASSERT_GE(found, 0);
    const MeshEdge on = mesh.edge(found);
    if (edge.border()) {
      EXPECT_TRUE(on.border());
    } else {  // it crosses the mesh edge between the vertices of its two panels
      EXPECT_EQ(std::minmax(on.a, on.b),
                std::minmax(dual.plane_origin[static_cast<std::size_t>(edge.left)],
                            dual.plane_origin[static_cast<std::size_t>(edge.right)]));
    }
  }
}

TEST(Select, PanelsAndPointsAreNamedAndFoundAgain) {
  const PolygonMesh mesh = grid();
  const TangentComplex dual = build_dual(mesh).value();
  const Selection panels = named_panels(dual, {7, 3});
  EXPECT_EQ(panels.vertices.size(), 2u);
  EXPECT_TRUE(std::is_sorted(panels.vertices.begin(), panels.vertices.end()));
  EXPECT_EQ(panels_named(dual, panels), (std::vector<int>{3, 7}));
  EXPECT_TRUE(points_named(dual, panels).empty()) << "vertices of a dual mean panels";
  for (int j = 0; j < dual.point_count(); ++j) {
    const Selection point = named_points(dual, {j});
    if (dual.point_origin[static_cast<std::size_t>(j)].kind == PointKind::Corner) {
      EXPECT_TRUE(point.empty());
    } else {
      EXPECT_EQ(points_named(dual, point), std::vector<int>{j});
      EXPECT_TRUE(panels_named(dual, point).empty());
    }
  }
  const TangentComplex faces = build_planarize(mesh).value();
  EXPECT_EQ(named_panels(faces, {5}).faces, std::vector<int>{faces.plane_origin[5]});
  EXPECT_EQ(points_named(faces, named_points(faces, {9})), std::vector<int>{9});
}

TEST(Select, PanelsOfClustersAreAllFacesOfTheirRegions) {
  const PolygonMesh mesh = test::sphere(6).mesh();
  const FaceGraph graph = test::graph_of(mesh);
  ClusterOptions options;
  options.panels = 12;
  const Regions regions = make_regions(graph, cluster(graph, options).value()).value();
  const TangentComplex complex = build_cluster(mesh, regions).value();
  Selection named = named_panels(complex, {3, 5});
  EXPECT_EQ(panels_named(complex, named), (std::vector<int>{3, 5}));
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int r = regions.region_of_face[f];
    EXPECT_EQ(std::binary_search(named.faces.begin(), named.faces.end(), f), r == 3 || r == 5);
  }
  std::erase_if(named.faces, [&](int f) { return f == named.faces.front(); });
  EXPECT_EQ(panels_named(complex, named).size(), 1u);
  EXPECT_TRUE(panels_named(complex, {}).empty());
  EXPECT_EQ(PanelNumbers(mesh).number(ComplexKind::Cluster, BorderPolicy::Closed, {}, 5), 5);
}

}  // namespace
}  // namespace planewright
