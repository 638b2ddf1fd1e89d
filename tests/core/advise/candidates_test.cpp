#include "core/advise/candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "core/diagnose/diagnosis.h"
#include "support/advised.h"
#include "support/complexes.h"

namespace planewright {
namespace {

using test::planarizing;
using test::solved;
using test::unsolved;

// Six by six squares, cut along one diagonal each; vertex (x, y) is y * 7 + x.
test::Shape squares() {
  return test::triangle_grid(6, 6);
}
constexpr int at(int x, int y) {
  return 7 * y + x;
}

Finding finding_at(std::vector<int> mesh_edges, FindingKind kind = FindingKind::ReversedEdge) {
  Finding finding;
  finding.kind = kind;
  finding.mesh_edges = std::move(mesh_edges);
  return finding;
}

std::string reason(const LastResorts& resorts, const MeshEdit& edit) {
  for (const LastResorts::Refused& refused : resorts.refused)
    if (refused.edit == edit) return refused.reason;
  return "";
}

TEST(Candidates, AreFlipsRoundAFlaggedEdgeAndItsJoin) {
  const PolygonMesh mesh = squares().mesh();
  const Advised advised = unsolved(mesh);
  const int e = mesh.find_edge(at(2, 2), at(3, 3));
  std::set<std::pair<EditKind, int>> found;
  for (const Candidate& candidate : find_candidates(advised, {finding_at({e})})) {
    EXPECT_TRUE(may_apply(mesh, candidate.edit)) << describe(candidate.edit);
    EXPECT_TRUE(found.insert({candidate.edit.kind, candidate.edit.element}).second);
    EXPECT_EQ(candidate.mesh_edge, candidate.edit.element);
    EXPECT_EQ(candidate.centre.size(), 4u);
    EXPECT_EQ(candidate.given_up, candidate.edit.kind == EditKind::Join ? 1.0 : 0.0);
    EXPECT_NEAR(candidate.deviation, 0.0, 1e-12);  // the squares are flat
  }
  // The sides of a square are flips that turn its triangles into a parallelogram's: they do not fold.
  std::set<std::pair<EditKind, int>> expected{{EditKind::Join, e}, {EditKind::Flip, e}};
  for (const auto& [a, b] : std::vector<std::pair<int, int>>{
           {at(2, 2), at(3, 2)}, {at(3, 2), at(3, 3)}, {at(3, 3), at(2, 3)}, {at(2, 3), at(2, 2)}})
    expected.insert({EditKind::Flip, mesh.find_edge(a, b)});
  EXPECT_EQ(found, expected);
}

TEST(Candidates, ComeByUrgencyThenEdgeThenKind) {
  const PolygonMesh mesh = make_sample("bad-saddle", 300).value();
  const Advised advised = solved(mesh);
  const auto findings = diagnose(*advised.complex, advised.state).findings;
  const auto found = find_candidates(advised, findings);
  ASSERT_GT(found.size(), 5u);
  for (size_t k = 1; k < found.size(); ++k) {
    const Candidate &a = found[k - 1], &b = found[k];
    EXPECT_LT(std::tuple(a.urgency, a.mesh_edge, a.edit.kind),
              std::tuple(b.urgency, b.mesh_edge, b.edit.kind));
  }
  for (const Candidate& candidate : found) EXPECT_LE(candidate.deviation, 0.35);
  // The same, whatever order the findings come in.
  const auto turned = find_candidates(advised, {findings.rbegin(), findings.rend()});
  ASSERT_EQ(turned.size(), found.size());
  for (size_t k = 0; k < found.size(); ++k) EXPECT_EQ(turned[k].edit, found[k].edit);
}

TEST(Candidates, OnlyOfFindingsThatCallForEdits) {
  const PolygonMesh mesh = squares().mesh();
  const int e = mesh.find_edge(at(2, 2), at(3, 3));
  EXPECT_TRUE(find_candidates(unsolved(mesh), {finding_at({e}, FindingKind::NotConvex)}).empty());
  EXPECT_TRUE(find_candidates(unsolved(mesh), {}).empty());
}

TEST(Candidates, NoFlipFoldsTheMesh) {
  // A corner of the square moved past the other diagonal: flat, but no longer convex.
  test::Shape shape = squares();
  shape.positions.row(at(2, 2)) << 2.6, 2.6, 0.0;
  const PolygonMesh mesh = shape.mesh();
  const int e = mesh.find_edge(at(2, 2), at(3, 3));
  ASSERT_TRUE(may_apply(mesh, MeshEdit::flip(e)));
  const auto found = candidates_at(unsolved(mesh), e, true);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().edit, MeshEdit::join(e));
  EXPECT_EQ(reason(last_resorts(unsolved(mesh), finding_at({e})), MeshEdit::flip(e)),
            "the mesh would fold over");
}

TEST(Candidates, NoneMovesTheSurfaceFar) {
  // A ridge along the diagonal; a flip would cut it off.
  const auto ridge = [](double height) {
    test::Shape shape = squares();
    shape.positions(at(2, 2), 2) = shape.positions(at(3, 3), 2) = height;
    return shape.mesh();
  };
  const PolygonMesh low = ridge(0.1), high = ridge(0.5);
  const int e = low.find_edge(at(2, 2), at(3, 3));
  const Advised advised = unsolved(low);
  const auto found = candidates_at(advised, e, false);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found.front().deviation, 0.1 / advised.complex->mean_edge, 1e-12);
  EXPECT_TRUE(candidates_at(unsolved(high), e, true).empty());
  const LastResorts resorts = last_resorts(unsolved(high), finding_at({e}));
  EXPECT_EQ(reason(resorts, MeshEdit::flip(e)), "it would change the surface too much");
  EXPECT_EQ(reason(resorts, MeshEdit::join(e)), "it would change the surface too much");
}

TEST(Candidates, PanelsOfADualKeepFourCorners) {
  const PolygonMesh mesh = test::octahedron().mesh();  // four faces at every vertex
  for (int e = 0; e < mesh.edge_count(); ++e) {
    EXPECT_TRUE(candidates_at(unsolved(mesh), e, true).empty());
    const LastResorts resorts = last_resorts(unsolved(mesh), finding_at({e}));
    EXPECT_FALSE(reason(resorts, MeshEdit::join(e)).empty());
    EXPECT_FALSE(reason(resorts, MeshEdit::collapse(e)).empty());
    for (const Candidate& candidate : resorts.allowed) EXPECT_EQ(candidate.edit.kind, EditKind::SplitEdge);
  }
}

TEST(Candidates, OfACollapsedQuadCollapseItAndMoveItsSingularCorners) {
  const PolygonMesh mesh = test::cube().mesh();  // three quads at every vertex
  Finding finding = finding_at({}, FindingKind::CollapsedQuad);
  finding.element = {ElementKind::Panel, 0};
  const Advised advised = unsolved(mesh, planarizing());
  std::set<int> moved;
  for (const Candidate& candidate : find_candidates(advised, {finding})) {
    EXPECT_TRUE(may_apply(mesh, candidate.edit));
    if (candidate.edit.kind != EditKind::MoveVertex) continue;
    const int v = candidate.edit.element;
    EXPECT_EQ(candidate.centre, std::vector{v});
    Vector3d middle = Vector3d::Zero();
    for (const int e : mesh.edges_around(v))
      middle += mesh.positions().row(mesh.edge(e).a == v ? mesh.edge(e).b : mesh.edge(e).a).transpose() / 3.0;
    EXPECT_LT((*candidate.edit.to - middle).norm(), 1e-12);
    moved.insert(v);
  }
  const std::vector<int> corners = mesh.corners(advised.complex->plane_origin[0]);
  EXPECT_EQ(moved, std::set<int>(corners.begin(), corners.end()));
}

TEST(Candidates, OfAStripCollapseTheShortEdgesOfItsTurningQuads) {
  const PolygonMesh mesh = make_sample("turning-strip", 300).value();
  const Advised advised = solved(mesh, planarizing());
  const auto findings = diagnose(*advised.complex, advised.state).findings;
  std::set<int> edges;
  for (const Candidate& candidate : find_candidates(advised, findings)) {
    ASSERT_EQ(candidate.edit.kind, EditKind::Collapse);  // its inner corners are all regular
    EXPECT_TRUE(may_apply(mesh, candidate.edit));
    const MeshEdge edge = mesh.edge(candidate.edit.element);
    EXPECT_EQ(candidate.centre, (std::vector{edge.a, edge.b}));
    EXPECT_LT(candidate.urgency, 1.0);  // shorter than the mean
    edges.insert(candidate.edit.element);
  }
  EXPECT_GT(edges.size(), 3u);
}

TEST(LastResorts, AreEveryEditByEdgeAndKindOrItsReason) {
  const PolygonMesh mesh = squares().mesh();
  // At the border, where some are refused.
  const int e = mesh.find_edge(at(0, 2), at(1, 3));
  const LastResorts resorts = last_resorts(unsolved(mesh), finding_at({e}));
  std::set<int> edges;
  for (const int face : {mesh.edge(e).left, mesh.edge(e).right}) {
    const std::vector<int> corners = mesh.corners(face);
    for (size_t k = 0; k < 3; ++k) edges.insert(mesh.find_edge(corners[k], corners[(k + 1) % 3]));
  }
  ASSERT_EQ(edges.size(), 5u);
  std::vector<MeshEdit> expected;
  for (const int edge : edges)
    for (const MeshEdit& edit :
         {MeshEdit::flip(edge), MeshEdit::join(edge), MeshEdit::split_edge(edge), MeshEdit::collapse(edge)})
      expected.push_back(edit);
  std::vector<MeshEdit> allowed, refused;
  for (const Candidate& candidate : resorts.allowed) allowed.push_back(candidate.edit);
  for (const LastResorts::Refused& each : resorts.refused) {
    refused.push_back(each.edit);
    EXPECT_FALSE(each.reason.empty()) << describe(each.edit);
  }
  EXPECT_GT(allowed.size(), 4u);
  EXPECT_GT(refused.size(), 1u);
  // Each in one of the lists, in this order.
  auto next_allowed = allowed.begin();
  auto next_refused = refused.begin();
  for (const MeshEdit& edit : expected) {
    if (next_allowed != allowed.end() && *next_allowed == edit)
      ++next_allowed;
    else if (next_refused != refused.end() && *next_refused == edit)
      ++next_refused;
    else
      ADD_FAILURE() << describe(edit) << " is missing, or out of order";
  }
  EXPECT_EQ(next_allowed, allowed.end());
  EXPECT_EQ(next_refused, refused.end());
}

TEST(LastResorts, TellWhatTheyGiveUp) {
  const PolygonMesh mesh = squares().mesh();
  const int e = mesh.find_edge(at(2, 2), at(3, 3));
  for (const Candidate& candidate : last_resorts(unsolved(mesh), finding_at({e})).allowed) {
    EXPECT_TRUE(may_apply(mesh, candidate.edit));
    const double expected = candidate.edit.kind == EditKind::Flip       ? 0.0
                            : candidate.edit.kind == EditKind::Collapse ? 2.0
                                                                        : 1.0;
    EXPECT_EQ(candidate.given_up, expected) << describe(candidate.edit);
  }
}

TEST(LastResorts, NoCollapseFoldsOrMovesTheSurface) {
  const auto why = [](test::Shape shape) {
    const PolygonMesh mesh = shape.mesh();
    const int e = mesh.find_edge(at(2, 2), at(3, 3));
    EXPECT_TRUE(may_apply(mesh, MeshEdit::collapse(e)));
    return reason(last_resorts(unsolved(mesh), finding_at({e})), MeshEdit::collapse(e));
  };
  EXPECT_EQ(why(squares()), "");
  test::Shape hill = squares();
  hill.positions(at(3, 3), 2) = 1.0;  // a collapse would take half of it away
  EXPECT_EQ(why(hill), "it would change the surface too much");
  test::Shape narrow = squares();
  narrow.positions.row(at(2, 3)) << 2.9, 3.0, 0.0;  // flat, and in the way of (3, 3) going to the middle
  narrow.positions.row(at(3, 4)) << 2.6, 3.2, 0.0;
  EXPECT_EQ(why(narrow), "the mesh would fold over");
}

}  // namespace
}  // namespace planewright
