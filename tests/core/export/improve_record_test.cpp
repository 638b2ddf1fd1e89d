#include "core/export/improve_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "support/complexes.h"

namespace planewright {
namespace {

using Json = nlohmann::json;

ImproveRecord full_record() {
  ImproveRecord record;
  record.input = "roof \"A\".obj";
  record.panels_file = "panels.obj";
  record.mesh_file = "mesh.obj";
  record.seconds = 2.5;
  record.planarity.max = 1e-14;
  record.planarity.max_relative_to_bbox = 1e-16;
  record.health.vertices = 12;
  ImproveReport& report = record.report;
  report.before.panels = report.after.panels = 40;
  report.before.points = 80;
  report.before.findings[static_cast<size_t>(FindingKind::ClosePoints)] = 3;
  report.before.findings[static_cast<size_t>(FindingKind::ReversedEdge)] = 2;
  report.before.score = {1.0, 2.0, 3.0, 4.0, 5.0};
  report.after.score = {0.5, 0.0, 0.0, 0.0, 0.0};
  report.applied = {{"Flip edge 7", 0.75, 1}, {"Join faces at edge 9", 0.25, 2}};
  report.rounds = {{15, 1, 0.75, 0.5}, {8, 1, 0.25, 0.125}, {3, 0, 0.0, 0.0}};
  report.dropped = {"1 element of selection roof"};
  ImproveReport::Left left;
  left.finding = make_finding(FindingKind::FoldedOver, {ElementKind::Panel, 4}, 0.25, 0.001, 0.5);
  left.finding.place = {1.0, 2.0, 3.0};
  left.angle_defect = -12.5;
  left.tried = {{"Flip edge 3", -0.5, ""}, {"Join faces at edge 3", {}, "the mesh would fold over"}};
  report.left = {left};
  report.solve.status = SolveStatus::Planar;
  report.solve.stop_reason = "the limit was reached";
  return record;
}

TEST(ImproveRecord, HasTheKeysOfTheDocumentation) {
  const Json json = Json::parse(to_json(full_record()));
  EXPECT_EQ(json["tool"], "planewright");
  EXPECT_EQ(json["input"], "roof \"A\".obj");
  EXPECT_EQ(json["panels"], "panels.obj");
  EXPECT_EQ(json["mesh"], "mesh.obj");
  EXPECT_EQ(json["stopped"], false);
  EXPECT_EQ(json["status"], name(SolveStatus::Planar));
  EXPECT_EQ(json["stop_reason"], "the limit was reached");
  EXPECT_EQ(json["planarity"]["max"], 1e-14);
  EXPECT_EQ(json["planarity"]["max_relative_to_bbox"], 1e-16);
  EXPECT_EQ(json["seconds"], 2.5);
  EXPECT_EQ(json["health"]["vertices"], 12);
  EXPECT_EQ(json["dropped"], Json::array({"1 element of selection roof"}));
  EXPECT_EQ(json["edits"], Json::parse(R"([{"edit": "Flip edge 7", "predicted": 0.75, "round": 1},
                                           {"edit": "Join faces at edge 9", "predicted": 0.25, "round": 2}])"));
  ASSERT_EQ(json["rounds"].size(), 3u);
  EXPECT_EQ(json["rounds"][0], Json::parse(R"({"rated": 15, "edits": 1, "predicted": 0.75, "gained": 0.5})"));
}

TEST(ImproveRecord, MeasuresBeforeAndAfterAlike) {
  const Json json = Json::parse(to_json(full_record()));
  const Json& before = json["before"];
  EXPECT_EQ(before["panels"], 40);
  EXPECT_EQ(before["points"], 80);
  EXPECT_EQ(before["unbuildable"], 3);  // a reversed edge can be built
  EXPECT_EQ(before["counts"].size(), static_cast<size_t>(kFindingKinds));
  EXPECT_EQ(before["counts"]["close-points"], 3);
  EXPECT_EQ(before["counts"]["reversed-edge"], 2);
  EXPECT_EQ(before["counts"]["self-crossing"], 0);
  EXPECT_EQ(before["score"], Json::parse(R"({"total": 13.5, "energy": 1.0, "crossing": 2.0,
                                             "short_edges": 3.0, "reversed": 4.0, "far_points": 5.0})"));
  EXPECT_EQ(json["after"]["score"]["total"], 0.5);
  EXPECT_EQ(json["after"]["unbuildable"], 0);
}

TEST(ImproveRecord, ListsWhatIsLeftAndWhatWasTried) {
  const Json json = Json::parse(to_json(full_record()));
  ASSERT_EQ(json["left"].size(), 1u);
  const Json& left = json["left"][0];
  EXPECT_EQ(left["kind"], "folded-over");
  EXPECT_EQ(left["element"], Json::parse(R"({"kind": "panel", "index": 4})"));
  EXPECT_EQ(left["place"], Json::parse("[1.0, 2.0, 3.0]"));
  EXPECT_EQ(left["measure"], 0.25);
  EXPECT_EQ(left["unit"], "edges");
  EXPECT_EQ(left["angle_defect"], -12.5);
  EXPECT_EQ(left["tried"], Json::parse(R"([{"edit": "Flip edge 3", "gain": -0.5, "refused": null},
      {"edit": "Join faces at edge 3", "gain": null, "refused": "the mesh would fold over"}])"));
}

TEST(ImproveRecord, OfNoEditAndNoMeshFileIsEmptyLists) {
  ImproveRecord record;
  record.report.stopped = true;
  const Json json = Json::parse(to_json(record));
  EXPECT_EQ(json["stopped"], true);
  EXPECT_TRUE(json["mesh"].is_null());
  for (const char* list : {"edits", "rounds", "dropped", "left"})
    EXPECT_EQ(json[list], Json::array()) << list;
}

}  // namespace
}  // namespace planewright
