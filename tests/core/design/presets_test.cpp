#include "core/design/presets.h"

#include <gtest/gtest.h>

#include <set>

#include "core/problem/demands/demand_catalogue.h"
#include "core/problem/energies/energy_catalogue.h"

namespace planewright {
namespace {

TEST(Presets, NameOnlyWhatThereIs) {
  std::set<std::string> names;
  for (const Preset& preset : presets()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name << " stands there twice";
    EXPECT_FALSE(preset.label.empty() || preset.source.empty()) << preset.name;
    EXPECT_EQ(preset.description.back(), '.') << preset.name;
    EXPECT_TRUE(preset.for_dual || preset.for_planarize || preset.for_cluster) << preset.name;
    EXPECT_FALSE(preset.weights.empty()) << preset.name;
    for (const auto& [name, weight] : preset.weights) {
      EXPECT_TRUE(find_energy(name)) << preset.name << " weighs " << name;
      EXPECT_GT(weight, 0.0) << preset.name;
    }
    for (const Demand& demand : preset.demands) {
      const auto info = find_demand(demand.name);
      ASSERT_TRUE(info) << preset.name << " demands " << demand.name;
      EXPECT_TRUE(!preset.for_dual || (*info)->for_dual) << preset.name;
      EXPECT_TRUE(!preset.for_planarize || (*info)->for_planarize) << preset.name;
      EXPECT_TRUE(!preset.for_cluster || (*info)->for_cluster) << preset.name;
      EXPECT_TRUE(demand.on) << preset.name;
    }
  }
}

TEST(Presets, ThePapersEightSayLowAndHigh) {
  int found = 0;
  for (const char position : {'l', 'h'})
    for (const char direction : {'l', 'h'})
      for (const char shape : {'l', 'h'}) {
        const auto preset = find_preset({position, direction, shape});
        ASSERT_TRUE(preset);
        ++found;
        auto weights = (*preset)->weights;
        const auto is = [&](const char* energy, char level) {
          EXPECT_EQ(weights[energy] >= 0.5, level == 'h') << (*preset)->name << ' ' << energy;
        };
        is("position", position);
        is("edge-direction", direction);
        is("edge-length", shape);
        is("diagonal-length", shape);
        EXPECT_TRUE((*preset)->fits(ComplexKind::Planarize));
        EXPECT_FALSE((*preset)->fits(ComplexKind::Dual));
      }
  EXPECT_EQ(found, 8);
}

TEST(Presets, ReplaceWeightsAndKeepOtherDemands) {
  LayerSettings settings;
  settings.mode = ComplexKind::Planarize;
  settings.weights = {{"fairing", 7.0}};
  settings.demands.list = {{"border", true, {}, {}}, {"uncrossed", false, {}, {}}};
  ASSERT_TRUE(apply(**find_preset("uncrossed"), settings));
  EXPECT_EQ(settings.weights, (std::map<std::string, double>{{"position", 1.0}}));
  EXPECT_EQ(settings.demands.list,
            (std::vector<Demand>{{"border", true, {}, {}}, {"uncrossed", true, {}, {}}}));
}

TEST(Presets, AreRefusedWhereTheyMeanNothing) {
  LayerSettings settings;
  settings.mode = ComplexKind::Dual;
  const LayerSettings before = settings;
  const auto applied = apply(**find_preset("uncrossed"), settings);
  ASSERT_FALSE(applied);
  EXPECT_EQ(applied.error().code, ErrorCode::Usage);
  EXPECT_NE(applied.error().text().find("smooth-shell"), std::string::npos) << applied.error().text();
  EXPECT_EQ(applied.error().text().find("hhh"), std::string::npos) << applied.error().text();
  EXPECT_EQ(settings, before);
}

TEST(Presets, AnUnknownNameListsTheKnown) {
  const auto unknown = find_preset("pretty");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::Usage);
  for (const Preset& preset : presets())
    EXPECT_NE(unknown.error().remedy.find(preset.name), std::string::npos) << preset.name;
}

TEST(SetDemand, TellsDemandsApartBySelection) {
  std::vector<Demand> list;
  set_demand(list, {"offset-band", true, {}, {0.1}});
  set_demand(list, {"offset-band", true, "roof", {0.2}});
  set_demand(list, {"offset-band", true, {}, {0.3}});
  EXPECT_EQ(list,
            (std::vector<Demand>{{"offset-band", true, {}, {0.3}}, {"offset-band", true, "roof", {0.2}}}));
}

}  // namespace
}  // namespace planewright
