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

TEST_F(Diagnose, RanksEditsThatWouldBetterIt) {
  const std::string input = sample("turning-strip", 300);
  const Ended bad = run({"diagnose", input, "--solver", "tangent", "--report", path("r.json")});
  EXPECT_EQ(bad.status, 1) << bad.err;
  for (const char* words : {"suggestions: ", "edit", "gain", "energy", "cost", "Collapse edge "})
    EXPECT_NE(bad.out.find(words), std::string::npos) << words << " is not in: " << bad.out;
  const Json list = json("r.json")["suggestions"];
  ASSERT_GT(list.size(), 2u);
  double before = 1e9;
  for (const Json& suggestion : list) {
    EXPECT_EQ(suggestion["edit"], "collapse");
    EXPECT_GE(suggestion["element"].get<int>(), 0);
    EXPECT_EQ(suggestion["vertices"].size(), 2u);
    EXPECT_EQ(suggestion["place"].size(), 3u);
    const double gain = suggestion["gain"].get<double>();
    EXPECT_GE(gain, 0.1);
    EXPECT_LE(gain, before);
    before = gain;
    double sum = 0.0;
    for (const auto& [name, part] : suggestion["parts"].items()) sum += part.get<double>();
    EXPECT_NEAR(sum, gain, 1e-12);
  }
  // Findings alone.
  const Ended findings =
      run({"diagnose", input, "--solver", "tangent", "--no-suggestions", "--report", path("n.json")});
  EXPECT_EQ(findings.status, 1);
  EXPECT_EQ(findings.out.find("suggestions"), std::string::npos) << findings.out;
  Json without = json("n.json");
  EXPECT_TRUE(without["suggestions"].is_null());
  without["suggestions"] = list;
  EXPECT_EQ(without, json("r.json"));
}

TEST_F(Diagnose, RatesEditsUnderConstraints) {
  const Ended ended = run({"diagnose", sample("turning-strip", 144), "--solver", "tangent", "--constraint",
                           "uncrossed", "--quiet", "--report", path("r.json")});
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_GT(json("r.json")["suggestions"].size(), 0u);
}

TEST_F(Diagnose, TakesThresholds) {
  const std::string input = sample("bad-saddle", 300);
  const auto close = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"diagnose",         input,     "--solver", "tangent",
                                       "--no-suggestions", "--quiet", "--report", path("r.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(arguments).status, 1);
    return json("r.json");
  };
  const Json usual = close({}),
             changed = close({"--threshold", "close-points=0.2", "--threshold", "reversed-edge=1e3"});
  EXPECT_GT(changed["counts"]["close-points"].get<int>(), usual["counts"]["close-points"].get<int>());
  EXPECT_GT(usual["counts"]["reversed-edge"].get<int>(), 0);
  EXPECT_EQ(changed["counts"]["reversed-edge"], 0);
  for (const Json& finding : changed["findings"])
    if (finding["kind"] == "close-points") {
      EXPECT_EQ(finding["threshold"], 0.2);
    }
  const Json as_is = [&] {
    folder_.write("dart.obj", "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 0.5 1 0\nf 1 2 3 4\n");
    EXPECT_EQ(run({"diagnose", path("dart.obj"), "--as-is", "--threshold", "close-points=3", "--report",
                   path("r.json")})
                  .status,
              1);
    return json("r.json");
  }();
  EXPECT_GT(as_is["counts"]["close-points"].get<int>(), 0);
  EXPECT_TRUE(as_is["suggestions"].is_null());
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
