#include "core/export/diagnosis_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;
using Json = nlohmann::json;

DiagnosisRecord record_of(const Scene& scene) {
  DiagnosisRecord record;
  record.complex = scene.complex;
  record.diagnosis = diagnose(*scene.complex, scene.state);
  return record;
}

TEST(DiagnosisRecord, TellsWhatWasFoundWhere) {
  Scene scene = Scene::flat_grid(2, 1);
  scene.put(2, 0.3, 0.0);
  scene.put(5, 0.3, 1.0);
  const DiagnosisRecord record = record_of(scene);
  const Json json = Json::parse(to_json("a \"roof\".obj", grid(2, 1).mesh(), {record}, {}));
  EXPECT_EQ(json["input"], "a \"roof\".obj");
  EXPECT_EQ(json["mode"], "planarize");
  EXPECT_TRUE(json["status"].is_null());
  EXPECT_EQ(json["panels"], 2);
  EXPECT_EQ(json["counts"]["folded-over"], 2);
  ASSERT_EQ(json["findings"].size(), record.diagnosis.findings.size());
  for (size_t k = 0; k < record.diagnosis.findings.size(); ++k) {
    const Finding& finding = record.diagnosis.findings[k];
    const Json& told = json["findings"][k];
    EXPECT_EQ(told["kind"], info(finding.kind).name);
    EXPECT_EQ(told["element"]["index"], finding.element.index);
    EXPECT_EQ(told["second"].is_null(), !finding.second);
    EXPECT_EQ(told["measure"], finding.measure);
    EXPECT_EQ(told["place"][0], finding.place.x());
    EXPECT_EQ(told["mesh_edges"].size(), finding.mesh_edges.size());
  }
}

TEST(DiagnosisRecord, SaysThatAStateIsNotSolved) {
  const PolygonMesh mesh = twisted_grid(2, 2).mesh();
  const Json json = Json::parse(to_json("in.obj", mesh, {record_of(Scene(planarize_of(mesh)))}, {}));
  EXPECT_EQ(json["solved"], false);
  EXPECT_GT(json["off_planes"].get<double>(), 0.0);
  EXPECT_TRUE(json["counts"].is_null());
  EXPECT_TRUE(json["findings"].empty());
}

TEST(DiagnosisRecord, OfLayersIsAList) {
  DiagnosisRecord outer = record_of(Scene::flat_grid(2, 1)), inner = outer;
  outer.layer = "outer";
  inner.layer = "inner";
  inner.solve = SolveReport{};
  inner.solve->status = SolveStatus::Planar;
  const Json json = Json::parse(to_json("in.obj", grid(2, 1).mesh(), {outer, inner}, {}));
  ASSERT_EQ(json["layers"].size(), 2u);
  EXPECT_EQ(json["layers"][1]["name"], "inner");
  EXPECT_EQ(json["layers"][1]["status"], name(SolveStatus::Planar));
  EXPECT_FALSE(json.contains("findings"));
  EXPECT_TRUE(json.contains("health"));
}

TEST(DiagnosisRecord, ListsSuggestionsWithPartsThatAddUpToTheGain) {
  const PolygonMesh mesh = grid(2, 1).mesh();
  DiagnosisRecord record = record_of(Scene::flat_grid(2, 1));
  EXPECT_TRUE(Json::parse(to_json("in.obj", mesh, {record}, {}))["suggestions"].is_null());
  record.suggestions.emplace();
  EXPECT_EQ(Json::parse(to_json("in.obj", mesh, {record}, {}))["suggestions"], Json::array());

  const int e = mesh.find_edge(1, 4);
  Suggestion collapse{{MeshEdit::collapse(e), e, {1, 4}, 0.125, 2.0, 0.5}, {3.0, 1.0, 2.0, 0.5, 0.25}, {}};
  collapse.after.energy = 4.0;
  Suggestion move{{MeshEdit::move_vertex(4, {1.0, 2.0, 3.0}), e, {4}}, {1.0}, {}, false};
  record.suggestions = {collapse, move};
  const Json list = Json::parse(to_json("in.obj", mesh, {record}, {}))["suggestions"];
  ASSERT_EQ(list.size(), 2u);
  for (size_t k = 0; k < 2; ++k) {
    double sum = 0.0;
    for (const auto& [name, part] : list[k]["parts"].items()) sum += part.get<double>();
    EXPECT_DOUBLE_EQ(sum, list[k]["gain"].get<double>());
    EXPECT_EQ(list[k]["parts"].size(), 7u);
    EXPECT_EQ(list[k]["edge"], e);
    const MeshEdge edge = mesh.edge(e);
    EXPECT_EQ(list[k]["vertices"], Json::array({edge.a, edge.b}));
    EXPECT_EQ(list[k]["place"], Json::array({1.0, 0.5, 0.0}));
  }
  EXPECT_EQ(list[0]["edit"], "collapse");
  EXPECT_EQ(list[0]["element"], e);
  EXPECT_EQ(list[0]["met"], true);
  EXPECT_FALSE(list[0].contains("to"));
  EXPECT_EQ(list[0]["parts"]["energy"], -1.0);
  EXPECT_EQ(list[0]["parts"]["crossing"], 2.0);
  EXPECT_EQ(list[0]["parts"]["deviation"], -0.125);
  EXPECT_EQ(list[0]["parts"]["given_up"], -1.0);
  EXPECT_EQ(list[1]["edit"], "move-vertex");
  EXPECT_EQ(list[1]["element"], 4);
  EXPECT_EQ(list[1]["met"], false);
  EXPECT_EQ(list[1]["to"], Json::array({1.0, 2.0, 3.0}));
}

}  // namespace
}  // namespace planewright
