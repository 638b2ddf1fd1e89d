#include "core/export/solve_record.h"

#include <gtest/gtest.h>

#include <algorithm>
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
  record.solve.constraints = {{"incidence", 1e-15, 0, "edges", 36, {ElementKind::Point, 4}, 5},
                              {"unit normal", 0.0, 3, "", 7, {}}};
  record.solve.conflicts = {{"vertex", {ElementKind::Point, 8}}, {"edge", {ElementKind::PanelEdge, 2}}};
  record.solve.rounds = 3;
  record.solve.crossings = 2;
  record.solve.crossings_waived = 1;
  record.preset = "smooth-shell";
  record.reference = "survey.ply";
  record.settings.side = Side::Inside;
  record.settings.no_penetration = true;
  record.settings.demands.margin = 0.01;
  record.settings.demands.list = {{"offset-band", true, "roof", {-1e20, 0.5}}, {"face", false, {}, {}}};
  record.settings.demands.pins = {{{PointKind::Vertex, 1}, {0.0, {}, {}}}};
  record.settings.demands.plane_pins = {{2, {}}, {3, {}}};
  record.settings.demands.waived = {{"face", {ElementKind::Panel, 6}}};
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
  EXPECT_EQ(json["constraints"]["incidence"], (Json{{"max_violation", 1e-15},
                                                    {"violated", 0},
                                                    {"rows", 36},
                                                    {"waived", 5},
                                                    {"unit", "edges"},
                                                    {"worst", "point 4"}}));
  EXPECT_TRUE(json["constraints"]["unit normal"]["worst"].is_null());  // nothing is violated
  EXPECT_EQ(json["constraints"]["unit normal"]["violated"], 3);
  EXPECT_EQ(json["conflicts"], Json::parse(R"([{"demand": "vertex", "element": {"kind": "point", "index": 8}},
                            {"demand": "edge", "element": {"kind": "panel edge", "index": 2}}])"));
  EXPECT_EQ(json["waived"], Json::parse(R"([{"demand": "face", "element": {"kind": "panel", "index": 6}}])"));
  EXPECT_EQ(json["rounds"], 3);
  EXPECT_EQ(json["crossings"], 2);
  EXPECT_EQ(json["crossings_waived"], 1);
  EXPECT_EQ(json["demands_without_rows"], Json({"offset-band"}));  // "face" is off
  EXPECT_EQ(json["preset"], "smooth-shell");
  EXPECT_EQ(json["reference"], "survey.ply");
  EXPECT_EQ(json["side"], "inside");
  EXPECT_EQ(json["no_penetration"], true);
  EXPECT_EQ(json["margin"], 0.01);
  EXPECT_EQ(json["demands"],  // those that are on
            Json::parse(R"([{"name": "offset-band", "values": [null, 0.5], "selection": "roof"}])"));
  EXPECT_EQ(json["pins"], 1);
  EXPECT_EQ(json["plane_pins"], 2);
  EXPECT_FALSE(json.contains("layers") || json.contains("parallel_offset") || json.contains("beams"));
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
  EXPECT_TRUE(json["preset"].is_null());
  EXPECT_TRUE(json["reference"].is_null());
  EXPECT_TRUE(json["crossings"].is_null());  // not counted
  EXPECT_TRUE(json["crossings_waived"].is_null());
  EXPECT_TRUE(json["demands_without_rows"].empty());
}

TEST(SolveRecord, OffsetAndBeamsStandInTheirLayer) {
  SolveRecord record = full_record();
  OffsetRecord& offset = record.offset_layer.emplace();
  offset.file = "p-offset.obj";
  offset.thickness = 0.2;
  offset.blunted = {{4, 1.5}};
  offset.residuals = {{7, 0.25}, {9, 0.5}};
  offset.crossings = 6;
  offset.crosses = {{"inner", 8}};
  offset.planarity.max = 0.125;
  record.beams = BeamsRecord{"b.obj", "outer", 12, 1e-9, 0.5, 7, 2};
  const Json json = Json::parse(to_json(record));
  EXPECT_EQ(json["parallel_offset"]["file"], "p-offset.obj");
  EXPECT_EQ(json["parallel_offset"]["thickness"], 0.2);
  EXPECT_EQ(json["parallel_offset"]["planarity"]["max"], 0.125);
  EXPECT_EQ(json["parallel_offset"]["blunted"], Json::parse(R"([{"point": 4, "wanted_move": 1.5}])"));
  EXPECT_EQ(json["parallel_offset"]["residuals"],
            Json::parse(R"([{"point": 7, "residual": 0.25}, {"point": 9, "residual": 0.5}])"));
  EXPECT_EQ(json["parallel_offset"]["crossings"], 6);
  EXPECT_EQ(json["parallel_offset"]["crosses"], (Json{{"inner", 8}}));
  EXPECT_EQ(json["beams"], (Json{{"file", "b.obj"},
                                 {"with", "outer"},
                                 {"count", 12},
                                 {"max_planarity", 1e-9},
                                 {"max_twist", 0.5},
                                 {"most_twisted_edge", 7},
                                 {"turned_round", 2}}));
  record.beams->most_twisted_edge = -1;
  EXPECT_TRUE(Json::parse(to_json(record))["beams"]["most_twisted_edge"].is_null());
}

TEST(SolveRecord, LayersShareTheHeading) {
  SolveRecord outer = full_record(), inner = full_record();
  outer.layer = "outer";
  outer.solve.status = SolveStatus::Converged;
  inner.layer = "inner";
  inner.settings.offset = -0.5;
  const Json json = Json::parse(to_json(std::vector<SolveRecord>{outer, inner}));
  EXPECT_EQ(json["tool"], "planewright");
  EXPECT_EQ(json["input"], "roof \"A\".obj");
  EXPECT_EQ(json["status"], "planar, not converged");  // of the one that is not
  EXPECT_EQ(json["health"]["vertices"], 12);
  ASSERT_EQ(json["layers"].size(), 2u);
  EXPECT_EQ(json["layers"][0]["name"], "outer");
  EXPECT_EQ(json["layers"][0]["status"], "converged");
  EXPECT_EQ(json["layers"][1]["name"], "inner");
  EXPECT_EQ(json["layers"][1]["offset"], -0.5);
  EXPECT_EQ(json["layers"][1]["conflicts"].size(), 2u);
  EXPECT_FALSE(json.contains("crosses"));
  EXPECT_TRUE(json["layers"][0]["crosses"].empty());
  outer.crosses = {{"inner", 3}};
  EXPECT_EQ(Json::parse(to_json(std::vector<SolveRecord>{outer, inner}))["layers"][0]["crosses"],
            (Json{{"inner", 3}}));
  inner.solve.status = SolveStatus::Converged;
  EXPECT_EQ(Json::parse(to_json(std::vector<SolveRecord>{outer, inner}))["status"], "converged");
}

TEST(SolveRecord, TheStatusOfLayersIsTheWorst) {
  const std::vector<SolveStatus> order{SolveStatus::Converged, SolveStatus::Planar, SolveStatus::Stopped,
                                       SolveStatus::NotPlanar, SolveStatus::Failed, SolveStatus::Infeasible};
  for (size_t a = 0; a < order.size(); ++a)
    for (size_t b = 0; b < order.size(); ++b) {
      SolveRecord first = full_record(), second = full_record();
      first.solve.status = order[a];
      second.solve.status = order[b];
      EXPECT_EQ(Json::parse(to_json(std::vector<SolveRecord>{first, second}))["status"],
                name(order[std::max(a, b)]));
    }
}

TEST(SolveRecord, DemandsThatHoldNothingAreNamed) {
  SolveRecord record = full_record();
  record.settings.demands.list = {{"face", true, {}, {}},
                                  {"star", true, {}, {}},
                                  {"star", true, "roof", {}},
                                  {"edge", false, {}, {}},
                                  {"prism", true, {}, {}}};
  record.solve.constraints.push_back({"face", 0.0, 0, "edges", 4, {}});
  record.solve.constraints.push_back({"prism", 0.0, 0, "edges", 0, {}});
  EXPECT_EQ(demands_without_rows(record), (std::vector<std::string>{"star", "prism"}));
  record.solve.constraints.clear();  // nothing is known
  EXPECT_TRUE(demands_without_rows(record).empty());
}

TEST(SolveRecord, SelfCrossingsAreForbiddenByDemandsOnTheWholeModel) {
  SolveRecord record = full_record();
  record.self_crossing = {2, 5};
  const auto forbidden = [&](std::vector<Demand> demands) {
    record.settings.demands.list = std::move(demands);
    return forbidden_self_crossings(record);
  };
  EXPECT_TRUE(forbidden({{"face", true, {}, {}}}).empty());
  EXPECT_TRUE(forbidden({{"star", true, "roof", {}}, {"uncrossed", false, {}, {}}}).empty());
  EXPECT_EQ(forbidden({{"star", true, {}, {}}}), (std::vector<int>{2, 5}));
  EXPECT_EQ(forbidden({{"uncrossed", true, {}, {}}}), (std::vector<int>{2, 5}));
  record.settings.demands.waived = {{"star", {ElementKind::Panel, 2}}, {"star", {ElementKind::Point, 5}}};
  EXPECT_EQ(forbidden({{"star", true, {}, {}}}), (std::vector<int>{5}));
  EXPECT_EQ(forbidden({{"star", true, {}, {}}, {"uncrossed", true, {}, {}}}), (std::vector<int>{2, 5}));
}

TEST(ReadWaivers, ReadsWhatToJsonWrote) {
  const SolveRecord record = full_record();
  const std::vector<Waiver> both{{"face", {ElementKind::Panel, 6}},
                                 {"vertex", {ElementKind::Point, 8}},
                                 {"edge", {ElementKind::PanelEdge, 2}}};
  const EarlierReport read = read_waivers(to_json(record), "r.json", "").value();
  EXPECT_EQ(read.waivers, both);
  EXPECT_EQ(read.panels, 7);
  EXPECT_EQ(read.points, 12);
  SolveRecord outer = record, inner = record;
  outer.layer = "outer";
  outer.solve.conflicts.clear();
  inner.layer = "inner";
  const std::string layered = to_json(std::vector<SolveRecord>{outer, inner});
  EXPECT_EQ(read_waivers(layered, "r.json", "outer").value().waivers, (std::vector<Waiver>{both[0]}));
  EXPECT_EQ(read_waivers(layered, "r.json", "inner").value().waivers, both);
}

TEST(ReadWaivers, RefusesWhatIsNoSuchReport) {
  const auto refused = [](const std::string& json, const std::string& layer, const std::string& says) {
    const auto read = read_waivers(json, "r.json", layer);
    ASSERT_FALSE(read) << json;
    EXPECT_EQ(read.error().code, ErrorCode::Unreadable);
    EXPECT_EQ(read.error().where, "r.json");
    EXPECT_NE(read.error().text().find(says), std::string::npos) << read.error().text();
  };
  const std::string flat = to_json(full_record());
  SolveRecord named = full_record();
  named.layer = "outer";
  const std::string layered = to_json(std::vector<SolveRecord>{named});
  for (const char* json : {"", "no json", "[]", "{}", "3"}) refused(json, "", "no report");
  refused(flat, "outer", "not one of several layers");
  refused(layered, "", "one of several layers");
  refused(layered, "inner", "It has: outer");
  refused(R"({"tool": "planewright"})", "", "how many panels");
  refused(R"({"tool": "planewright", "panels": 1.5, "points": 3})", "", "how many panels");
  refused(R"({"tool": "planewright", "panels": 1, "points": 3})", "", "no list");
  refused(R"({"tool": "planewright", "panels": 7, "points": 3, "waived": [], "conflicts": [)"
          R"({"demand": "pretty", "element": {"kind": "panel", "index": 1}}]})",
          "", "'pretty'");
  for (const char* known : {"pin", "plane pin", "no-penetration", "coplanar-beams"})
    EXPECT_TRUE(
        read_waivers(R"({"tool": "planewright", "panels": 7, "points": 3, "waived": [], "conflicts": [)"
                     R"({"demand": ")" +
                         std::string(known) + R"(", "element": {"kind": "panel", "index": 1}}]})",
                     "r.json", ""))
        << known;
  for (const char* entry : {"3", "{}", R"({"demand": "face", "element": {"kind": "roof", "index": 1}})",
                            R"({"demand": "face", "element": {"kind": "panel", "index": -1}})",
                            R"({"demand": "face", "element": {"kind": "panel", "index": 1.5}})",
                            R"({"demand": 3, "element": {"kind": "panel", "index": 1}})"})
    refused(R"({"tool": "planewright", "panels": 7, "points": 3, "waived": [], "conflicts": [)" +
                std::string(entry) + "]}",
            "", "no demand at an element");
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
