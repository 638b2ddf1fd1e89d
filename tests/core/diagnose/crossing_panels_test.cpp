#include "core/diagnose/crossing_panels.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <set>

#include "core/complex/explicit_intersection.h"
#include "core/diagnose/crossing_suspects.h"
#include "core/diagnose/crossings.h"
#include "core/diagnose/panel_shape.h"
#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;
using Pair = std::array<int, 2>;

// Every pair that the exact test finds among all is a suspect; the number of suspects.
size_t expect_none_missed(const Points& points, const Polygons& panels, const Points& normals, double touch,
                          const std::string& label) {
  const auto suspects = crossing_suspects(points, panels, normals, touch, 1e-9);
  EXPECT_TRUE(std::is_sorted(suspects.begin(), suspects.end()));
  const auto tangled = find_self_crossing(points, panels);  // the exact test fills their loops at will
  const auto is_tangled = [&](int p) { return std::binary_search(tangled.begin(), tangled.end(), p); };
  for (const Crossing& crossing : find_crossings_within({points, panels}, touch))
    EXPECT_TRUE(is_tangled(crossing.first) || is_tangled(crossing.second) ||
                std::binary_search(suspects.begin(), suspects.end(), Pair{crossing.first, crossing.second}))
        << label << ": " << crossing.first << " and " << crossing.second << ", " << crossing.depth << " deep";
  return suspects.size();
}

TEST(CrossingSuspects, MissNoneOfRandomTriangles) {
  std::mt19937 random(3);
  const auto next = [&] { return static_cast<double>(random()) / 4294967295.0; };
  for (const double size : {0.2, 0.6, 1.5}) {
    constexpr int kCount = 150;
    Points points(3 * kCount, 3), normals(kCount, 3);
    Polygons panels;
    for (int t = 0; t < kCount; ++t) {
      const Vector3d centre(next(), next(), next());
      for (int k = 0; k < 3; ++k)
        points.row(3 * t + k) = centre + size * (Vector3d(next(), next(), next()).array() - 0.5).matrix();
      const Vector3d u = points.row(3 * t + 1) - points.row(3 * t),
                     v = points.row(3 * t + 2) - points.row(3 * t);
      normals.row(t) = u.cross(v).normalized();
      panels.push_back(std::array{3 * t, 3 * t + 1, 3 * t + 2});
    }
    for (const double touch : {0.0, 0.01}) {
      const size_t suspects = expect_none_missed(points, panels, normals, touch, "soup");
      EXPECT_LE(suspects, find_crossings_within({points, panels}, touch).size() + kCount);
    }
  }
}

// Planar panels that share corners: the planes of a torus, tilted at random, and where three of them meet.
TEST(CrossingSuspects, MissNoneOfPanelsThatShareCorners) {
  for (const double tilt : {0.02, 0.05, 0.1, 0.2}) {
    TangentComplex complex = *dual_of(make_torus(10, 16));
    complex.normals = perturbed(complex, tilt, 5).n;
    const State state = explicit_intersection(complex).state;
    expect_none_missed(state.x, complex.panels, state.n, 1e-3 * complex.mean_edge, std::to_string(tilt));
  }
}

TEST(CrossingSuspects, AreNoneInACleanDesignFlatOrBent) {
  const Scene flat(dual_of(triangle_grid(6, 6).mesh()));
  EXPECT_TRUE(crossing_suspects(flat.state.x, flat.complex->panels, flat.state.n, 1e-3, 1e-9).empty());
  const SharedComplex torus = dual_of(make_torus(12, 20));
  const State state = explicit_intersection(*torus).state;
  EXPECT_LT(crossing_suspects(state.x, torus->panels, state.n, 1e-3 * torus->mean_edge, 1e-9).size(), 3u);
}

// Two quads through each other, that share no corner.
TEST(CrossingPanels, GoThroughAnother) {
  const Shape shape{make_points({{-1, -1, 0},
                                 {1, -1, 0},
                                 {1, 1, 0},
                                 {-1, 1, 0},
                                 {0, -1, -0.5},
                                 {0, 1, -0.5},
                                 {0, 1, 1},
                                 {0, -1, 1}}),
                    {{0, 1, 2, 3}, {4, 5, 6, 7}}};
  const Scene scene(planarize_of(shape.mesh()));
  const auto found = find_crossing_panels(scene.subject(), {});
  ASSERT_EQ(found.size(), 1u);
  expect_well_formed(found[0]);
  EXPECT_EQ(found[0].kind, FindingKind::CrossingPanels);
  EXPECT_EQ(found[0].element, (ElementRef{ElementKind::Panel, 0}));
  EXPECT_EQ(found[0].second, (ElementRef{ElementKind::Panel, 1}));
  EXPECT_NEAR(found[0].measure, 0.5 / scene.complex->mean_edge, 1e-9);
  EXPECT_EQ(found[0].mesh_edges.size(), 8u);

  FindingSettings settings;
  settings[FindingKind::CrossingPanels].threshold = 0.6;
  EXPECT_TRUE(find_crossing_panels(scene.subject(), settings).empty());
  settings = {};
  settings[FindingKind::CrossingPanels].on = false;
  EXPECT_TRUE(find_crossing_panels(scene.subject(), settings).empty());
}

// The right quad of two turned back over the left one, within their plane.
TEST(FoldedOver, LiesOverANeighbour) {
  Scene scene = Scene::flat_grid(2, 1);
  EXPECT_TRUE(find_crossing_panels(scene.subject(), {}).empty());
  scene.put(2, 0.3, 0.0);
  scene.put(5, 0.3, 1.0);
  const auto found = find_crossing_panels(scene.subject(), {});
  ASSERT_EQ(found.size(), 2u);
  for (const Finding& finding : found) {
    expect_well_formed(finding);
    EXPECT_EQ(finding.kind, FindingKind::FoldedOver);
  }
  EXPECT_EQ(found[0].element.index, 1);  // turned over
  EXPECT_FALSE(found[0].second);
  EXPECT_NEAR(found[0].measure, std::sqrt(0.7), 1e-12);
  EXPECT_EQ(found[1].element.index, 0);
  EXPECT_EQ(found[1].second, (ElementRef{ElementKind::Panel, 1}));
  EXPECT_EQ(found[1].mesh_edges, std::vector<int>{scene.mesh.find_edge(1, 4)});
  FindingSettings settings;
  settings[FindingKind::FoldedOver].on = false;
  EXPECT_TRUE(find_crossing_panels(scene.subject(), settings).empty());
}

// Two panels that share one corner, one of which stands up through the other.
TEST(FoldedOver, GoesThroughANeighbourAtACorner) {
  Scene scene = Scene::flat_grid(2, 2);
  const auto put = [&](int point, double along, double height) {
    scene.put(point, along, 0.8 * along + 0.2);
    scene.state.x(point, 2) = height;
  };
  put(5, 0.6, -0.4);
  put(8, 0.3, 0.1);
  put(7, 0.6, 0.5);
  scene.state.n.row(3) = Vector3d(0.8, -1, 0).normalized();
  const auto found = find_crossing_panels(scene.subject(), {});
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const Finding& finding) {
    return finding.kind == FindingKind::FoldedOver && finding.element.index == 0 && finding.second &&
           finding.second->index == 3;
  }));
}

}  // namespace
}  // namespace planewright
