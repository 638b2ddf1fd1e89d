#include "ui/render/picking.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "core/mesh/triangulate.h"
#include "test_layers.h"
#include "ui/render/edge_list.h"

namespace planewright::render {
namespace {

// Another way to the same answer: meet each triangle's plane and look on which side of its edges that is.
std::optional<Hit> pick_by_planes(const PolygonLayer& layer, const Ray& ray) {
  std::optional<Hit> best;
  for (int i = 0; i < layer.polygons.size(); ++i) {
    for (const auto& t : triangulate(layer.points, layer.polygons[i])) {
      const Vector3d a = layer.points.row(t[0]), b = layer.points.row(t[1]), c = layer.points.row(t[2]);
      const Vector3d normal = (b - a).cross(c - a);
      const double distance = (a - ray.origin).dot(normal) / ray.direction.dot(normal);
      const Vector3d p = ray.origin + distance * ray.direction;
      const bool inside = (b - a).cross(p - a).dot(normal) >= 0 && (c - b).cross(p - b).dot(normal) >= 0 &&
                          (a - c).cross(p - c).dot(normal) >= 0;
      if (inside && distance > 0 && (!best || distance < best->distance)) best = Hit{i, p, distance};
    }
  }
  return best;
}

Camera looking_at(const PolygonLayer& layer, double azimuth, double elevation) {
  Camera camera;
  camera.set_viewport(800, 600);
  camera.set_direction(azimuth, elevation);
  camera.fit(layer.points);
  return camera;
}

std::vector<std::pair<int, int>> edges_of(const PolygonLayer& layer) {
  std::vector<std::pair<int, int>> pairs;
  for (const EdgeUse& edge : list_edges(layer.polygons).edges) pairs.emplace_back(edge.a, edge.b);
  return pairs;
}

TEST(Picking, FindsWhatBruteForceFinds) {
  const PolygonLayer layer = torus(24, 12);
  const Camera camera = looking_at(layer, -2.0, 0.6);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> x(0.0f, 800.0f), y(0.0f, 600.0f);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = camera.ray({x(random), y(random)});
    const auto found = pick_polygon(layer, ray), expected = pick_by_planes(layer, ray);
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (!found) continue;
    ++hits;
    EXPECT_EQ(found->polygon, expected->polygon);
    EXPECT_NEAR((found->position - expected->position).norm(), 0.0, 1e-9);
    EXPECT_NEAR(found->distance, (found->position - ray.origin).norm(), 1e-9);
  }
  EXPECT_GT(hits, 300);
  EXPECT_LT(hits, 900);
}

TEST(Picking, MeetsPolygonsFromEitherSide) {
  const PolygonLayer layer = unit_square();
  EXPECT_TRUE(pick_polygon(layer, {{0.5, 0.5, 3}, {0, 0, -1}}));
  EXPECT_TRUE(pick_polygon(layer, {{0.5, 0.5, -3}, {0, 0, 1}}));
  EXPECT_FALSE(pick_polygon(layer, {{0.5, 0.5, 3}, {0, 0, 1}}));  // behind the origin
  EXPECT_FALSE(pick_polygon(layer, {{1.5, 0.5, 3}, {0, 0, -1}}));
}

TEST(Picking, LeavesNoCrackBetweenTriangles) {
  const PolygonLayer layer = unit_square();
  for (double t : {0.1, 0.3, 0.5, 0.77}) {  // along either diagonal
    EXPECT_TRUE(pick_polygon(layer, {{t, t, 3}, {0, 0, -1}}));
    EXPECT_TRUE(pick_polygon(layer, {{t, 1 - t, 3}, {0, 0, -1}}));
  }
}

TEST(Picking, TheNotchOfAConcavePolygonIsEmpty) {
  const PolygonLayer layer = letter_l();
  EXPECT_FALSE(pick_polygon(layer, {{1.5, 1.5, 3}, {0, 0, -1}}));
  for (const auto& [x, y] : {std::pair{0.5, 0.5}, std::pair{1.5, 0.5}, std::pair{0.5, 1.5}}) {
    EXPECT_TRUE(pick_polygon(layer, {{x, y, 3}, {0, 0, -1}}));
  }
}

TEST(Picking, EmptyAndBrokenLayersAreMissed) {
  EXPECT_FALSE(pick_polygon({}, {{0, 0, 3}, {0, 0, -1}}));
  PolygonLayer layer = unit_square();
  layer.points(2, 0) = std::nan("");
  EXPECT_FALSE(pick_polygon(layer, {{0.5, 5.0, 3}, {0, 0, -1}}));
}

TEST(Picking, FindsEveryVisibleEdgeAndRefusesEveryHiddenOne) {
  const PolygonLayer layer = cube();
  const Camera camera = looking_at(layer, -0.9, 0.5);
  const auto edges = edges_of(layer);
  ASSERT_EQ(edges.size(), 12u);
  // The hidden edges are the three at the corner farthest from the eye.
  int farthest = 0;
  for (int i = 1; i < 8; ++i) {
    if (camera.depth(layer.points.row(i).transpose()) > camera.depth(layer.points.row(farthest).transpose()))
      farthest = i;
  }
  for (size_t i = 0; i < edges.size(); ++i) {
    const Vector3d middle =
        0.5 * (layer.points.row(edges[i].first) + layer.points.row(edges[i].second)).transpose();
    const glm::vec2 pixel = camera.project(middle);
    const bool hidden = edges[i].first == farthest || edges[i].second == farthest;
    const auto found = pick_edge(layer.points, edges, camera, pixel, 5.0f, &layer);
    EXPECT_EQ(found == static_cast<int>(i), !hidden) << "edge " << i;
    EXPECT_EQ(pick_edge(layer.points, edges, camera, pixel, 5.0f, nullptr), static_cast<int>(i));
  }
}

TEST(Picking, TakesTheNearestEdgeWithinTheRadius) {
  const PolygonLayer layer = unit_square();
  const Camera camera = looking_at(layer, -1.5707963, 1.5);
  const auto edges = edges_of(layer);  // 0-1, 1-2, 2-3, 0-3
  const glm::vec2 on_edge = camera.project({0.5, 0.0, 0.0});
  EXPECT_EQ(pick_edge(layer.points, edges, camera, on_edge + glm::vec2(0, 6), 8.0f, &layer), 0);
  EXPECT_FALSE(pick_edge(layer.points, edges, camera, on_edge + glm::vec2(0, 6), 5.0f, &layer));
  EXPECT_FALSE(pick_edge(layer.points, {}, camera, on_edge, 5.0f, &layer));
}

TEST(Picking, DesignEdgesJustBeneathThePanelsStayInReach) {
  const PolygonLayer panels = unit_square(0.05);
  const PolygonLayer design = unit_square();
  const Camera camera = looking_at(panels, -1.0, 1.0);
  const std::vector<std::pair<int, int>> diagonal{{0, 2}};
  const glm::vec2 pixel = camera.project({0.5, 0.5, 0.0});
  EXPECT_EQ(pick_edge(design.points, diagonal, camera, pixel, 5.0f, &panels), 0);
  const PolygonLayer far_above = unit_square(1.5);
  EXPECT_FALSE(pick_edge(design.points, diagonal, looking_at(far_above, -1.57, 1.5),
                         looking_at(far_above, -1.57, 1.5).project({0.5, 0.5, 0.0}), 5.0f, &far_above));
}

TEST(Picking, EdgesThatReachBehindTheEyeArePicked) {
  const PolygonLayer layer = unit_square();
  Camera camera = looking_at(layer, -1.5707963, 0.3);
  // The edge runs through under the eye and far to both sides of it.
  const Vector3d ahead = camera.eye() + 4.0 * camera.forward() - 0.2 * camera.up();
  const Points ends = rows({ahead, camera.eye() - 50.0 * camera.forward() - 0.2 * camera.up()});
  const Vector3d seen = camera.eye() + 2.0 * camera.forward() - 0.2 * camera.up();
  EXPECT_EQ(pick_edge(ends, {{0, 1}}, camera, camera.project(seen), 3.0f, nullptr), 0);
}

TEST(Picking, PointsBehindPanelsAreRefused) {
  const PolygonLayer layer = cube();
  const Camera camera = looking_at(layer, -0.9, 0.5);
  int refused = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::vec2 pixel = camera.project(layer.points.row(i).transpose());
    EXPECT_EQ(pick_point(layer.points, camera, pixel, 5.0f, nullptr), i);
    const auto found = pick_point(layer.points, camera, pixel + glm::vec2(2, 1), 5.0f, &layer);
    if (found) {
      EXPECT_EQ(found, i);
    } else {
      ++refused;
    }
  }
  EXPECT_EQ(refused, 1);
  EXPECT_FALSE(pick_point(layer.points, camera, {1, 1}, 5.0f, &layer));
}

// --- Areas -----------------------------------------------------------------------------------

Camera above(const PolygonLayer& layer) {
  Camera camera;
  camera.set_viewport(400, 300);
  camera.set_direction(-1.5707963, 1.55);
  camera.fit(layer.points);
  return camera;
}

TEST(Picking, ABoxTakesWhatIsWhollyInside) {
  const PolygonLayer layer = two_squares();
  const Camera camera = above(layer);
  const glm::vec2 low = camera.project({-0.1, -0.1, 0}), middle = camera.project({1.1, 1.1, 0}),
                  beside = camera.project({0.9, 1.1, 0}), high = camera.project({2.1, 1.1, 0});
  EXPECT_EQ(polygons_in_box(layer, camera, low, middle), std::vector<int>{0});
  EXPECT_EQ(polygons_in_box(layer, camera, middle, low), std::vector<int>{0}) << "whichever corner was first";
  EXPECT_TRUE(polygons_in_box(layer, camera, low, beside).empty()) << "a part of it is not enough";
  EXPECT_EQ(polygons_in_box(layer, camera, low, high), (std::vector<int>{0, 1}));
  EXPECT_EQ(points_in_box(layer.points, camera, low, beside), (std::vector<int>{0, 3}));
}

TEST(Picking, WhatIsBehindTheEyeIsInNoBox) {
  const PolygonLayer layer = cube();
  Camera camera = above(layer);
  camera.zoom(40.0, Vector3d(0, 0, 1));  // the eye is beneath the lid now, or just above it
  camera.zoom(0.5, Vector3d(0, 0, -1));
  for (const int i : points_in_box(layer.points, camera, {-1e6, -1e6}, {1e6, 1e6})) {
    EXPECT_GT(camera.depth(layer.points.row(i).transpose()), 0.0);
  }
}

TEST(Picking, InSightIsWhatARayMeetsFirst) {
  const PolygonLayer layer = torus(24, 12);
  Camera camera;
  camera.set_viewport(600, 400);
  camera.set_direction(-1.2, 0.5);
  camera.fit(layer.points);
  const auto seen = polygons_in_sight(layer, camera);
  ASSERT_EQ(seen.size(), static_cast<size_t>(layer.polygons.size()));
  std::vector<char> met(seen.size(), 0);
  for (int y = 0; y < 400; y += 3) {
    for (int x = 0; x < 600; x += 3) {
      if (const auto hit =
              pick_polygon(layer, camera.ray({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}))) {
        met[static_cast<size_t>(hit->polygon)] = 1;
      }
    }
  }
  int hidden = 0, differ = 0;
  for (size_t i = 0; i < seen.size(); ++i) {
    hidden += !seen[i];
    EXPECT_TRUE(seen[i] || !met[i]) << "polygon " << i << " is met by a ray";
    differ += seen[i] != met[i];
  }
  EXPECT_GT(hidden, layer.polygons.size() / 3);
  EXPECT_LE(differ, 6) << "slivers at the silhouette, which the sparse rays miss";
}

TEST(Picking, WhatLiesBeneathIsNotInSight) {
  PolygonLayer layer = unit_square();
  layer.points.conservativeResize(8, 3);
  layer.points.bottomRows(4) << 0.2, 0.2, -1, 0.8, 0.2, -1, 0.8, 0.8, -1, 0.2, 0.8, -1;
  layer.polygons.push_back(std::array{4, 5, 6, 7});
  EXPECT_EQ(polygons_in_sight(layer, above(layer)), (std::vector<char>{1, 0}));
}

}  // namespace
}  // namespace planewright::render
