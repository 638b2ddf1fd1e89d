// improve, through the real binary.
#include <gtest/gtest.h>

#include "cli/command_line.h"
#include "core/diagnose/finding.h"
#include "core/mesh/mesh_io.h"

namespace planewright {
namespace {

using test::Ended;
using Json = nlohmann::json;

class Improve : public test::CommandLineTest {
 protected:
  static std::string asset(const std::string& name) {
    return std::string(PLANEWRIGHT_SOURCE_DIR) + "/assets/" + name;
  }
};

TEST_F(Improve, BettersABundledDesignAndWritesAllOfIt) {
  const Ended ended = run({"improve", asset("train-station.obj"), "-o", path("p.obj"), "--mesh",
                           path("m.obj"), "--report", path("r.json"), "--solver", "tangent"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* words :
       {"edits in", "Flip edge", "before", "after", "points too close", "score", "planar to"})
    EXPECT_NE(ended.out.find(words), std::string::npos) << words << " is not in: " << ended.out;
  EXPECT_NE(ended.err.find("round 1:"), std::string::npos) << ended.err;
  EXPECT_EQ(files(), 3);  // and nothing half written
  const Json report = json("r.json");
  EXPECT_EQ(report["tool"], "planewright");
  EXPECT_EQ(report["input"], asset("train-station.obj"));
  EXPECT_EQ(report["panels"], path("p.obj"));
  EXPECT_EQ(report["mesh"], path("m.obj"));
  EXPECT_EQ(report["stopped"], false);
  EXPECT_EQ(report["status"], "converged");
  EXPECT_GT(report["before"]["unbuildable"].get<int>(), 0);
  EXPECT_EQ(report["after"]["unbuildable"], 0);
  EXPECT_TRUE(report["left"].empty());
  EXPECT_LE(report["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9);
  int edits = 0;
  double score = report["before"]["score"]["total"].get<double>();
  for (const Json& round : report["rounds"]) {
    edits += round["edits"].get<int>();
    score -= round["gained"].get<double>();
    EXPECT_GE(round["gained"].get<double>(), 0.0);
  }
  EXPECT_EQ(report["edits"].size(), static_cast<size_t>(edits));
  EXPECT_NEAR(score, report["after"]["score"]["total"].get<double>(), 1e-9);
  // The mesh is one to go on with, and better by itself.
  const auto mesh = load_mesh(path("m.obj")).value();
  EXPECT_TRUE(mesh.health.healthy());
  EXPECT_EQ(run({"check", path("p.obj")}).status, 0);
  run({"diagnose", path("m.obj"), "--solver", "tangent", "--no-suggestions", "--quiet", "--report",
       path("d.json")});
  EXPECT_LT(json("d.json")["counts"]["close-points"].get<int>(),
            report["before"]["counts"]["close-points"].get<int>());
  EXPECT_EQ(json("d.json")["panels"], report["after"]["panels"]);
}

TEST_F(Improve, CollapsesTheTurnsOfQuads) {
  const Ended ended = run({"improve", asset("twisted-roof.obj"), "-o", path("p.ply"), "--mesh", path("m.off"),
                           "--report", path("r.json"), "--solver", "tangent", "--quiet"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(ended.err, "");
  const Json report = json("r.json");
  EXPECT_GT(report["before"]["counts"]["collapsed-quad"].get<int>(), 0);
  EXPECT_EQ(report["after"]["counts"]["collapsed-quad"], 0);
  for (const Json& edit : report["edits"])
    EXPECT_EQ(edit["edit"].get<std::string>().substr(0, 13), "Collapse edge");
  EXPECT_TRUE(load_mesh(path("m.off")));
}

TEST_F(Improve, DoesNoMoreEditsThanAskedAndListsWhatIsLeft) {
  const std::string input = sample("bad-saddle", 300);
  const Ended none = run({"improve", input, "-o", path("p.obj"), "--mesh", path("m.obj"), "--report",
                          path("r.json"), "--solver", "tangent", "--max-edits", "0"});
  EXPECT_EQ(none.status, 1) << none.err;  // bad places are left
  EXPECT_NE(none.out.find("0 edits"), std::string::npos) << none.out;
  EXPECT_NE(none.out.find("left"), std::string::npos) << none.out;
  const Json report = json("r.json");
  EXPECT_TRUE(report["edits"].empty());
  EXPECT_TRUE(report["rounds"].empty());
  EXPECT_EQ(report["before"], report["after"]);
  EXPECT_EQ(report["left"].size(), report["after"]["unbuildable"].get<size_t>());
  for (const Json& left : report["left"]) {
    EXPECT_LT(left["angle_defect"].get<double>(), 0.0);
    EXPECT_GE(left["tried"].size(), 20u);
    for (const Json& tried : left["tried"]) EXPECT_NE(tried["gain"].is_null(), tried["refused"].is_null());
  }
  // Mesh and panels are those of no edit.
  const auto before = load_mesh(input).value(), after = load_mesh(path("m.obj")).value();
  EXPECT_EQ(before.mesh.faces(), after.mesh.faces());
  EXPECT_EQ(before.mesh.positions(), after.mesh.positions());
  run({"improve", input, "-o", path("p.obj"), "--report", path("r.json"), "--solver", "tangent",
       "--max-edits", "1", "--quiet"});
  EXPECT_EQ(json("r.json")["edits"].size(), 1u);
  EXPECT_TRUE(json("r.json")["mesh"].is_null());
}

TEST_F(Improve, ThresholdsSayWhatIsBad) {
  const std::string input = sample("bad-saddle", 300);
  const auto close = [&](const std::string& threshold) {
    const Ended ended =
        run({"improve", input, "-o", path("p.obj"), "--report", path("r.json"), "--solver", "tangent",
             "--max-edits", "0", "--quiet", "--threshold", "close-points=" + threshold});
    EXPECT_LE(ended.status, 1) << ended.err;
    return json("r.json")["before"]["counts"]["close-points"].get<int>();
  };
  EXPECT_EQ(close("0"), 0);
  EXPECT_GT(close("0.2"), close("0.12"));
}

TEST_F(Improve, TellsThatNothingWasTriedWhereDemandsConflict) {
  const Ended ended = run({"improve", sample("bad-saddle", 60), "-o", path("p.obj"), "--report",
                           path("r.json"), "--solver", "tangent", "--constraint", "convex"});
  EXPECT_EQ(ended.status, 4) << ended.err;
  EXPECT_NE(ended.err.find("no edit was tried"), std::string::npos) << ended.err;
  EXPECT_TRUE(json("r.json")["edits"].empty());
  EXPECT_EQ(json("r.json")["status"], "infeasible");
  EXPECT_TRUE(exists("p.obj"));
}

TEST_F(Improve, RefusesWhatItCannotDo) {
  const std::string input = sample("dome", 50), out = path("p.obj");
  EXPECT_EQ(run({"improve", input}).status, 2);
  expect_refusal(run({"improve", input, "-o", out, "--mesh", out}), 2, {"--mesh", "-o", "same file"});
  expect_refusal(run({"improve", input, "-o", input}), 2, {"-o", "IN", "same file"});
  expect_refusal(run({"improve", input, "-o", out, "--mesh", input}), 2, {"--mesh", "IN", "same file"});
  expect_refusal(run({"improve", input, "-o", out, "--report", out}), 2, {"--report", "same file"});
  expect_refusal(run({"improve", input, "-o", path("p.3dm")}), 2, {"p.3dm", ".obj"});
  expect_refusal(run({"improve", input, "-o", out, "--mesh", path("m.3dm")}), 2, {"m.3dm", ".obj"});
  expect_refusal(run({"improve", input, "-o", path("no/p.obj")}), 5, {"no/p.obj"});
  expect_refusal(run({"improve", path("none.obj"), "-o", out}), 3, {"none.obj"});
  for (const char* number : {"-1", "1.5", "many"})
    EXPECT_EQ(run({"improve", input, "-o", out, "--max-edits", number}).status, 2) << number;
  // It rates edits of one layer, and writes no beams.
  for (const char* option : {"--layers", "--thickness", "--beams"})
    EXPECT_EQ(run({"improve", input, "-o", out, option, "0.1"}).status, 2) << option;
  EXPECT_EQ(run({"improve", input, "-o", out, "--explicit"}).status, 2);
  const Ended help = run({"improve", "--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* option : {"--layers", "--explicit"})
    EXPECT_EQ(help.out.find(option), std::string::npos) << option;
  EXPECT_EQ(files(), 1);
}

TEST_F(Improve, AndDiagnoseRefuseThresholdsThatAreNone) {
  const std::string input = sample("dome", 50);
  const std::vector<std::pair<std::string, std::string>> wrong{{"close-points", "KIND=VALUE"},
                                                               {"ugly=1", "reversed-edge"},
                                                               {"=1", "reversed-edge"},
                                                               {"close-points=", "at least 0"},
                                                               {"close-points=wide", "at least 0"},
                                                               {"close-points=0.1x", "at least 0"},
                                                               {"close-points=-0.1", "at least 0"},
                                                               {"close-points=inf", "at least 0"},
                                                               {"close-points=nan", "at least 0"}};
  for (const auto& [text, saying] : wrong) {
    SCOPED_TRACE(text);
    expect_refusal(run({"improve", input, "-o", path("p.obj"), "--threshold", text}), 2,
                   {"--threshold", saying});
    expect_refusal(run({"diagnose", input, "--threshold", text}), 2, {"--threshold", saying});
  }
  expect_refusal(run({"diagnose", input, "--threshold", "far-point=1", "--threshold", "far-point=2"}), 2,
                 {"--threshold", "twice"});
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace planewright
