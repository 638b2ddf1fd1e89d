#include "core/diagnose/reversed_edges.h"

#include <gtest/gtest.h>

#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;

TEST(SignedLength, IsPositiveWherePanelsRunAsTheyShould) {
  for (const auto& [label, complex] : small_complexes()) {
    const State state = initial_state(*complex);
    for (size_t e = 0; e < complex->panel_edges.size(); ++e) {
      const PanelEdge& edge = complex->panel_edges[e];
      EXPECT_DOUBLE_EQ(signed_length(*complex, state, static_cast<int>(e)),
                       (state.x.row(edge.a) - state.x.row(edge.b)).norm())
          << label << " " << e;
    }
  }
}

TEST(ReversedEdges, OfAMeshRunAgainstTheirDirectionInTheInput) {
  Scene scene = Scene::flat_grid(3, 3);
  EXPECT_TRUE(find_reversed_edges(scene.subject(), 1e-3).empty());
  scene.put(5, 2.0, 1.0);
  scene.put(6, 1.5, 1.0);
  const auto found = find_reversed_edges(scene.subject(), 1e-3);
  ASSERT_EQ(indices_of(found), std::vector<int>{scene.panel_edge(5, 6)});
  expect_well_formed(found[0]);
  EXPECT_NEAR(found[0].measure, 0.5, 1e-12);
  EXPECT_EQ(found[0].mesh_edges, std::vector<int>{scene.mesh.find_edge(5, 6)});
  EXPECT_TRUE(find_reversed_edges(scene.subject(), 0.6).empty());
}

TEST(ReversedEdges, OfADualRunBackwardsOverTheirMeshEdge) {
  Scene scene(dual_of(triangle_grid(4, 4).mesh()));
  EXPECT_TRUE(find_reversed_edges(scene.subject(), 1e-3).empty());
  // The faces of the quad in the middle change places.
  const int a = 2 * 5, b = a + 1;
  scene.state.x.row(a).swap(scene.state.x.row(b));
  const int edge = scene.panel_edge(a, b);
  ASSERT_GE(edge, 0);
  EXPECT_LT(signed_length(*scene.complex, scene.state, edge), 0.0);
  bool found = false;
  for (const Finding& finding : find_reversed_edges(scene.subject(), 1e-3)) {
    expect_well_formed(finding);
    if (finding.element.index != edge) continue;
    found = true;
    const auto [i, j] = scene.complex->crossed_edge[edge];
    EXPECT_EQ(finding.mesh_edges, std::vector<int>{scene.mesh.find_edge(i, j)});
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace planewright
