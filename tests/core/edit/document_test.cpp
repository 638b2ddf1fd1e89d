#include "core/edit/document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

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
  EXPECT_FALSE(document.flip_edge(0).has_value());
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

  ASSERT_TRUE(document.flip_edge(edge).has_value());
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
  const auto result = document.flip_edge(border);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::Refused);
  EXPECT_NE(result.error().what.find("border"), std::string::npos);
  EXPECT_EQ(result.error().where, "edge " + std::to_string(border));
  EXPECT_FALSE(document.flip_edge(-1).has_value());
  EXPECT_FALSE(document.flip_edge(1000).has_value());
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
    const auto result = document.flip_edge(e);
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
  ASSERT_TRUE(document.flip_edge(edge).has_value());
  EXPECT_TRUE(raised());
}

}  // namespace
}  // namespace planewright
