#include "ui/layer_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/problem/constraint.h"

namespace planewright::ui {
namespace {

DemandInfo band() {
  return {"band",
          "Band",
          "",
          "",
          true,
          false,
          false,
          {{"low", "from", DemandUnit::Length, 0.0}, {"high", "to", DemandUnit::Length, 1.0}},
          nullptr};
}

TEST(LayerEdits, ParametersTakeTheirDefaultsUntilOneIsGiven) {
  Demand demand{"band", true, {}, {}};
  EXPECT_EQ(parameter(band(), demand, 1), 1.0);
  set_parameter(band(), demand, 1, 4.0);
  EXPECT_EQ(demand.values, (std::vector<double>{0.0, 4.0}));
  set_parameter(band(), demand, 0, -2.0);
  EXPECT_EQ(demand.values, (std::vector<double>{-2.0, 4.0}));
  EXPECT_EQ(parameter(band(), demand, 0), -2.0);
}

TEST(LayerEdits, OnlyEndsOfABandMayBeEmpty) {
  EXPECT_EQ(none_of(band(), 0), -kUnbounded);
  EXPECT_EQ(none_of(band(), 1), kUnbounded);
  DemandInfo one = band();
  one.parameters = {{"eps", "least", DemandUnit::None, 0.1}};
  EXPECT_EQ(none_of(one, 0), 0.0);
  one.parameters[0].default_value = kUnbounded;
  EXPECT_EQ(none_of(one, 0), kUnbounded);
}

TEST(LayerEdits, NeverTouchIsThreeDemandsEverywhereAndTheTest) {
  LayerSettings settings;
  EXPECT_EQ(never_touch(settings), Switch::Off);
  settings.demands.list = {{"face", false, {}, {}}, {"vertex", true, "roof", {}}};
  EXPECT_EQ(never_touch(settings), Switch::Off);  // at the roof is not everywhere
  set_never_touch(settings, true);
  EXPECT_EQ(never_touch(settings), Switch::On);
  EXPECT_TRUE(settings.no_penetration);
  for (const char* name : {"vertex", "face", "edge"}) EXPECT_TRUE(is_on(settings.demands, name)) << name;
  EXPECT_EQ(settings.demands.list.size(), 4u);  // none twice; the roof's own is kept
  settings.demands.list[0].on = false;
  EXPECT_EQ(never_touch(settings), Switch::Mixed);
  settings.demands.list[0].on = true;
  settings.no_penetration = false;
  EXPECT_EQ(never_touch(settings), Switch::Mixed);
  set_never_touch(settings, false);
  EXPECT_EQ(never_touch(settings), Switch::Off);
  for (const char* name : {"vertex", "face", "edge"}) EXPECT_FALSE(is_on(settings.demands, name)) << name;
}

TEST(LayerEdits, GivesUpEachDemandOnce) {
  Demands demands;
  const Waiver later{"edge", {ElementKind::PanelEdge, 7}}, first{"edge", {ElementKind::PanelEdge, 2}};
  give_up(demands, {later});
  give_up(demands, {later, first});
  EXPECT_EQ(demands.waived, (std::vector<Waiver>{first, later}));
}

TEST(LayerEdits, DemandsOfTheOtherModeAreSwitchedOffNotLost) {
  LayerSettings settings;
  set_never_touch(settings, true);
  settings.mode = ComplexKind::Planarize;
  EXPECT_EQ(switch_off_undefined(settings), 3);
  EXPECT_EQ(settings.demands.list.size(), 3u);
  for (const Demand& demand : settings.demands.list) EXPECT_FALSE(demand.on) << demand.name;
  EXPECT_FALSE(settings.no_penetration);
  EXPECT_EQ(switch_off_undefined(settings), 0);
}

TEST(LayerEdits, KnowsWhichPresetTheSettingsAre) {
  for (const ComplexKind mode : {ComplexKind::Dual, ComplexKind::Planarize}) {
    for (const Preset& preset : presets()) {
      if (!preset.fits(mode)) continue;
      LayerSettings settings;
      settings.mode = mode;
      ASSERT_TRUE(apply(preset, settings).has_value());
      const Preset* found = present_preset(settings);
      ASSERT_NE(found, nullptr) << preset.name;
      // Two presets may ask for the same; then either is right.
      LayerSettings same;
      same.mode = mode;
      ASSERT_TRUE(apply(*found, same).has_value());
      for (const auto& [name, weight] : settings.weights) {
        EXPECT_EQ(same.weights.contains(name) ? same.weights[name] : 0.0, weight) << preset.name;
      }
      EXPECT_GE(same.demands.list.size(), settings.demands.list.size()) << preset.name;
      settings.weights["position"] += 0.125;
      EXPECT_EQ(present_preset(settings), nullptr) << preset.name;
    }
  }
}

TEST(LayerEdits, APresetWhoseDemandWasSwitchedOffIsNoLongerIt) {
  const auto wants = [](const Preset& p) { return !p.demands.empty(); };
  const auto found = std::find_if(presets().begin(), presets().end(), wants);
  ASSERT_NE(found, presets().end());
  LayerSettings settings;
  settings.mode = found->for_dual ? ComplexKind::Dual : ComplexKind::Planarize;
  ASSERT_TRUE(apply(*found, settings).has_value());
  EXPECT_EQ(present_preset(settings), &*found);
  settings.demands.list.front().on = false;
  EXPECT_NE(present_preset(settings), &*found);
}

}  // namespace
}  // namespace planewright::ui
