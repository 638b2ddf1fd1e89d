#include "core/edit/remap.h"

#include <gtest/gtest.h>

#include "core/design/design.h"
#include "core/mesh/mesh_edits.h"
#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

Design with_waivers(const LayerSettings& settings, std::vector<Waiver> waived) {
  Design design;
  design.layers[0].settings = settings;
  design.layers[0].settings.demands.waived = std::move(waived);
  return design;
}

TEST(Remap, SelectionsAscendAgain) {
  const ElementMap map{index_map({3, 0, -1, 1}, 4), index_map({1, 0}, 2), index_map({0}, 2)};
  const Selection selection{"roof", {0, 2, 3}, {0, 1}, {0, 1}};
  EXPECT_EQ(remapped(selection, map), (Selection{"roof", {0, 1}, {0, 1}, {0}}));
}

// Waivers name elements of the complex, whose indices shift with the mesh's.
TEST(Remap, WaiversGoOnToNameTheSamePanelsPointsAndPanelEdges) {
  for (const bool dual : {true, false}) {
    LayerSettings settings;
    settings.mode = dual ? ComplexKind::Dual : ComplexKind::Planarize;
    const PolygonMesh mesh = dual ? domed_triangle_grid(5, 5).mesh() : twisted_grid(5, 5).mesh();
    const EditedMesh edited = apply(mesh, MeshEdit::delete_face(0)).value();
    const auto before = build_complex(mesh, settings).value(),
               after = build_complex(edited.mesh, settings).value();
    std::vector<Waiver> all;
    for (int i = 0; i < before->plane_count(); ++i) all.push_back({"convex", {ElementKind::Panel, i}});
    for (int j = 0; j < before->point_count(); ++j) all.push_back({"band", {ElementKind::Point, j}});
    for (int k = 0; k < static_cast<int>(before->panel_edges.size()); ++k) {
      all.push_back({"edge", {ElementKind::PanelEdge, k}});
    }
    for (const Waiver& waiver : all) {
      const RemappedDesign result = remapped(with_waivers(settings, {waiver}), edited.map, mesh, edited.mesh);
      const auto& left = result.design.layers[0].settings.demands.waived;
      EXPECT_EQ(left.size() + result.dropped.size(), 1u);
      if (left.empty()) {
        EXPECT_EQ(result.dropped.front(), "1 place given up of layer panels");
        continue;
      }
      const int was = waiver.element.index, now = left[0].element.index;
      EXPECT_EQ(left[0].element.kind, waiver.element.kind);
      EXPECT_EQ(left[0].demand, waiver.demand);
      const auto near = [](const auto& a, const auto& b) { return (a - b).norm() < 1e-12; };
      const auto absolute = [](const TangentComplex& c, int j) {
        return Vector3d(c.preferred.row(j).transpose() + c.origin);
      };
      if (waiver.element.kind == ElementKind::Panel) {
        EXPECT_TRUE(near(before->anchors.row(was).transpose() + before->origin,
                         after->anchors.row(now).transpose() + after->origin));
      } else if (waiver.element.kind == ElementKind::Point) {
        EXPECT_TRUE(near(absolute(*before, was), absolute(*after, now)));
      } else {
        const PanelEdge a = before->panel_edges[static_cast<size_t>(was)],
                        b = after->panel_edges[static_cast<size_t>(now)];
        const Vector3d middle = absolute(*before, a.a) + absolute(*before, a.b);
        // A dual's edge that the deleted face was beside leads to a point of the new border instead.
        if (!dual) {
          EXPECT_TRUE(near(middle, absolute(*after, b.a) + absolute(*after, b.b)));
        }
      }
    }
    const RemappedDesign result = remapped(with_waivers(settings, all), edited.map, mesh, edited.mesh);
    const auto left = result.design.layers[0].settings.demands.waived.size();
    EXPECT_GT(left, all.size() - 12);
    EXPECT_LT(left, all.size());
  }
}

// A panel edge crosses its mesh edge; those beside a flip keep theirs.
TEST(Remap, WaiversFollowAFlip) {
  const PolygonMesh mesh = domed_triangle_grid(4, 4).mesh();
  LayerSettings settings;
  int e = 0;
  while (!mesh.can_flip(e)) ++e;
  const EditedMesh edited = apply(mesh, MeshEdit::flip(e)).value();
  const auto before = build_complex(mesh, settings).value();
  std::vector<Waiver> all;
  for (int k = 0; k < static_cast<int>(before->panel_edges.size()); ++k) {
    all.push_back({"edge", {ElementKind::PanelEdge, k}});
  }
  const RemappedDesign result = remapped(with_waivers(settings, all), edited.map, mesh, edited.mesh);
  EXPECT_EQ(result.design.layers[0].settings.demands.waived.size(), all.size() - 1);
}

TEST(Remap, PinsOfPanelsThatTheInteriorLosesGo) {
  const PolygonMesh mesh = domed_triangle_grid(4, 4).mesh();
  const EditedMesh edited = apply(mesh, MeshEdit::delete_face(0)).value();  // 6 comes to the border
  LayerSettings settings;
  settings.border = BorderPolicy::Interior;
  settings.demands.plane_pins = {{6, {}}, {12, {}}};
  Design design;
  design.layers[0].settings = settings;
  const RemappedDesign result = remapped(design, edited.map, mesh, edited.mesh);
  const auto& left = result.design.layers[0].settings.demands.plane_pins;
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].panel_origin, edited.map.vertices.to_new[12]);
  EXPECT_EQ(result.dropped, std::vector<std::string>{"1 pinned panel of layer panels"});
}

}  // namespace
}  // namespace planewright
