// Colours of regions: neighbours differ, and they stay while borders move.
#include "ui/region_view.h"

#include <gtest/gtest.h>

#include "core/mesh/sample_shapes.h"

namespace planewright::ui {
namespace {

SharedClusters clusters_of(const std::shared_ptr<const PolygonMesh>& mesh, int panels) {
  ClusterOptions options;
  options.panels = panels;
  auto made = cluster_mesh(mesh, options);
  EXPECT_TRUE(made.has_value());
  return made.value_or(nullptr);
}

std::shared_ptr<const PolygonMesh> dome() {
  auto mesh = make_sample("dome", 400);
  EXPECT_TRUE(mesh.has_value());
  return std::make_shared<const PolygonMesh>(std::move(*mesh));
}

TEST(RegionView, NeighboursDifferInColourAndOnlyBordersHaveLines) {
  const auto mesh = dome();
  const auto view_of_mesh = std::make_shared<const MeshView>(make_mesh_view(mesh, Vector3d::Zero()));
  const auto clusters = clusters_of(mesh, 40);
  ASSERT_NE(clusters, nullptr);
  const RegionView view = make_region_view(clusters, view_of_mesh);
  const std::vector<int>& regions = clusters->regions.region_of_face;
  const FaceGraph& graph = *clusters->graph;
  int borders = 0;
  for (std::size_t c = 0; c < graph.beside.size(); ++c) {
    const int f = graph.face_of_corner[c], g = graph.beside[c];
    if (g < 0 || regions[f] == regions[g]) continue;
    EXPECT_NE(view.colour_of_region[regions[f]], view.colour_of_region[regions[g]]);
    ++borders;
  }
  EXPECT_GT(borders, 0);
  ASSERT_EQ(view.arrays.colours.size(), mesh->face_count());
  int drawn = 0;
  for (std::size_t i = 0; i < view.arrays.faces.geometry->shapes.size(); i += 3) {
    for (int k = 0; k < 3; ++k) {
      const auto mask = view.arrays.faces.geometry->shapes[i].edge_mask;
      if ((mask & render::edge_bit(k)) != 0 && (mask & render::border_edge_bit(k)) == 0) ++drawn;
    }
  }
  EXPECT_EQ(drawn, borders) << "each side of a border draws its half of the line";
}

TEST(RegionView, ColoursStayWhereRegionsStay) {
  const auto mesh = dome();
  const auto view_of_mesh = std::make_shared<const MeshView>(make_mesh_view(mesh, Vector3d::Zero()));
  const auto clusters = clusters_of(mesh, 40);
  ASSERT_NE(clusters, nullptr);
  const RegionView before = make_region_view(clusters, view_of_mesh);
  const auto split = with_region_split(*clusters, 7);
  ASSERT_TRUE(split.has_value());
  const RegionView after = make_region_view(*split, view_of_mesh, &before);
  int same = 0;
  for (int f = 0; f < mesh->face_count(); ++f)
    if (before.arrays.colours[f] == after.arrays.colours[f]) ++same;
  EXPECT_GT(same, mesh->face_count() * 4 / 5);
}

}  // namespace
}  // namespace planewright::ui
