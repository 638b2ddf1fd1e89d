// diagnose, through the real binary.
#include <gtest/gtest.h>

#include "cli/command_line.h"
#include "core/diagnose/finding.h"

namespace planewright {
namespace {

using test::Ended;
using Json = nlohmann::json;

class Diagnose : public test::CommandLineTest {};

TEST_F(Diagnose, ACleanDesignHasNoFindings) {
  const Ended clean = run({"diagnose", sample("dome", 200)});
  EXPECT_EQ(clean.status, 0) << clean.err;
  EXPECT_NE(clean.out.find("status: converged"), std::string::npos) << clean.out;
  EXPECT_NE(clean.out.find("findings: none"), std::string::npos) << clean.out;
}

TEST_F(Diagnose, FindingsAreATableAndAReport) {
  const std::string input = sample("bad-saddle", 300);
  const Ended bad =
      run({"diagnose", input, "--mode", "dual", "--solver", "tangent", "--report", path("r.json")});
  EXPECT_EQ(bad.status, 1) << bad.err;
  for (const char* words : {"kind", "measure", "threshold", "severity", "cause", "reversed edge",
                            "panel edge", "runs backwards over the mesh edge"})
    EXPECT_NE(bad.out.find(words), std::string::npos) << words << " is not in: " << bad.out;
  const Json report = json("r.json");
  EXPECT_EQ(report["tool"], "planewright");
  EXPECT_EQ(report["input"], input);
  EXPECT_EQ(report["mode"], "dual");
  EXPECT_EQ(report["status"], "converged");
  EXPECT_EQ(report["solved"], true);
  EXPECT_LE(report["off_planes"].get<double>(), 1e-9);
  EXPECT_TRUE(report.contains("health"));
  int total = 0;
  for (const FindingKind kind : all_finding_kinds()) total += report["counts"][info(kind).name].get<int>();
  EXPECT_EQ(report["findings"].size(), static_cast<size_t>(total));
  EXPECT_GT(report["counts"]["reversed-edge"].get<int>(), 0);
  for (const Json& finding : report["findings"]) {
    if (finding["kind"] != "reversed-edge") continue;
    EXPECT_EQ(finding["element"]["kind"], "panel edge");
    EXPECT_TRUE(finding["second"].is_null());
    EXPECT_EQ(finding["place"].size(), 3u);
    EXPECT_GT(finding["measure"].get<double>(), finding["threshold"].get<double>());
    EXPECT_EQ(finding["unit"], "edges");
    EXPECT_GE(finding["severity"].get<double>(), 0.5);
    ASSERT_EQ(finding["mesh_edges"].size(), 1u);
    EXPECT_EQ(finding["mesh_edges"][0]["vertices"].size(), 2u);
  }
  // The same printed.
  const Ended printed = run({"diagnose", input, "--mode", "dual", "--solver", "tangent", "--json"});
  EXPECT_EQ(printed.status, 1);
  EXPECT_EQ(Json::parse(printed.out), report);
  // The report of a solve counts the same.
  run({"dual", input, "-o", path("o.obj"), "--solver", "tangent", "--report", path("d.json")});
  EXPECT_EQ(json("d.json")["diagnosis"]["findings"], report["counts"]);
}

TEST_F(Diagnose, TakesTheModeThatFitsTheMeshAndTheKindsAskedFor) {
  const std::string input = sample("turning-strip", 144);
  const Ended all = run({"diagnose", input, "--quiet", "--report", path("r.json")});
  EXPECT_EQ(all.status, 1) << all.err;
  EXPECT_EQ(all.out, "");
  EXPECT_EQ(json("r.json")["mode"], "planarize");
  EXPECT_GT(json("r.json")["counts"]["collapsed-quad"].get<int>(), 0);
  EXPECT_EQ(run({"diagnose", input, "--only", "far-point,self-crossing"}).status, 0);
}

TEST_F(Diagnose, TakesPanelsAsTheyAre) {
  const std::string input = sample("dome", 200);
  ASSERT_EQ(run({"dual", input, "-o", path("panels.obj"), "--quiet"}).status, 0);
  const Ended panels = run({"diagnose", path("panels.obj"), "--as-is", "--json"});
  EXPECT_EQ(panels.status, 0) << panels.out;
  EXPECT_TRUE(Json::parse(panels.out)["status"].is_null());
  EXPECT_EQ(Json::parse(panels.out)["solved"], true);
  // Two quads of which the second lies on the first.
  folder_.write("folded.obj",
                "v 0 0 0\nv 1 0 0\nv 0.3 0 0\nv 0 1 0\nv 1 1 0\nv 0.3 1 0\nf 1 2 5 4\nf 2 3 6 5\n");
  const Ended folded = run({"diagnose", path("folded.obj"), "--as-is", "--only", "folded-over"});
  EXPECT_EQ(folded.status, 1);
  EXPECT_NE(folded.out.find("panel folds over"), std::string::npos) << folded.out;
}

TEST_F(Diagnose, SaysThatNothingIsSolved) {
  const std::string input = sample("twisted-roof", 60);
  const Ended ended = run({"diagnose", input, "--as-is", "--report", path("r.json")});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.out.find("not solved"), std::string::npos) << ended.out;
  EXPECT_EQ(json("r.json")["solved"], false);
  EXPECT_TRUE(json("r.json")["counts"].is_null());
  EXPECT_TRUE(json("r.json")["findings"].empty());
}

TEST_F(Diagnose, ComparesLayersByTheirBeams) {
  const Ended ended = run({"diagnose", sample("train-station", 60), "--layers", "outer=0.5,inner=-0.5",
                           "--solver", "tangent", "--quiet", "--report", path("r.json")});
  EXPECT_EQ(ended.status, 1) << ended.err;
  const Json report = json("r.json");
  ASSERT_EQ(report["layers"].size(), 2u);
  EXPECT_EQ(report["layers"][0]["name"], "outer");
  EXPECT_EQ(report["layers"][0]["counts"]["twisted-beam"], 0);
  EXPECT_GT(report["layers"][1]["counts"]["twisted-beam"].get<int>(), 0);
}

TEST_F(Diagnose, RefusesWhatItCannotDo) {
  const std::string input = sample("dome", 50);
  expect_refusal(run({"diagnose", input, "--only", "ugly"}), 2, {"--only", "reversed-edge"});
  EXPECT_EQ(run({"diagnose", input, "--as-is", "--weights", "position=2"}).status, 2);
  EXPECT_EQ(run({"diagnose", input, "--mode", "both"}).status, 2);
  EXPECT_EQ(run({"diagnose", input, "-o", path("o.obj")}).status, 2);
  expect_refusal(run({"diagnose", input, "--report", path("no/r.json")}), 5, {"no/r.json"});
  expect_refusal(run({"diagnose", input, "--report", input}), 2, {"--report"});
  expect_refusal(run({"diagnose", path("none.off")}), 3, {"none.off"});
}

}  // namespace
}  // namespace planewright
