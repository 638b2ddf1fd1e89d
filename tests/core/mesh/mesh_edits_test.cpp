#include "core/mesh/mesh_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "support/shapes.h"

namespace planewright {
namespace {

using test::cube;
using test::fan;
using test::grid;
using test::make_points;
using test::octahedron;
using test::Shape;
using test::tetrahedron;
using test::triangle_grid;

std::vector<int> from_lowest(std::vector<int> corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::vector<std::vector<int>> faces_of(const PolygonMesh& mesh) {
  std::vector<std::vector<int>> faces;
  for (int f = 0; f < mesh.face_count(); ++f) faces.push_back(from_lowest(mesh.corners(f)));
  return faces;
}

int euler(const PolygonMesh& mesh) {
  int isolated = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) isolated += mesh.is_isolated(v);
  return mesh.vertex_count() - isolated - mesh.edge_count() + mesh.face_count();
}

void expect_one_to_one(const IndexMap& map, int old_count, int new_count) {
  ASSERT_EQ(static_cast<int>(map.to_new.size()), old_count);
  ASSERT_EQ(static_cast<int>(map.to_old.size()), new_count);
  EXPECT_EQ(map, index_map(map.to_old, old_count));
  EXPECT_EQ(inverse(map), index_map(map.to_new, new_count));
}

// What holds for every edit, besides its own result.
EditedMesh edited(const PolygonMesh& mesh, const MeshEdit& edit) {
  EXPECT_TRUE(may_apply(mesh, edit)) << describe(edit);
  const auto result = apply(mesh, edit);
  EXPECT_TRUE(result) << describe(edit) << ": " << result.error().text();
  const EditedMesh& e = *result;
  expect_one_to_one(e.map.vertices, mesh.vertex_count(), e.mesh.vertex_count());
  expect_one_to_one(e.map.edges, mesh.edge_count(), e.mesh.edge_count());
  expect_one_to_one(e.map.faces, mesh.face_count(), e.mesh.face_count());
  for (const auto* map : {&e.map.vertices, &e.map.faces}) {
    std::vector<int> order = map->to_old;
    std::replace(order.begin(), order.end(), -1, std::numeric_limits<int>::max());
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end())) << describe(edit);
  }
  if (edit.kind != EditKind::DeleteFace) {
    EXPECT_EQ(euler(e.mesh), euler(mesh)) << describe(edit);
  }
  return e;
}

void expect_refused(const PolygonMesh& mesh, const MeshEdit& edit, const std::string& why) {
  const auto allowed = may_apply(mesh, edit);
  ASSERT_FALSE(allowed) << describe(edit);
  EXPECT_EQ(allowed.error().code, ErrorCode::Refused);
  EXPECT_NE(allowed.error().what.find(why), std::string::npos) << allowed.error().text();
  EXPECT_FALSE(allowed.error().where.empty());
  EXPECT_FALSE(allowed.error().remedy.empty());
  const auto result = apply(mesh, edit);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().text(), allowed.error().text());
}

TEST(MeshEdits, AreNamed) {
  EXPECT_EQ(describe(MeshEdit::flip(1042)), "Flip edge 1042");
  EXPECT_EQ(describe(MeshEdit::join(3)), "Join faces at edge 3");
  EXPECT_EQ(describe(MeshEdit::split_edge(3)), "Split edge 3");
  EXPECT_EQ(describe(MeshEdit::split_face(3, 0, 2)), "Split face 3");
  EXPECT_EQ(describe(MeshEdit::collapse(3)), "Collapse edge 3");
  EXPECT_EQ(describe(MeshEdit::move_vertex(3, {0, 0, 0})), "Move vertex 3");
  EXPECT_EQ(describe(MeshEdit::delete_face(3)), "Delete face 3");
}

TEST(MeshEdits, HaveAKindThatReportsName) {
  EXPECT_STREQ(name(EditKind::Flip), "flip");
  EXPECT_STREQ(name(EditKind::Join), "join");
  EXPECT_STREQ(name(EditKind::SplitEdge), "split-edge");
  EXPECT_STREQ(name(EditKind::SplitFace), "split-face");
  EXPECT_STREQ(name(EditKind::Collapse), "collapse");
  EXPECT_STREQ(name(EditKind::MoveVertex), "move-vertex");
  EXPECT_STREQ(name(EditKind::DeleteFace), "delete-face");
}

TEST(MeshEdits, AreEqualIfTheyDoTheSame) {
  EXPECT_EQ(MeshEdit::flip(3), MeshEdit::flip(3));
  EXPECT_NE(MeshEdit::flip(3), MeshEdit::join(3));
  EXPECT_NE(MeshEdit::split_edge(3), MeshEdit::split_edge(3, Vector3d(1, 2, 3)));
  EXPECT_EQ(MeshEdit::move_vertex(3, {1, 2, 3}), MeshEdit::move_vertex(3, {1, 2, 3}));
}

TEST(MeshEdits, RefuseElementsThatAreNotThere) {
  const PolygonMesh mesh = grid(2, 1).mesh();
  for (const int wrong : {-1, 1000}) {
    for (const MeshEdit& edit : {MeshEdit::flip(wrong), MeshEdit::join(wrong), MeshEdit::split_edge(wrong),
                                 MeshEdit::collapse(wrong)}) {
      expect_refused(mesh, edit, "no such edge");
    }
    expect_refused(mesh, MeshEdit::split_face(wrong, 0, 1), "no such face");
    expect_refused(mesh, MeshEdit::delete_face(wrong), "no such face");
    expect_refused(mesh, MeshEdit::move_vertex(wrong, {0, 0, 0}), "no such vertex");
  }
}

TEST(Flip, ChangesNoIndex) {
  const PolygonMesh mesh = triangle_grid(1, 1).mesh();
  const int e = mesh.find_edge(0, 3);
  const EditedMesh after = edited(mesh, MeshEdit::flip(e));
  EXPECT_EQ(after.map, identity_map(mesh));
  EXPECT_EQ(after.mesh.find_edge(1, 2), e);
  EXPECT_EQ(mesh.find_edge(0, 3), e) << "the mesh before stays";
}

TEST(Flip, IsRefusedWithTheReason) {
  const PolygonMesh triangles = triangle_grid(1, 1).mesh(), quads = grid(2, 1).mesh();
  expect_refused(triangles, MeshEdit::flip(triangles.find_edge(0, 1)), "border");
  expect_refused(quads, MeshEdit::flip(quads.find_edge(1, 4)), "two triangles");
  expect_refused(tetrahedron().mesh(), MeshEdit::flip(0), "exists already");
  const PolygonMesh hub = fan(3).mesh();
  expect_refused(hub, MeshEdit::flip(hub.find_edge(0, 1)), "exists already");
}

TEST(Join, MakesOneFaceOfTwo) {
  const PolygonMesh mesh = triangle_grid(2, 1).mesh();  // vertices 0 1 2 below, 3 4 5 above
  const EditedMesh after = edited(mesh, MeshEdit::join(mesh.find_edge(0, 4)));
  EXPECT_EQ(faces_of(after.mesh), (std::vector<std::vector<int>>{{0, 1, 4, 3}, {1, 2, 5}, {1, 5, 4}}));
  EXPECT_EQ(after.map.faces.to_new, (std::vector<int>{0, -1, 1, 2}));
  EXPECT_EQ(after.map.edges.to_new[static_cast<size_t>(mesh.find_edge(0, 4))], -1);
  EXPECT_EQ(after.map.edges.to_new[static_cast<size_t>(mesh.find_edge(1, 4))], after.mesh.find_edge(1, 4));
  EXPECT_EQ(after.mesh.positions(), mesh.positions());
}

TEST(Join, TakesFacesOfAnyValence) {
  const PolygonMesh mesh = grid(2, 1).mesh();
  const EditedMesh after = edited(mesh, MeshEdit::join(mesh.find_edge(1, 4)));
  EXPECT_EQ(faces_of(after.mesh), (std::vector<std::vector<int>>{{0, 1, 2, 5, 4, 3}}));
}

TEST(Join, IsRefusedWithTheReason) {
  const PolygonMesh quads = grid(2, 2).mesh();
  expect_refused(quads, MeshEdit::join(quads.find_edge(0, 1)), "border");
  const PolygonMesh closed = cube().mesh();
  expect_refused(closed, MeshEdit::join(0), "two edges inside");
  const PolygonMesh split = edited(quads, MeshEdit::split_edge(quads.find_edge(3, 4))).mesh;
  expect_refused(split, MeshEdit::join(split.find_edge(3, 9)), "share more than this edge");
  // A ring of three quads: each two meet at one edge; joined, the third meets the result at two.
  const PolygonMesh ring =
      PolygonMesh::from_polygons(
          make_points({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}}),
          {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}})
          .value();
  const PolygonMesh two = edited(ring, MeshEdit::join(ring.find_edge(1, 4))).mesh;
  expect_refused(two, MeshEdit::join(two.find_edge(2, 5)), "also meet at vertex");
}

TEST(SplitEdge, SplitsTrianglesToTheirOppositeCorner) {
  const PolygonMesh mesh = triangle_grid(1, 1).mesh();  // {0, 1, 3}, {0, 3, 2}
  const int e = mesh.find_edge(0, 3);
  ASSERT_EQ(mesh.edge(e).a, 3) << "the edge of its first corner";
  const EditedMesh after = edited(mesh, MeshEdit::split_edge(e));
  EXPECT_EQ(faces_of(after.mesh),
            (std::vector<std::vector<int>>{{1, 3, 4}, {2, 4, 3}, {0, 1, 4}, {0, 4, 2}}));
  EXPECT_EQ(after.mesh.positions().row(4), Eigen::RowVector3d(0.5, 0.5, 0));
  EXPECT_EQ(after.mesh.positions().topRows(4), mesh.positions());
  EXPECT_EQ(after.map.vertices.to_old, (std::vector<int>{0, 1, 2, 3, -1}));
  EXPECT_EQ(after.map.faces.to_old, (std::vector<int>{0, 1, -1, -1}));
  EXPECT_EQ(after.map.edges.to_new[static_cast<size_t>(e)], after.mesh.find_edge(3, 4));
  EXPECT_EQ(after.map.edges.to_old[static_cast<size_t>(after.mesh.find_edge(0, 4))], -1);
}

TEST(SplitEdge, GivesLargerFacesACorner) {
  const PolygonMesh mesh = grid(2, 1).mesh();
  const EditedMesh after = edited(mesh, MeshEdit::split_edge(mesh.find_edge(1, 4), Vector3d(1, 0.25, 7)));
  EXPECT_EQ(faces_of(after.mesh), (std::vector<std::vector<int>>{{0, 1, 6, 4, 3}, {1, 2, 5, 4, 6}}));
  EXPECT_EQ(after.mesh.positions().row(6), Eigen::RowVector3d(1, 0.25, 7));
  const EditedMesh border = edited(mesh, MeshEdit::split_edge(mesh.find_edge(0, 3)));
  EXPECT_EQ(faces_of(border.mesh).front(), (std::vector<int>{0, 1, 4, 3, 6}));
}

TEST(SplitEdge, IsRefusedWhereNothingIs) {
  const PolygonMesh mesh = grid(2, 1).mesh();
  expect_refused(mesh, MeshEdit::split_edge(0, Vector3d(0, std::numeric_limits<double>::infinity(), 0)),
                 "finite");
}

TEST(SplitFace, ByADiagonal) {
  const PolygonMesh mesh = grid(2, 1).mesh();
  const EditedMesh after = edited(mesh, MeshEdit::split_face(0, 0, 4));
  EXPECT_EQ(faces_of(after.mesh), (std::vector<std::vector<int>>{{0, 1, 4}, {1, 2, 5, 4}, {0, 4, 3}}));
  EXPECT_EQ(after.map.faces.to_old, (std::vector<int>{0, 1, -1}));
  EXPECT_EQ(after.map.edges.to_old[static_cast<size_t>(after.mesh.find_edge(0, 4))], -1);
  const EditedMesh other_way = edited(mesh, MeshEdit::split_face(0, 4, 0));
  EXPECT_EQ(faces_of(other_way.mesh).front(), (std::vector<int>{0, 4, 3}));
  // Join is the way back.
  const EditedMesh back = edited(after.mesh, MeshEdit::join(after.mesh.find_edge(0, 4)));
  EXPECT_EQ(faces_of(back.mesh), faces_of(mesh));
  EXPECT_EQ(composed(after.map, back.map).faces, identity_map(mesh).faces);
}

TEST(SplitFace, IsRefusedWithTheReason) {
  const PolygonMesh quads = grid(2, 1).mesh(), triangles = triangle_grid(1, 1).mesh();
  expect_refused(quads, MeshEdit::split_face(0, 0, 1), "neighbours");
  expect_refused(quads, MeshEdit::split_face(0, 3, 0), "neighbours");
  expect_refused(quads, MeshEdit::split_face(0, 4, 4), "neighbours");
  expect_refused(quads, MeshEdit::split_face(0, 0, 5), "no corner");
  expect_refused(triangles, MeshEdit::split_face(0, 0, 3), "triangle");
  // A pyramid without its base, but the base as a quad below: 0 and 2 are joined by an edge above it.
  const PolygonMesh mesh =
      PolygonMesh::from_polygons(make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
                                 {{0, 3, 2, 1}, {0, 1, 2}, {0, 2, 3}})
          .value();
  expect_refused(mesh, MeshEdit::split_face(0, 0, 2), "joins the two corners already");
}

TEST(Collapse, TakesTrianglesAlong) {
  const PolygonMesh mesh = octahedron().mesh();
  const EditedMesh after = edited(mesh, MeshEdit::collapse(mesh.find_edge(0, 2)));
  EXPECT_EQ(after.mesh.vertex_count(), 5);
  EXPECT_EQ(after.mesh.face_count(), 6);
  EXPECT_EQ(after.mesh.edge_count(), 9);
  EXPECT_EQ(after.map.vertices.to_new, (std::vector<int>{0, 1, -1, 2, 3, 4}));
  EXPECT_EQ(after.mesh.positions().row(0), Eigen::RowVector3d(0.5, 0.5, 0));
  for (const int v : {1, 3, 4, 5}) {
    EXPECT_EQ(after.mesh.positions().row(after.map.vertices.to_new[static_cast<size_t>(v)]),
              mesh.positions().row(v));
  }
  // 0-4 and 2-4 become one edge, the survivor's; 2-1 goes on as 0-1.
  const auto now = [&](int a, int b) {
    return after.map.edges.to_new[static_cast<size_t>(mesh.find_edge(a, b))];
  };
  EXPECT_EQ(now(0, 4), after.mesh.find_edge(0, 3));
  EXPECT_EQ(now(2, 4), -1);
  EXPECT_EQ(now(0, 2), -1);
  EXPECT_EQ(now(2, 1), after.mesh.find_edge(0, 1));
}

TEST(Collapse, TakesACornerFromLargerFaces) {
  const PolygonMesh mesh = grid(3, 3).mesh();  // 4 x 4 vertices, inner 5 6 9 10
  const EditedMesh after = edited(mesh, MeshEdit::collapse(mesh.find_edge(5, 6)));
  EXPECT_EQ(after.mesh.face_count(), 9);
  EXPECT_EQ(after.mesh.vertex_count(), 15);
  EXPECT_EQ(after.mesh.valence(1), 3);
  EXPECT_EQ(after.mesh.valence(4), 3);
  EXPECT_EQ(after.mesh.edges_around(5).size(), 6u);
  const EditedMesh placed = edited(mesh, MeshEdit::collapse(mesh.find_edge(5, 6), Vector3d(1, 2, 3)));
  EXPECT_EQ(placed.mesh.positions().row(5), Eigen::RowVector3d(1, 2, 3));
}

TEST(Collapse, KeepsTheBorderWhereItIs) {
  const PolygonMesh mesh = grid(3, 3).mesh();
  const EditedMesh after = edited(mesh, MeshEdit::collapse(mesh.find_edge(5, 4)));  // 4 is on the border
  EXPECT_EQ(after.map.vertices.to_new[5], -1);
  EXPECT_EQ(after.mesh.positions().row(4), mesh.positions().row(4));
  const EditedMesh along = edited(mesh, MeshEdit::collapse(mesh.find_edge(1, 2)));
  EXPECT_EQ(along.mesh.positions().row(1), Eigen::RowVector3d(1.5, 0, 0));
}

TEST(Collapse, IsRefusedWithTheReason) {
  const PolygonMesh strip = triangle_grid(2, 1).mesh();
  expect_refused(strip, MeshEdit::collapse(strip.find_edge(1, 4)), "border to border");
  expect_refused(tetrahedron().mesh(), MeshEdit::collapse(0), "two edges inside");
  const PolygonMesh triangle =
      PolygonMesh::from_polygons(make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {{0, 1, 2}}).value();
  expect_refused(triangle, MeshEdit::collapse(0), "without a face");
  // Three triangles round a hole: its edges would fold onto each other.
  const PolygonMesh hole =
      PolygonMesh::from_polygons(
          make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 3, 0}, {-3, 3, 0}, {0, -3, 0}}),
          {{1, 0, 5}, {2, 1, 3}, {0, 2, 4}, {5, 3, 1}, {3, 4, 2}, {4, 5, 0}})
          .value();
  expect_refused(hole, MeshEdit::collapse(hole.find_edge(0, 1)), "one edge of four faces");
  // 0 and 2 are joined above the quad that has both as corners.
  const PolygonMesh bag =
      PolygonMesh::from_polygons(make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}}),
                                 {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}})
          .value();
  expect_refused(bag, MeshEdit::collapse(bag.find_edge(0, 2)), "twice");
}

TEST(Collapse, UndoesASplitEdge) {
  for (const PolygonMesh& mesh : {grid(3, 3).mesh(), triangle_grid(3, 3).mesh()}) {
    for (int e = 0; e < mesh.edge_count(); ++e) {
      const EditedMesh split = edited(mesh, MeshEdit::split_edge(e));
      const MeshEdge edge = mesh.edge(e);
      const int half = split.mesh.find_edge(edge.a, mesh.vertex_count());
      if (!may_apply(split.mesh, MeshEdit::collapse(half))) continue;
      const EditedMesh back = edited(split.mesh, MeshEdit::collapse(half));
      EXPECT_EQ(back.mesh.vertex_count(), mesh.vertex_count());
      EXPECT_EQ(back.mesh.face_count(), mesh.face_count());
      EXPECT_EQ(back.mesh.edge_count(), mesh.edge_count());
      EXPECT_GE(back.mesh.find_edge(edge.a, edge.b), 0);
    }
  }
}

// The rules against the plain thing: what is refused would have broken the mesh, or left a vertex without a
// face, or with two edges inside the mesh.
bool breaks(const PolygonMesh& mesh, const std::vector<std::vector<int>>& faces, int gone) {
  Polygons polygons;
  for (const auto& corners : faces) polygons.push_back(corners);
  const auto after = PolygonMesh::from_polygons(mesh.positions(), polygons);
  if (polygons.empty() || !after || euler(*after) != euler(mesh)) return true;
  for (int v = 0; v < after->vertex_count(); ++v) {
    const auto now = after->edges_around(v).size();
    if (now == 0 && v != gone) return true;
    if (now == 2 && !after->is_border_vertex(v) && mesh.edges_around(v).size() > 2) return true;
  }
  return false;
}

TEST(Collapse, IsRefusedOnlyWhereItWouldBreakSomething) {
  int refused = 0, allowed = 0;
  PolygonMesh holed = grid(4, 4).mesh();
  for (const MeshEdit& edit :
       {MeshEdit::delete_face(5), MeshEdit::split_face(9, 12, 18), MeshEdit::split_face(0, 1, 5)}) {
    holed = edited(holed, edit).mesh;
  }
  const PolygonMesh thin = edited(triangle_grid(4, 1).mesh(), MeshEdit::split_edge(3)).mesh;
  for (const PolygonMesh& mesh : {holed, thin, cube().mesh(), octahedron().mesh(), tetrahedron().mesh(),
                                  fan(3).mesh(), fan(6, true).mesh(), triangle_grid(3, 3).mesh()}) {
    for (int e = 0; e < mesh.edge_count(); ++e) {
      const MeshEdge edge = mesh.edge(e);
      std::vector<std::vector<int>> faces;
      for (int f = 0; f < mesh.face_count(); ++f) {
        std::vector<int> corners = mesh.corners(f);
        std::replace(corners.begin(), corners.end(), edge.b, edge.a);
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        if (corners.front() == corners.back()) corners.pop_back();
        if (corners.size() > 2) faces.push_back(corners);
      }
      const bool may = may_apply(mesh, MeshEdit::collapse(e)).has_value();
      EXPECT_EQ(may, !breaks(mesh, faces, edge.b)) << edge.a << " - " << edge.b;
      (may ? allowed : refused) += 1;
    }
  }
  EXPECT_GT(refused, 20);
  EXPECT_GT(allowed, 20);
}

TEST(MoveVertex, MovesItAlone) {
  const PolygonMesh mesh = grid(2, 1).mesh();
  const EditedMesh after = edited(mesh, MeshEdit::move_vertex(4, {1, 2, 3}));
  EXPECT_EQ(after.map, identity_map(mesh));
  Points expected = mesh.positions();
  expected.row(4) << 1, 2, 3;
  EXPECT_EQ(after.mesh.positions(), expected);
  EXPECT_EQ(after.mesh.faces(), mesh.faces());
  expect_refused(mesh, MeshEdit::move_vertex(4, {0, std::numeric_limits<double>::quiet_NaN(), 0}), "finite");
  expect_refused(mesh, {EditKind::MoveVertex, 4}, "missing");
}

TEST(DeleteFace, TakesItsOwnVerticesAlong) {
  const PolygonMesh mesh = grid(2, 1).mesh();
  const EditedMesh after = edited(mesh, MeshEdit::delete_face(0));
  EXPECT_EQ(after.mesh.vertex_count(), 4);
  EXPECT_EQ(after.map.vertices.to_new, (std::vector<int>{-1, 0, 1, -1, 2, 3}));
  EXPECT_EQ(faces_of(after.mesh), (std::vector<std::vector<int>>{{0, 1, 3, 2}}));
  const EditedMesh hole = edited(grid(3, 3).mesh(), MeshEdit::delete_face(4));
  EXPECT_EQ(hole.mesh.vertex_count(), 16);
  EXPECT_EQ(euler(hole.mesh), 0);
}

TEST(DeleteFace, LeavesVerticesThatWereIsolatedBefore) {
  Shape shape = grid(2, 1);
  shape.positions.conservativeResize(7, 3);
  shape.positions.row(6) << 9, 9, 9;
  const EditedMesh after = edited(shape.mesh(), MeshEdit::delete_face(0));
  EXPECT_EQ(after.map.vertices.to_old, (std::vector<int>{1, 2, 4, 5, 6}));
}

TEST(DeleteFace, IsRefusedWithTheReason) {
  expect_refused(grid(1, 1).mesh(), MeshEdit::delete_face(0), "last face");
  const PolygonMesh mesh = fan(6, true).mesh();  // 5 triangles round the hub, open
  expect_refused(mesh, MeshEdit::delete_face(2), "only there");
  edited(mesh, MeshEdit::delete_face(0));
  edited(mesh, MeshEdit::delete_face(4));
}

TEST(ElementMap, ComposesToTheMapOfBothEdits) {
  const PolygonMesh mesh = grid(3, 3).mesh();
  const EditedMesh split = edited(mesh, MeshEdit::split_face(4, 5, 10));
  const EditedMesh gone = edited(split.mesh, MeshEdit::delete_face(0));
  const ElementMap both = composed(split.map, gone.map);
  expect_one_to_one(both.vertices, mesh.vertex_count(), gone.mesh.vertex_count());
  expect_one_to_one(both.edges, mesh.edge_count(), gone.mesh.edge_count());
  expect_one_to_one(both.faces, mesh.face_count(), gone.mesh.face_count());
  EXPECT_EQ(both.vertices.to_new[0], -1);
  EXPECT_EQ(both.vertices.to_new[15], 14);
  EXPECT_EQ(both.faces.to_old, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, -1}));
  EXPECT_EQ(composed(both, identity_map(gone.mesh)), both);
  EXPECT_EQ(inverse(inverse(both)), both);
}

TEST(Renumbered, IsTheSameEditOfTheEditedMesh) {
  const PolygonMesh mesh = grid(3, 3).mesh();
  const ElementMap map = edited(mesh, MeshEdit::delete_face(0)).map;  // vertex 0, edges and a face go
  const int e = mesh.find_edge(9, 10), now = map.edges.to_new[static_cast<size_t>(e)];
  EXPECT_NE(now, e);
  const Vector3d to(1, 2, 3);
  EXPECT_EQ(renumbered(MeshEdit::flip(e), map), MeshEdit::flip(now));
  EXPECT_EQ(renumbered(MeshEdit::join(e), map), MeshEdit::join(now));
  EXPECT_EQ(renumbered(MeshEdit::split_edge(e, to), map), MeshEdit::split_edge(now, to));
  EXPECT_EQ(renumbered(MeshEdit::collapse(e, to), map), MeshEdit::collapse(now, to));
  EXPECT_EQ(renumbered(MeshEdit::move_vertex(10, to), map), MeshEdit::move_vertex(9, to));
  EXPECT_EQ(renumbered(MeshEdit::split_face(4, 5, 10), map), MeshEdit::split_face(3, 4, 9));
  EXPECT_EQ(renumbered(MeshEdit::delete_face(8), map), MeshEdit::delete_face(7));
  for (const MeshEdit& edit : {MeshEdit::join(e), MeshEdit::split_face(4, 5, 10), MeshEdit::delete_face(8)}) {
    EXPECT_EQ(renumbered(edit, identity_map(mesh)), edit);
  }
}

TEST(Renumbered, HasNoElementWhereItIsGone) {
  const PolygonMesh mesh = grid(3, 3).mesh();
  const ElementMap map = edited(mesh, MeshEdit::delete_face(0)).map;
  const int e = mesh.find_edge(0, 1);
  EXPECT_EQ(renumbered(MeshEdit::collapse(e), map).element, -1);
  EXPECT_EQ(renumbered(MeshEdit::move_vertex(0, {1, 2, 3}), map).element, -1);
  EXPECT_EQ(renumbered(MeshEdit::delete_face(0), map).element, -1);
  const MeshEdit split = renumbered(MeshEdit::split_face(0, 0, 5), map);
  EXPECT_EQ(split.element, -1);
  EXPECT_EQ(split.corners, (std::array{-1, 4}));
  // What is gone stays gone.
  EXPECT_EQ(renumbered(split, identity_map(mesh)).element, -1);
}

}  // namespace
}  // namespace planewright
