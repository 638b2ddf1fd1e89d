#include "core/export/solve_record.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace planewright {
namespace {

using Json = nlohmann::json;

SolveRecord full_record() {
  SolveRecord record;
  record.input = "roof \"A\".obj";
  record.settings.mode = ComplexKind::Planarize;
  record.settings.freedom = Freedom::Normals;
  record.settings.offset = 0.25;
  record.settings.weights = {{"position", 1.0}, {"fairing", 0.5}};
  record.health.vertices = 12;
  record.health.faces = 7;
  record.health.components = 2;
  record.health.border_loops = 1;
  record.health.border_edges = 9;
  record.health.repaired = true;
  record.health.defects.push_back({DefectKind::IsolatedVertex, 1, {4}, "kept"});
  record.solve.status = SolveStatus::Planar;
  record.solve.stop_reason = "the limit was reached";
  record.solve.solver = "ipopt";
  record.solve.iterations = 42;
  record.solve.seconds = 1.5;
  record.solve.first_order_residual = 3e-5;
  record.solve.energies = {{"position", 1.0, 2.5}, {"fairing", 0.5, 0.125}};
  record.solve.constraints = {{"incidence", 1e-15, 0}, {"unit normal", 2e-16, 3}};
  record.panels = 7;
  record.points = 12;
  record.mean_edge = 2.0;
  record.planarity.max = 1e-14;
  record.planarity.mean = 1e-15;
  record.planarity.max_relative_to_bbox = 1e-16;
  record.displacement.rms = 0.5;
  record.displacement.max = 3.0;
  record.ill_determined = {{5, 0.01}, {2, 0.02}};
  record.seconds_build = 0.25;
  record.seconds_total = 2.0;
  return record;
}

TEST(SolveRecord, JsonSaysEverything) {
  const Json json = Json::parse(to_json(full_record()));
  EXPECT_EQ(json["tool"], "planewright");
  EXPECT_TRUE(json["version"].is_string());
  EXPECT_FALSE(json["version"].get<std::string>().empty());
  EXPECT_EQ(json["input"], "roof \"A\".obj");
  EXPECT_EQ(json["mode"], "planarize");
  EXPECT_EQ(json["freedom"], "normals");
  EXPECT_EQ(json["offset"], 0.25);
  EXPECT_EQ(json["weights"], (Json{{"position", 1.0}, {"fairing", 0.5}}));
  EXPECT_EQ(json["solver"], "ipopt");
  EXPECT_EQ(json["status"], "planar, not converged");
  EXPECT_EQ(json["stop_reason"], "the limit was reached");
  EXPECT_EQ(json["iterations"], 42);
  EXPECT_EQ(json["first_order_residual"], 3e-5);
  EXPECT_GT(json["peak_memory_mb"].get<double>(), 1.0);
  EXPECT_EQ(json["seconds"], (Json{{"build", 0.25}, {"solve", 1.5}, {"total", 2.0}}));
  EXPECT_EQ(json["panels"], 7);
  EXPECT_EQ(json["points"], 12);
  EXPECT_EQ(json["mean_edge"], 2.0);
  EXPECT_EQ(json["planarity"], (Json{{"max", 1e-14}, {"mean", 1e-15}, {"max_relative_to_bbox", 1e-16}}));
  EXPECT_EQ(json["displacement"],
            (Json{{"rms", 0.5}, {"max", 3.0}, {"rms_edges", 0.25}, {"max_edges", 1.5}}));
  EXPECT_EQ(json["energies"], (Json{{"position", 2.5}, {"fairing", 0.125}}));
  EXPECT_EQ(json["constraints"]["incidence"], (Json{{"max_violation", 1e-15}, {"violated", 0}}));
  EXPECT_EQ(json["constraints"]["unit normal"], (Json{{"max_violation", 2e-16}, {"violated", 3}}));
  ASSERT_EQ(json["diagnosis"]["degenerate_points"].size(), 2u);
  EXPECT_EQ(json["diagnosis"]["degenerate_points"][0], (Json{{"point", 5}, {"singular_value", 0.01}}));
  EXPECT_EQ(json["health"]["vertices"], 12);
  EXPECT_EQ(json["health"]["components"], 2);
  EXPECT_EQ(json["health"]["border_edges"], 9);
  EXPECT_EQ(json["health"]["repaired"], true);
  EXPECT_EQ(json["health"]["defects"][0]["count"], 1);
  EXPECT_EQ(json["health"]["defects"][0]["elements"], Json({4}));
  EXPECT_EQ(json["health"]["defects"][0]["action"], "kept");
}

TEST(SolveRecord, AnEmptyRecordIsStillJson) {
  const Json json = Json::parse(to_json(SolveRecord{}));
  EXPECT_EQ(json["mode"], "dual");
  EXPECT_TRUE(json["energies"].is_object());
  EXPECT_TRUE(json["constraints"].is_object());
  EXPECT_TRUE(json["diagnosis"]["degenerate_points"].is_array());
  EXPECT_TRUE(json["health"]["defects"].is_array());
}

TEST(SolveRecord, NumbersThatAreNotFiniteBecomeNull) {
  SolveRecord record = full_record();
  record.solve.first_order_residual = std::numeric_limits<double>::quiet_NaN();
  record.planarity.max = std::numeric_limits<double>::infinity();
  const std::string text = to_json(record);
  const Json json = Json::parse(text);
  EXPECT_TRUE(json["first_order_residual"].is_null());
  EXPECT_TRUE(json["planarity"]["max"].is_null());
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf\n"), std::string::npos);
}

// A file's name is whatever bytes the system allows.
TEST(SolveRecord, NamesThatAreNotUtf8DoNotBreakIt) {
  SolveRecord record = full_record();
  record.input =
      "d\xe4"
      "cher.obj";  // latin-1
  const Json json = Json::parse(to_json(record));
  EXPECT_NE(json["input"].get<std::string>().find("cher.obj"), std::string::npos);
}

TEST(SolveRecord, IsIndentedText) {
  const std::string text = to_json(full_record());
  EXPECT_EQ(text.substr(0, 5), "{\n  \"");
  EXPECT_EQ(text.substr(text.size() - 2), "}\n");
}

TEST(PeakMemory, IsPlausible) {
  EXPECT_GT(peak_memory_mb(), 1.0);
  EXPECT_LT(peak_memory_mb(), 1e6);
}

}  // namespace
}  // namespace planewright
