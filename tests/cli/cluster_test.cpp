// cluster, through the real binary.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "cli/command_line.h"

namespace planewright {
namespace {

using test::Ended;
using test::expect_refusal;
using Json = nlohmann::json;

class ClusterCommand : public test::CommandLineTest {
 protected:
  std::string written(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }
  // Two tetrahedra apart from each other, the second without its last face if it is to be open.
  std::string tetrahedra() const {
    return written("two.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\n"
                   "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n");
  }
};

TEST_F(ClusterCommand, MakesPlanarPanelsAndSaysHowNearTheyAre) {
  const std::string input = sample("dome", 600);
  for (const char* solver : {"tangent", "ipopt"}) {
    const Ended made = run({"cluster", input, "-o", path("o.obj"), "--panels", "40", "--solver", solver,
                            "--report", path("r.json")});
    EXPECT_EQ(made.status, 0) << made.err;
    for (const char* words : {"clusters: 40", "L2,1 error", "corners by valence:", "distance: rms"})
      EXPECT_NE(made.out.find(words), std::string::npos) << words << " is not in: " << made.out;
    const Json report = json("r.json");
    EXPECT_EQ(report["mode"], "cluster");
    EXPECT_EQ(report["preset"], "proxy-planes");
    EXPECT_EQ(report["status"], "converged");
    EXPECT_LE(report["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9);
    const Json& cluster = report["cluster"];
    EXPECT_EQ(cluster["asked"], 40);
    EXPECT_EQ(cluster["clusters"], 40);
    EXPECT_EQ(cluster["seeds"], "farthest");
    EXPECT_TRUE(cluster["target"].is_null());
    EXPECT_EQ(report["panels"].get<std::size_t>(), 40u + cluster["repairs"].size());
    EXPECT_GT(cluster["l21_error"].get<double>(), 0.0);
    EXPECT_EQ(cluster["euler_characteristic"]["mesh"], cluster["euler_characteristic"]["panels"]);
    int corners = 0;
    for (const auto& [valence, count] : cluster["corners_by_valence"].items()) corners += count.get<int>();
    EXPECT_EQ(corners, report["points"]);
    const Json& distance = cluster["distance"];
    for (const char* side : {"panels_to_mesh", "mesh_to_panels"})
      EXPECT_LE(distance[side]["rms"].get<double>(), distance["both"]["rms"].get<double>()) << side;
    EXPECT_LE(distance["both"]["rms"].get<double>(), distance["both"]["max"].get<double>());
    EXPECT_LE(distance["both"]["rms"].get<double>(),
              1.1 * cluster["anchor_polygons"]["both"]["rms"].get<double>());
    for (const Json& acute : cluster["acute_panels"]) EXPECT_LT(acute["degrees"].get<double>(), 30.0);
    EXPECT_EQ(run({"check", path("o.obj")}).status, 0);
  }
}

TEST_F(ClusterCommand, MetricsAndSeedsAreTold) {
  const std::string input = sample("torus", 400);
  const auto cluster = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"cluster", input,      "-o",      path("o.obj"), "--panels",
                                       "40",      "--solver", "tangent", "--report",    path("r.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended made = run(arguments);
    EXPECT_LE(made.status, 1) << made.err;
    return json("r.json")["cluster"];
  };
  EXPECT_EQ(cluster({"--metric", "l2"})["metric"],
            Json({{"normal", 0.0}, {"distance", 1.0}, {"compactness", 0.0}}));
  EXPECT_EQ(cluster({"--metric", "l21"})["metric"],
            Json({{"normal", 1.0}, {"distance", 0.0}, {"compactness", 0.0}}));
  EXPECT_GT(cluster({})["metric"]["distance"].get<double>(), 0.0);
  EXPECT_EQ(cluster({"--distance", "2", "--compactness", "0.1"})["metric"],
            Json({{"normal", 1.0}, {"distance", 2.0}, {"compactness", 0.1}}));
  const Json seven = cluster({"--seed", "7"});
  EXPECT_EQ(seven["seeds"], "random");
  EXPECT_EQ(seven["seed"], 7);
  const std::string panels = test::text_of(path("o.obj"));
  EXPECT_EQ(cluster({"--seeds", "random", "--seed", "7"}), seven);
  EXPECT_EQ(test::text_of(path("o.obj")), panels) << "the same seeds make the same panels";
}

TEST_F(ClusterCommand, AnErrorInsteadOfANumber) {
  const std::string input = sample("dome", 600);
  const Ended made = run({"cluster", input, "-o", path("o.obj"), "--error", "0.2", "--solver", "tangent",
                          "--report", path("r.json")});
  EXPECT_EQ(made.status, 0) << made.err;
  const Json cluster = json("r.json")["cluster"];
  EXPECT_EQ(cluster["target"], 0.2);
  EXPECT_EQ(cluster["target_met"], true);
  EXPECT_LT(cluster["clusters"].get<int>(), 100);
  const Ended missed = run({"cluster", input, "-o", path("m.obj"), "--error", "0.01", "--panels", "20",
                            "--solver", "tangent", "--report", path("m.json")});
  EXPECT_EQ(missed.status, 1);
  EXPECT_NE(missed.err.find("20 regions do not meet the error"), std::string::npos) << missed.err;
  EXPECT_EQ(json("m.json")["cluster"]["target_met"], false);
}

TEST_F(ClusterCommand, WhatCannotBeIsRefusedWithTheReason) {
  const std::string dome = sample("dome", 100), two = tetrahedra(), out = path("o.obj");
  expect_refusal(run({"cluster", dome, "-o", out}), 2, {"--panels", "--error"});
  expect_refusal(run({"cluster", dome, "-o", out, "--panels", "0"}), 2, {"--panels", "not 0"});
  expect_refusal(run({"cluster", dome, "-o", out, "--panels", "-3"}), 2, {"--panels", "not -3"});
  expect_refusal(run({"cluster", two, "-o", out, "--panels", "9"}), 2, {"--panels", "9 panels", "8 faces"});
  expect_refusal(run({"cluster", two, "-o", out, "--panels", "1"}), 2,
                 {"--panels", "2 separate parts", "1 panel"});
  expect_refusal(run({"cluster", dome, "-o", out, "--panels", "9", "--normal", "0", "--distance", "0"}), 2,
                 {"--metric"});
  expect_refusal(run({"cluster", dome, "-o", out, "--panels", "9", "--distance", "-1"}), 2, {"negative"});
  expect_refusal(run({"cluster", dome, "-o", out, "--panels", "9", "--compactness", "nan"}), 2, {"finite"});
  expect_refusal(run({"cluster", dome, "-o", out, "--error", "0"}), 2, {"positive"});
  expect_refusal(run({"cluster", dome, "-o", out, "--panels", "9", "--metric", "l3"}), 2, {"l21, l2"});
  expect_refusal(run({"cluster", dome, "-o", out, "--panels", "9", "--seeds", "farthest", "--seed", "1"}), 2,
                 {"--seed"});
  expect_refusal(run({"cluster", dome, "-o", out, "--panels", "9", "--preset", "uncrossed"}), 2,
                 {"clusters", "proxy-planes"});
  expect_refusal(run({"cluster", dome, "-o", out, "--panels", "9", "--constraint", "prism"}), 2,
                 {"clusters"});
  expect_refusal(run({"cluster", path("none.obj"), "-o", out, "--panels", "9"}), 3, {"none.obj"});
  EXPECT_FALSE(exists("o.obj"));
}

TEST_F(ClusterCommand, OddInputIsHandledAndTold) {
  // Each tetrahedron of one panel: split into its faces.
  const Ended two = run({"cluster", tetrahedra(), "-o", path("o.obj"), "--panels", "2", "--solver", "tangent",
                         "--report", path("r.json")});
  EXPECT_EQ(two.status, 0) << two.err;
  EXPECT_EQ(json("r.json")["panels"], 8);
  EXPECT_NE(two.out.find("repairs: "), std::string::npos) << two.out;
  // One panel for a closed model.
  const Ended one = run({"cluster", sample("torus", 200), "-o", path("t.obj"), "--panels", "1", "--solver",
                         "tangent", "--report", path("t.json")});
  EXPECT_LE(one.status, 1) << one.err;
  EXPECT_GE(json("t.json")["panels"].get<int>(), 4);
  EXPECT_FALSE(json("t.json")["cluster"]["repairs"].empty());
  // One panel for an open sheet needs no repair, and an edge of three faces is taken apart.
  const std::string fin = written("fin.obj",
                                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
                                  "f 1 2 3\nf 1 3 4\nf 1 3 5\n");
  const Ended three = run({"cluster", fin, "-o", path("f.obj"), "--panels", "3", "--solver", "tangent"});
  EXPECT_TRUE(three.status == 0 || three.status == 3) << three.err;
  EXPECT_FALSE(three.err.empty()) << "the input's edge of three faces is told";
}

TEST_F(ClusterCommand, LayersPinsAndTheBaselineWork) {
  const std::string input = sample("dome", 400);
  const std::vector<std::string> common{"cluster", input, "-o", path("o.obj"), "--panels", "30"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = common;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  const Ended layers =
      with({"--solver", "tangent", "--layers", "inner=-0.1,outer=0.1", "--report", path("l.json")});
  EXPECT_LE(layers.status, 1) << layers.err;
  ASSERT_EQ(json("l.json")["layers"].size(), 2u);
  for (const Json& layer : json("l.json")["layers"]) EXPECT_TRUE(layer.contains("cluster"));
  const Ended baseline = with({"--explicit", "--report", path("e.json")});
  EXPECT_LE(baseline.status, 1) << baseline.err;
  EXPECT_TRUE(json("e.json")["preset"].is_null());
  const std::string pins = written("pins.txt", "plane face 0\n");
  const Ended pinned = with({"--solver", "tangent", "--pin", pins, "--report", path("p.json")});
  EXPECT_EQ(pinned.status, 0) << pinned.err;
  EXPECT_EQ(json("p.json")["plane_pins"], 1);
}

TEST_F(ClusterCommand, RegionsAreWrittenAndReadAgain) {
  const std::string input = sample("torus", 400), regions = path("regions.csv");
  const Ended found = run({"cluster", input, "-o", path("o.obj"), "--panels", "40", "--solver", "tangent",
                           "--regions", regions, "--report", path("r.json")});
  ASSERT_EQ(found.status, 0) << found.err;
  const std::string text = test::text_of(regions);
  EXPECT_TRUE(text.starts_with("face,region\n0,")) << text.substr(0, 40);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), json("r.json")["health"]["faces"].get<int>() + 1);
  const Ended read = run({"cluster", input, "-o", path("again.obj"), "--from-regions", regions, "--regions",
                          path("again.csv"), "--solver", "tangent", "--report", path("again.json")});
  ASSERT_EQ(read.status, 0) << read.err;
  EXPECT_EQ(test::text_of(path("again.csv")), text);
  EXPECT_EQ(test::text_of(path("again.obj")), test::text_of(path("o.obj")))
      << "the same regions, the same panels";
  const Json cluster = json("again.json")["cluster"];
  EXPECT_EQ(cluster["seeds"], "regions");
  EXPECT_TRUE(cluster["seed"].is_null());
  EXPECT_EQ(cluster["asked"], json("r.json")["panels"]) << "repairs are among them";
  EXPECT_EQ(cluster["l21_error"], json("r.json")["cluster"]["l21_error"]);
}

TEST_F(ClusterCommand, RegionsThatAreNoneAreRefusedWithTheirPlace) {
  const std::string two = tetrahedra(), out = path("o.obj");
  const auto from = [&](const std::string& text, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"cluster", two, "-o", out, "--from-regions", written("r.csv", text)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  const std::string head = "face,region\n", apart = "0,0\n1,0\n2,0\n3,1\n4,2\n5,2\n6,2\n7,2\n";
  expect_refusal(from("0,0\n"), 3, {"r.csv:1", "face,region"});
  expect_refusal(from(head + "0,0\n1,zero\n"), 3, {"r.csv:3", "1,zero"});
  expect_refusal(from(head + "0,0\n8,0\n"), 3, {"r.csv:3", "no face 8", "8 faces"});
  expect_refusal(from(head + "0,0\n"), 3, {"r.csv", "face 1 has no region"});
  expect_refusal(from(head + "0,0\n1,0\n2,0\n3,0\n4,0\n5,0\n6,0\n7,0\n"), 3,
                 {"r.csv", "region 0", "face 4 lies apart"});
  expect_refusal(from(head + "0,0\n1,0\n2,0\n3,0\n4,2\n5,2\n6,2\n7,2\n"), 3,
                 {"r.csv", "region 1", "no face"});
  expect_refusal(from(head + apart, {"--panels", "3"}), 2, {"--from-regions", "--panels"});
  expect_refusal(from(head + apart, {"--regions", path("r.csv")}), 2, {"--regions", "--from-regions"});
  expect_refusal(run({"cluster", two, "-o", out, "--from-regions", path("none.csv")}), 3, {"none.csv"});
  expect_refusal(run({"cluster", two, "-o", out, "--panels", "2", "--regions", path("no/r.csv")}), 5,
                 {"no/r.csv"});
  EXPECT_FALSE(exists("o.obj"));
}

TEST_F(ClusterCommand, RegionsStartAtGivenFaces) {
  const std::string input = sample("torus", 400);
  const auto cluster = [&](const std::string& faces) {
    const Ended made = run({"cluster", input, "-o", path("o.obj"), "--seed-faces", faces, "--solver",
                            "tangent", "--report", path("r.json")});
    EXPECT_LE(made.status, 1) << made.err;
    return json("r.json")["cluster"];
  };
  const Json list = cluster("0,40-49,100,200,300,350");
  EXPECT_EQ(list["seeds"], "given");
  EXPECT_EQ(list["asked"], 15);
  EXPECT_EQ(cluster(written("seeds.txt", "0  # the first\n40-49\n100 200 300 350\n")), list);
  EXPECT_NE(cluster("0,60-69,110,210,310,390")["error"], list["error"]) << "seeds matter";

  const std::string two = tetrahedra(), out = path("t.obj");
  const auto refused = [&](const std::string& faces, int status, const std::vector<std::string>& words,
                           const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"cluster", two, "-o", out, "--seed-faces", faces};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refusal(run(arguments), status, words);
  };
  refused("0,8", 2, {"--seed-faces", "no face 8", "8 faces"});
  refused("5-4", 2, {"--seed-faces", "backwards"});
  refused("1,1", 2, {"--seed-faces", "twice"});
  refused("0,1", 2, {"--seed-faces"});  // none in the second tetrahedron
  refused("0,4", 2, {"--seed-faces"}, {"--seed", "3"});
  refused("0,4", 2, {"--seed-faces", "--error"}, {"--error", "0.1"});
  refused("0,4", 2, {"--seed-faces"}, {"--panels", "3"});
  refused(written("bad.txt", "0\n4 four\n"), 3, {"bad.txt:2", "four"});
  refused(path("none.txt"), 3, {"none.txt"});
  EXPECT_FALSE(exists("t.obj"));
}

TEST_F(ClusterCommand, BluntCornersRemoveAcuteOnesAndShortEdges) {
  const std::string input = std::string(PLANEWRIGHT_SOURCE_DIR) + "/assets/saddle-roof.obj";
  for (const char* solver : {"tangent", "ipopt"}) {
    const auto made = [&](const char* preset) {
      const Ended ended = run({"cluster", input, "-o", path("o.obj"), "--panels", "100", "--preset", preset,
                               "--solver", solver, "--report", path("r.json")});
      EXPECT_LE(ended.status, 1) << ended.err;
      EXPECT_EQ(json("r.json")["status"], "converged");
      EXPECT_LE(json("r.json")["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9);
      return json("r.json");
    };
    const Json sharp = made("proxy-planes"), blunt = made("blunt-corners");
    EXPECT_GE(sharp["cluster"]["acute_panels"].size(), 8u) << solver;
    EXPECT_LE(blunt["cluster"]["acute_panels"].size(), 2u) << solver;
    EXPECT_FALSE(sharp["diagnosis"]["short_edges"].empty()) << solver;
    EXPECT_TRUE(blunt["diagnosis"]["short_edges"].empty()) << solver;
    // For a price.
    const auto distance = [](const Json& report) {
      return report["cluster"]["distance"]["both"]["rms"].get<double>();
    };
    EXPECT_LT(distance(blunt), 1.4 * distance(sharp)) << solver;
  }
}

}  // namespace
}  // namespace planewright
