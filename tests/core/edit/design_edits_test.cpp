#include "core/edit/design_edits.h"

#include <gtest/gtest.h>

namespace planewright {
namespace {

TEST(DesignEdits, ASecondLayerLiesOnTheOtherSide) {
  const Design two = with_layer_added(Design{}, 0, 2.0);
  ASSERT_EQ(two.layers.size(), 2u);
  EXPECT_EQ(two.layers[0].name, "outer");
  EXPECT_EQ(two.layers[1].name, "inner");
  EXPECT_DOUBLE_EQ(two.layers[0].settings.offset, 0.6);
  EXPECT_DOUBLE_EQ(two.layers[1].settings.offset, -0.6);

  Design inside;
  inside.layers[0].settings.offset = -0.25;
  inside.layers[0].settings.weights["fairing"] = 3.0;
  const Design both = with_layer_added(inside, 0, 2.0);
  EXPECT_EQ(both.layers[0].name, "inner");
  EXPECT_EQ(both.layers[1].name, "outer");
  EXPECT_DOUBLE_EQ(both.layers[0].settings.offset, -0.25) << "an offset that was chosen stays";
  EXPECT_DOUBLE_EQ(both.layers[1].settings.offset, 0.25);
  EXPECT_DOUBLE_EQ(both.layers[1].settings.weights.at("fairing"), 3.0);

  inside.layers[0].settings.demands.pins = {{{PointKind::Face, 0}, {1.0, 2.0, 3.0}}};
  const Design pinned = with_layer_added(inside, 0, 2.0);
  EXPECT_EQ(pinned.layers[0].settings.demands.pins.size(), 1u);
  EXPECT_TRUE(pinned.layers[1].settings.demands.pins.empty()) << "a pin holds one layer's point";

  Design named;
  named.layers[0].name = "roof";
  EXPECT_EQ(with_layer_added(named, 0, 1.0).layers[0].name, "roof");
}

TEST(DesignEdits, LaterLayersLieBeyondTheFarthest) {
  const Design three = with_layer_added(with_layer_added(Design{}, 0, 1.0), 1, 1.0);
  ASSERT_EQ(three.layers.size(), 3u);
  EXPECT_DOUBLE_EQ(three.layers[2].settings.offset, -0.6);
  EXPECT_EQ(three.layers[2].name, "inner 2");
}

TEST(DesignEdits, ADuplicateHasANameOfItsOwn) {
  Design design = with_layer_duplicated(Design{}, 0);
  EXPECT_EQ(design.layers[1].name, "panels copy");
  design = with_layer_duplicated(design, 0);
  EXPECT_EQ(design.layers[2].name, "panels copy 2");
  EXPECT_EQ(design.layers[2].settings, design.layers[0].settings);
}

TEST(DesignEdits, RemovingALayerKeepsReferencesTrue) {
  Design design;
  for (int i = 0; i < 3; ++i) design = with_layer_duplicated(design, 0);
  design.layers[1].coplanar_with = 0;
  design.layers[2].coplanar_with = 1;
  design.layers[3].coplanar_with = 2;
  const Design without = with_layer_removed(design, 1);
  ASSERT_EQ(without.layers.size(), 3u);
  EXPECT_EQ(without.layers[1].coplanar_with, -1) << "its partner is gone";
  EXPECT_EQ(without.layers[2].coplanar_with, 1) << "the same layer, with another number";
}

TEST(DesignEdits, SelectionsAreStoredRenamedAndRemovedWithTheirDemands) {
  Selection roof;
  roof.name = "roof";
  roof.vertices = {1, 2};
  Design design = with_selection_stored(Design{}, roof);
  roof.vertices = {7};
  design = with_selection_stored(design, roof);
  ASSERT_EQ(design.selections.size(), 1u);
  EXPECT_EQ(design.selections[0].vertices, std::vector<int>{7});
  EXPECT_EQ(free_selection_name(design), "selection 1");

  design.layers[0].settings.demands.list = {{"vertex", true, "roof", {}}, {"face", true, "", {}}};
  EXPECT_EQ(demands_on(design, "roof"), 1);
  const auto renamed = with_selection_renamed(design, "roof", "ridge");
  ASSERT_TRUE(renamed);
  EXPECT_EQ(renamed->selections[0].name, "ridge");
  EXPECT_EQ(renamed->layers[0].settings.demands.list[0].selection, "ridge");
  EXPECT_EQ(renamed->layers[0].settings.demands.list[1].selection, "");

  Selection other;
  other.name = "eaves";
  const Design two = with_selection_stored(design, other);
  EXPECT_FALSE(with_selection_renamed(two, "roof", "eaves"));
  EXPECT_FALSE(with_selection_renamed(two, "roof", ""));
  EXPECT_FALSE(with_selection_renamed(two, "floor", "x"));

  const Design without = with_selection_removed(*renamed, "ridge");
  EXPECT_TRUE(without.selections.empty());
  ASSERT_EQ(without.layers[0].settings.demands.list.size(), 1u)
      << "without its selection the demand would hold everywhere";
  EXPECT_EQ(without.layers[0].settings.demands.list[0].name, "face");
}

TEST(DesignEdits, APointHasOnePin) {
  Demands demands;
  set_pin(demands, {{PointKind::Face, 3}, {1.0, 2.0, 3.0}});
  set_pin(demands, {{PointKind::Corner, 3}, {1.0, std::nullopt, std::nullopt}});
  set_pin(demands, {{PointKind::Face, 3}, {std::nullopt, 5.0, std::nullopt}});
  ASSERT_EQ(demands.pins.size(), 2u);
  EXPECT_EQ(demands.pins[0].at[1], 5.0);
  EXPECT_FALSE(demands.pins[0].at[0]);
  set_plane_pin(demands, {4, {}});
  set_plane_pin(demands, {4, PlanePin::Equation{{0, 0, 1}, 2.0}});
  ASSERT_EQ(demands.plane_pins.size(), 1u);
  EXPECT_TRUE(demands.plane_pins[0].plane);
}

}  // namespace
}  // namespace planewright
