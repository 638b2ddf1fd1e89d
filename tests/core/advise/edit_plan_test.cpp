#include "core/advise/edit_plan.h"

#include <gtest/gtest.h>

#include "core/mesh/sample_shapes.h"

namespace planewright {
namespace {

Suggestion at_edge(const PolygonMesh& mesh, int e, MeshEdit edit) {
  Suggestion suggestion;
  suggestion.candidate.edit = std::move(edit);
  suggestion.candidate.mesh_edge = e;
  suggestion.candidate.centre = {mesh.edge(e).a, mesh.edge(e).b};
  return suggestion;
}

TEST(EditPlan, ChoosesTheBestAndKeepsAway) {
  const PolygonMesh mesh = make_sample("dome", 2000).value();
  std::vector<Suggestion> ranked;
  for (int e = 0; e < mesh.edge_count(); ++e) ranked.push_back(at_edge(mesh, e, MeshEdit::flip(e)));
  const std::vector<int> chosen = choose_apart(mesh, ranked);
  ASSERT_GT(chosen.size(), 20u);
  EXPECT_EQ(chosen.front(), 0);
  // Distances in edges from the first chosen centre, by breadth.
  std::vector<int> distance(static_cast<size_t>(mesh.vertex_count()), -1);
  std::vector<int> queue{mesh.edge(0).a, mesh.edge(0).b};
  for (const int v : queue) distance[static_cast<size_t>(v)] = 0;
  for (size_t k = 0; k < queue.size(); ++k)
    for (const int e : mesh.edges_around(queue[k])) {
      const int other = mesh.edge(e).a == queue[k] ? mesh.edge(e).b : mesh.edge(e).a;
      if (distance[static_cast<size_t>(other)] >= 0) continue;
      distance[static_cast<size_t>(other)] = distance[static_cast<size_t>(queue[k])] + 1;
      queue.push_back(other);
    }
  int nearest = mesh.vertex_count();
  for (size_t k = 1; k < chosen.size(); ++k)
    for (const int v : ranked[static_cast<size_t>(chosen[k])].candidate.centre)
      nearest = std::min(nearest, distance[static_cast<size_t>(v)]);
  EXPECT_EQ(nearest, kApart);  // no nearer, and no farther than needed
}

TEST(EditPlan, OfTheSamePlaceOnlyTheBetter) {
  const PolygonMesh mesh = make_sample("dome", 200).value();
  const int e = mesh.edge_count() / 2;
  EXPECT_EQ(choose_apart(mesh, {at_edge(mesh, e, MeshEdit::join(e)), at_edge(mesh, e, MeshEdit::flip(e))}),
            std::vector{0});
}

TEST(EditPlan, NamesElementsOfTheMeshThatTheEditsBeforeMade) {
  const PolygonMesh mesh = make_sample("dome", 200).value();
  std::vector<int> inner;
  for (int e = 0; e < mesh.edge_count(); ++e)
    if (!mesh.is_border_vertex(mesh.edge(e).a) && !mesh.is_border_vertex(mesh.edge(e).b)) inner.push_back(e);
  const int first = inner.front(), last = inner.back();
  const Vector3d middle =
      0.5 * (mesh.positions().row(mesh.edge(last).a) + mesh.positions().row(mesh.edge(last).b));
  const auto edits = in_order(mesh, {MeshEdit::collapse(first), MeshEdit::split_edge(last)});
  ASSERT_EQ(edits.size(), 2u);
  EXPECT_EQ(edits[0], MeshEdit::collapse(first));
  const PolygonMesh collapsed = apply(mesh, edits[0]).value().mesh;
  const MeshEdge split = collapsed.edge(edits[1].element);
  EXPECT_LT(
      (0.5 * (collapsed.positions().row(split.a) + collapsed.positions().row(split.b)).transpose() - middle)
          .norm(),
      1e-12);
  EXPECT_TRUE(apply(collapsed, edits[1]).has_value());
}

TEST(EditPlan, EndsWhereAnEditIsRefused) {
  const PolygonMesh mesh = make_sample("dome", 200).value();
  int border = 0;
  while (!mesh.edge(border).border()) ++border;
  int inner = 0;
  while (!mesh.can_flip(inner)) ++inner;
  EXPECT_EQ(in_order(mesh, {MeshEdit::flip(inner), MeshEdit::flip(border), MeshEdit::flip(inner)}),
            std::vector{MeshEdit::flip(inner)});
}

}  // namespace
}  // namespace planewright
