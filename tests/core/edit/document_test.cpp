#include "core/edit/document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "core/design/design.h"
#include "core/mesh/sample_shapes.h"

namespace planewright {
namespace {

// Two triangles over a unit square, joined along the diagonal 0-2.
CheckedMesh square() {
  Points positions(4, 3);
  positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  CheckedMesh checked;
  checked.mesh = PolygonMesh::from_polygons(positions, Polygons{{0, 1, 2}, {0, 2, 3}}).value();
  checked.health.vertices = 4;
  checked.health.faces = 2;
  return checked;
}

CheckedMesh torus() {
  CheckedMesh checked;
  checked.mesh = make_torus(12, 12);
  return checked;
}

std::vector<int> corners(const PolygonMesh& mesh) {
  return mesh.faces().indices();
}

LayerSettings with_fairing(LayerSettings settings, double weight) {
  settings.weights["fairing"] = weight;
  return settings;
}

TEST(Document, IsEmptyUntilAMeshIsOpened) {
  Document document;
  EXPECT_TRUE(document.empty());
  EXPECT_FALSE(document.can_undo());
  EXPECT_FALSE(document.can_redo());
  EXPECT_EQ(document.undo_name(), "");
  EXPECT_FALSE(document.edit_mesh(MeshEdit::flip(0)).has_value());
  document.undo();  // nothing to take back: no effect
  document.redo();
  EXPECT_TRUE(document.empty());
}

TEST(Document, OpeningReplacesEverything) {
  Document document;
  document.open(square(), "square.obj", {});
  document.change_settings(with_fairing(document.settings(), 2.0), "Weight of fairing");
  const auto before = document.revision();
  document.open(torus(), "torus.off", {});
  EXPECT_EQ(document.name(), "torus.off");
  EXPECT_EQ(document.mesh()->vertex_count(), 144);
  EXPECT_EQ(document.settings(), LayerSettings{});
  EXPECT_FALSE(document.can_undo());
  EXPECT_GT(document.revision(), before);
}

TEST(Document, FlipsAndTakesItBack) {
  Document document;
  document.open(torus(), "torus.off", {});
  const auto original = document.mesh();
  int edge = 0;
  while (!original->can_flip(edge)) ++edge;
  const MeshEdge before = original->edge(edge);

  ASSERT_TRUE(document.edit_mesh(MeshEdit::flip(edge)).has_value());
  const MeshEdge after = document.mesh()->edge(edge);
  EXPECT_NE(std::minmax(before.a, before.b), std::minmax(after.a, after.b));
  EXPECT_EQ(original->edge(edge).a, before.a) << "the mesh a solve holds must not change";
  EXPECT_EQ(document.undo_name(), "Flip edge " + std::to_string(edge));

  document.undo();
  EXPECT_EQ(corners(*document.mesh()), corners(*original));
  EXPECT_EQ(document.redo_name(), "Flip edge " + std::to_string(edge));
  document.redo();
  EXPECT_EQ(document.mesh()->edge(edge).a, after.a);
}

TEST(Document, RefusesAFlipWithTheReason) {
  Document document;
  document.open(square(), "square.obj", {});
  const auto revision = document.revision();
  const int border = document.mesh()->find_edge(0, 1);
  const auto result = document.edit_mesh(MeshEdit::flip(border));
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::Refused);
  EXPECT_NE(result.error().what.find("border"), std::string::npos);
  EXPECT_EQ(result.error().where, "edge " + std::to_string(border));
  EXPECT_FALSE(document.edit_mesh(MeshEdit::flip(-1)).has_value());
  EXPECT_FALSE(document.edit_mesh(MeshEdit::flip(1000)).has_value());
  EXPECT_EQ(document.revision(), revision);
  EXPECT_FALSE(document.can_undo());
}

TEST(Document, RefusesToFlipBetweenQuads) {
  CheckedMesh quads;
  quads.mesh = make_sample("twisted-roof").value();
  Document document;
  document.open(std::move(quads), "roof.obj", {});
  for (int e = 0; e < document.mesh()->edge_count(); ++e) {
    if (document.mesh()->edge(e).border()) continue;
    const auto result = document.edit_mesh(MeshEdit::flip(e));
    ASSERT_FALSE(result.has_value());
    EXPECT_NE(result.error().what.find("triangles"), std::string::npos);
    return;
  }
  FAIL() << "no inner edge";
}

TEST(Document, ADragIsOneStep) {
  Document document;
  document.open(square(), "square.obj", {});
  const LayerSettings start = document.settings();
  for (const double weight : {0.1, 0.2, 0.5, 3.0}) {
    document.change_settings(with_fairing(start, weight), "Weight of fairing", "weight fairing");
  }
  document.end_merge();
  document.change_settings(with_fairing(start, 5.0), "Weight of fairing", "weight fairing");
  document.end_merge();

  EXPECT_EQ(document.undo_name(), "Weight of fairing");
  document.undo();
  EXPECT_EQ(document.settings().weights.at("fairing"), 3.0);
  document.undo();
  EXPECT_EQ(document.settings(), start);
  EXPECT_FALSE(document.can_undo());
  document.redo();
  EXPECT_EQ(document.settings().weights.at("fairing"), 3.0);
}

TEST(Document, DifferentKeysDoNotMerge) {
  Document document;
  document.open(square(), "square.obj", {});
  LayerSettings settings = document.settings();
  settings.offset = 0.5;
  document.change_settings(settings, "Offset", "offset");
  document.change_settings(with_fairing(settings, 1.0), "Weight of fairing", "weight fairing");
  document.undo();
  EXPECT_EQ(document.settings().offset, 0.5);
  EXPECT_EQ(document.settings().weights.at("fairing"), 0.0);
  document.undo();
  EXPECT_EQ(document.settings().offset, 0.0);
}

TEST(Document, NoChangeIsNoStep) {
  Document document;
  document.open(square(), "square.obj", {});
  const auto revision = document.revision();
  document.change_settings(document.settings(), "Nothing");
  EXPECT_EQ(document.revision(), revision);
  EXPECT_FALSE(document.can_undo());

  // A slider dragged there and back again leaves no step behind.
  const LayerSettings start = document.settings();
  document.change_settings(with_fairing(start, 1.0), "Weight of fairing", "weight fairing");
  document.change_settings(start, "Weight of fairing", "weight fairing");
  EXPECT_EQ(document.settings(), start);
  EXPECT_FALSE(document.can_undo());
}

TEST(Document, ANewChangeCutsTheRedo) {
  Document document;
  document.open(square(), "square.obj", {});
  const LayerSettings start = document.settings();
  document.change_settings(with_fairing(start, 1.0), "Weight of fairing");
  document.undo();
  ASSERT_TRUE(document.can_redo());
  document.change_settings(with_fairing(start, 2.0), "Weight of fairing");
  EXPECT_FALSE(document.can_redo());
  document.undo();
  EXPECT_EQ(document.settings(), start);
}

TEST(Document, AChangeAfterAnUndoDoesNotMergeIntoTheStepBefore) {
  Document document;
  document.open(square(), "square.obj", {});
  const LayerSettings start = document.settings();
  document.change_settings(with_fairing(start, 1.0), "Weight of fairing", "weight fairing");
  document.end_merge();
  document.change_settings(with_fairing(start, 2.0), "Weight of fairing", "weight fairing");
  document.undo();
  document.change_settings(with_fairing(start, 4.0), "Weight of fairing", "weight fairing");
  document.undo();
  EXPECT_EQ(document.settings().weights.at("fairing"), 1.0);
}

TEST(Document, SelectionsAndPinsFollowTheirElements) {
  Document document;
  document.open(torus(), "torus.off", {});
  Design design = document.design();
  design.selections = {{"ring", {3, 4, 5}, {}, {}}, {"spot", {7}, {}, {}}};
  Demands& demands = design.layers[0].settings.demands;
  demands.list = {{"convex", true, "spot"}, {"convex", true, "ring"}};
  demands.pins = {{{PointKind::Face, 100}, {1.0, 2.0, 3.0}}};
  demands.plane_pins = {{4, {}}, {140, {}}};
  document.change_design(design, "Demands");

  // Vertex 4 becomes part of vertex 3, and a vertex is made.
  const auto dropped = document.edit_mesh(
      {MeshEdit::collapse(document.mesh()->find_edge(3, 4)), MeshEdit::split_edge(0)}, "Two edits");
  ASSERT_TRUE(dropped) << dropped.error().text();
  EXPECT_EQ(*dropped,
            (std::vector<std::string>{"1 element of selection ring", "1 pinned panel of layer panels"}));
  const Design& now = document.design();
  EXPECT_EQ(now.selections[0].vertices, (std::vector<int>{3, 4}));
  EXPECT_EQ(now.selections[1].vertices, std::vector<int>{6});
  const Demands& left = now.layers[0].settings.demands;
  ASSERT_EQ(left.plane_pins.size(), 1u);
  EXPECT_EQ(left.plane_pins[0].panel_origin, 139);
  ASSERT_EQ(left.pins.size(), 1u);
  EXPECT_EQ(document.ids()->faces[static_cast<std::size_t>(left.pins[0].point.element)], 100);

  // A selection that has nothing left takes the demands on it along.
  const int lost = document.mesh()->find_edge(5, 6);
  const auto more = document.edit_mesh(MeshEdit::collapse(lost));
  ASSERT_TRUE(more);
  EXPECT_EQ(*more, std::vector<std::string>{"selection spot and 1 demand on it"});
  EXPECT_EQ(document.design().selections.size(), 1u);
  EXPECT_EQ(document.settings().demands.list.size(), 1u);
  document.undo();
  document.undo();
  EXPECT_EQ(document.design(), design);
}

TEST(Document, NamesOutliveEditsAndAreGivenOnce) {
  Document document;
  document.open(torus(), "torus.off", {});
  for (const int v : {0, 17, 143}) EXPECT_EQ(document.panel_number(0, v), v);
  ASSERT_TRUE(document.edit_mesh(MeshEdit::collapse(document.mesh()->find_edge(3, 4))));
  EXPECT_EQ(document.panel_number(0, 3), 3);
  EXPECT_EQ(document.panel_number(0, 16), 17) << "the panel that nothing touched";
  EXPECT_EQ(panel_name(document.panel_number(0, 16)), "panel 17");
  EXPECT_EQ(document.panel_number(0, 143), -1);

  ASSERT_TRUE(document.edit_mesh(MeshEdit::split_edge(0)));
  EXPECT_EQ(document.panel_number(0, 143), 144);
  const ElementIds split = *document.ids();
  document.undo();
  ASSERT_TRUE(document.edit_mesh(MeshEdit::split_edge(1)));
  EXPECT_EQ(document.panel_number(0, 143), 145) << "144 may be in somebody's report";
  const ElementMap map = map_between(split, *document.ids());
  EXPECT_EQ(map.vertices.to_new[143], -1);
  EXPECT_EQ(map.vertices.to_new[142], 142);
}

TEST(Document, NamesAreThoseOfTheReportsOfTheOpenedMesh) {
  CheckedMesh checked;
  checked.mesh = make_sample("dome", 100).value();
  LayerSettings settings;
  settings.border = BorderPolicy::Interior;
  Document document;
  document.open(std::move(checked), "dome", settings);
  const auto complex = build_complex(*document.mesh(), settings).value();
  for (int i = 0; i < complex->plane_count(); ++i) {
    EXPECT_EQ(document.panel_number(0, complex->plane_origin[static_cast<std::size_t>(i)]), i);
  }
}

TEST(Document, SeveralEditsAreOneStepOrNone) {
  Document document;
  document.open(torus(), "torus.off", {});
  const auto before = document.mesh();
  const int e = before->find_edge(0, 1);
  ASSERT_TRUE(
      document.edit_mesh({MeshEdit::split_edge(e), MeshEdit::move_vertex(144, {9, 9, 9})}, "Raise an edge"));
  EXPECT_EQ(document.mesh()->positions().row(144), Eigen::RowVector3d(9, 9, 9))
      << "of the mesh after the first";
  EXPECT_EQ(document.history(), std::vector<std::string>{"Raise an edge"});
  document.undo();
  EXPECT_EQ(document.mesh(), before);

  const auto revision = document.revision();
  const auto refused =
      document.edit_mesh({MeshEdit::split_edge(e), MeshEdit::delete_face(1000)}, "Two edits");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, "edit 2 of 2, face 1000");
  EXPECT_EQ(document.mesh(), before);
  EXPECT_EQ(document.revision(), revision);
  EXPECT_TRUE(document.can_redo()) << "a refusal is no step";
  EXPECT_TRUE(document.edit_mesh(std::vector<MeshEdit>{}, "Nothing"));
  EXPECT_EQ(document.revision(), revision);
}

TEST(Document, DraggingAVertexIsOneStep) {
  Document document;
  document.open(torus(), "torus.off", {});
  const auto before = document.mesh();
  for (const double z : {0.1, 0.2, 0.3}) {
    ASSERT_TRUE(document.edit_mesh(MeshEdit::move_vertex(5, {2, 0, z}), "vertex 5"));
  }
  document.end_merge();
  EXPECT_EQ(document.history(), std::vector<std::string>{"Move vertex 5"});
  EXPECT_EQ(document.mesh()->positions()(5, 2), 0.3);
  document.undo();
  EXPECT_EQ(document.mesh(), before);
}

TEST(Document, GoesToAnyStepOfItsHistory) {
  Document document;
  document.open(torus(), "torus.off", {});
  std::vector<std::shared_ptr<const PolygonMesh>> meshes{document.mesh()};
  for (int v = 0; v < 4; ++v) {
    ASSERT_TRUE(document.edit_mesh(MeshEdit::move_vertex(v, {v * 1.0, 0, 0})));
    meshes.push_back(document.mesh());
  }
  EXPECT_EQ(document.history(),
            (std::vector<std::string>{"Move vertex 0", "Move vertex 1", "Move vertex 2", "Move vertex 3"}));
  for (const int step : {1, 4, 0, 3}) {
    document.go_to(step);
    EXPECT_EQ(document.steps_done(), step);
    EXPECT_EQ(document.mesh(), meshes[static_cast<std::size_t>(step)]);
  }
  const auto revision = document.revision();
  document.go_to(3);
  EXPECT_EQ(document.revision(), revision) << "it is there already";
  document.go_to(99);
  EXPECT_EQ(document.steps_done(), 4);
  document.go_to(-1);
  EXPECT_EQ(document.steps_done(), 0);
}

struct Panels17 final : ShownResults {};

TEST(Document, KeepsWhatIsShownWithEachMoment) {
  const std::shared_ptr<const ShownResults> first = std::make_shared<Panels17>(),
                                            second = std::make_shared<Panels17>(),
                                            third = std::make_shared<Panels17>();
  Document document;
  document.open(square(), "square.obj", {});
  EXPECT_EQ(document.results(), nullptr);
  document.set_results(first);
  EXPECT_FALSE(document.can_undo()) << "it came by itself";

  const LayerSettings start = document.settings();
  document.change_settings(with_fairing(start, 1.0), "Weight of fairing", "weight fairing");
  EXPECT_EQ(document.results(), first) << "shown until the next solve is through";
  document.set_results(second);
  document.change_settings(with_fairing(start, 2.0), "Weight of fairing", "weight fairing");
  document.record_solve(third);
  EXPECT_EQ(document.history().size(), 1u) << "a drag and its live solves are one step";
  document.end_merge();
  EXPECT_EQ(document.results(), third);

  const auto revision = document.revision();
  document.record_solve(second);
  EXPECT_EQ(document.revision(), revision) << "the design is the same";
  EXPECT_EQ(document.undo_name(), "Solve");
  document.undo();
  EXPECT_EQ(document.results(), third);
  document.undo();
  EXPECT_EQ(document.results(), first);
  document.go_to(2);
  EXPECT_EQ(document.results(), second);
}

TEST(Document, EveryChangeRaisesTheRevision) {
  Document document;
  document.open(torus(), "torus.off", {});
  auto revision = document.revision();
  const auto raised = [&] { return std::exchange(revision, document.revision()) < document.revision(); };
  document.change_settings(with_fairing(document.settings(), 1.0), "Weight of fairing");
  EXPECT_TRUE(raised());
  document.undo();
  EXPECT_TRUE(raised());
  document.redo();
  EXPECT_TRUE(raised());
  int edge = 0;
  while (!document.mesh()->can_flip(edge)) ++edge;
  ASSERT_TRUE(document.edit_mesh(MeshEdit::flip(edge)).has_value());
  EXPECT_TRUE(raised());
}

SharedClusters clusters_of(const Document& document, int panels) {
  ClusterOptions options;
  options.panels = panels;
  return cluster_mesh(document.mesh(), options).value();
}

TEST(Document, ClustersAreStepsAndFollowEditsOfTheMesh) {
  Document document;
  document.open(torus(), "torus.off", {});
  EXPECT_EQ(document.clusters(), nullptr);
  const SharedClusters first = clusters_of(document, 20), second = clusters_of(document, 24);
  const auto revision = document.revision();
  document.set_clusters(first);  // what the design as it is needs: no step
  EXPECT_FALSE(document.can_undo());
  EXPECT_GT(document.revision(), revision);
  document.change_clusters(second, "24 panels", "clusters");
  document.change_clusters(clusters_of(document, 26), "26 panels", "clusters");
  document.end_merge();
  EXPECT_EQ(document.history(), std::vector<std::string>{"24 panels"});
  document.undo();
  EXPECT_EQ(document.clusters(), first);
  document.redo();
  EXPECT_EQ(document.clusters()->options.panels, 26);

  ASSERT_TRUE(document.edit_mesh(MeshEdit::split_edge(0)));
  ASSERT_NE(document.clusters(), nullptr);
  EXPECT_EQ(document.clusters()->mesh, document.mesh());
  EXPECT_EQ(document.clusters()->options.panels, 26);
  document.undo();
  document.undo();
  EXPECT_EQ(document.clusters(), first);
}

TEST(Document, PinnedPanelsKeepTheirRegionThroughOtherClusters) {
  Document document;
  LayerSettings settings;
  settings.mode = ComplexKind::Cluster;
  document.open(torus(), "torus.off", settings);
  const SharedClusters first = clusters_of(document, 20);
  document.set_clusters(first);
  const int last = document.clusters()->regions.count() - 1;
  settings.demands.plane_pins = {{last, std::nullopt}};
  settings.demands.pins = {{{PointKind::Vertex, document.clusters()->regions.corner_vertex[0]}, {0.0}}};
  document.change_settings(settings, "Pin");
  // Some pair of regions can be merged that leaves the pinned one alone.
  SharedClusters merged;
  for (int b = 1; b < last && !merged; ++b) {
    if (const auto made = with_regions_merged(*document.clusters(), 0, b)) merged = *made;
  }
  ASSERT_NE(merged, nullptr);
  const auto dropped = document.change_clusters(merged, "Merge");
  ASSERT_EQ(document.settings().demands.plane_pins.size(), 1u) << (dropped.empty() ? "" : dropped[0]);
  const IndexMap map = same_regions(first->regions.region_of_face, first->regions.count(),
                                    merged->regions.region_of_face, merged->regions.count());
  EXPECT_EQ(document.settings().demands.plane_pins[0].panel_origin,
            map.to_new[static_cast<std::size_t>(last)]);
  // Few regions keep neither.
  const auto lost = document.change_clusters(clusters_of(document, 10), "10 panels");
  EXPECT_EQ(
      document.settings().demands.plane_pins.size() + document.settings().demands.pins.size() + lost.size(),
      2u);
}

}  // namespace
}  // namespace planewright
