#include "core/export/diagnosis_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;
using Json = nlohmann::json;

DiagnosisRecord record_of(const Scene& scene) {
  return {"", scene.complex, {}, diagnose(*scene.complex, scene.state)};
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

}  // namespace
}  // namespace planewright
