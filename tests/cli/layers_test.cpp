// --layers, --thickness and --beams through the real binary.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "cli/command_line.h"
#include "core/diagnose/crossings.h"
#include "core/diagnose/planarity.h"
#include "core/mesh/mesh_io.h"

namespace planewright {
namespace {

using test::Ended;
using Json = nlohmann::json;

class Layers : public test::CommandLineTest {
 protected:
  using Options = std::vector<std::string>;

  Ended solve(const std::string& input, const Options& options) const {
    Options arguments{"dual", input, "-o", path("p.obj"), "--quiet", "--report", path("r.json")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
  }
  Json report(const std::string& input, const Options& options) const {
    const Ended ended = solve(input, options);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return json("r.json");
  }
  PolygonMesh mesh(const std::string& name) const { return load_mesh(path(name)).value().mesh; }
  double highest(const std::string& name) const { return mesh(name).positions().col(2).maxCoeff(); }
  static double planarity_of(const PolygonMesh& mesh) {
    return measure_planarity(mesh.positions(), mesh.faces()).max;
  }
};

TEST_F(Layers, EachIsSolvedIntoAFileOfItsOwn) {
  const std::string input = sample("dome", 60);
  const Json both = report(input, {"--layers", "outer=0.3,inner=-0.2", "--preset", "even-panels"});
  EXPECT_EQ(files(), 4);  // input, two layers, report
  EXPECT_NEAR(highest("p-outer.obj") - highest("p-inner.obj"), 0.5, 0.05);
  EXPECT_EQ(both["status"], "converged");
  ASSERT_EQ(both["layers"].size(), 2u);
  EXPECT_EQ(both["layers"][0]["name"], "outer");
  EXPECT_EQ(both["layers"][0]["offset"], 0.3);
  EXPECT_EQ(both["layers"][0]["side"], "outside");
  EXPECT_EQ(both["layers"][1]["name"], "inner");
  EXPECT_EQ(both["layers"][1]["side"], "inside");
  for (const Json& layer : both["layers"]) {
    EXPECT_EQ(layer["preset"], "even-panels");
    EXPECT_LE(layer["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9);
  }
}

TEST_F(Layers, AFileGivesEachItsOwnSettings) {
  const std::string input = sample("dome", 60);
  folder_.write("layers.json", R"({"layers": [
    {"name": "outer", "offset": 0.3, "preset": "smooth-shell", "weights": {"fairing": 0.2},
     "constraints": ["face", "offset-band=0.1:0.25"], "margin": 0.01, "thickness": 0.1},
    {"name": "inner", "offset": -0.2, "side": "inside", "no_penetration": true}]})");
  const Json both = report(
      input, {"--layers", path("layers.json"), "--preset", "even-panels", "--weights", "position=0.7"});
  const Json& outer = both["layers"][0];
  const Json& inner = both["layers"][1];
  EXPECT_EQ(outer["preset"], "smooth-shell");
  EXPECT_EQ(outer["weights"]["fairing"], 0.2);
  EXPECT_TRUE(outer["weights"].contains("normal-smoothness"));
  EXPECT_EQ(outer["margin"], 0.01);
  EXPECT_EQ(outer["demands"].size(), 2u);
  EXPECT_EQ(outer["constraints"]["offset-band"]["violated"], 0);
  EXPECT_EQ(outer["parallel_offset"]["thickness"], 0.1);
  EXPECT_TRUE(exists("p-outer-offset.obj"));
  EXPECT_EQ(inner["preset"], "even-panels");
  EXPECT_EQ(inner["weights"]["position"], 0.7);
  EXPECT_EQ(inner["no_penetration"], true);
  EXPECT_EQ(inner["crossings"], 0);
  EXPECT_FALSE(inner.contains("parallel_offset"));
  const double top = load_mesh(input).value().mesh.positions().col(2).maxCoeff();
  EXPECT_LT(highest("p-outer.obj"), top + 0.3);
  EXPECT_LT(highest("p-inner.obj"), top);
}

TEST_F(Layers, BeamsBetweenLayersAreFlatWhenDemanded) {
  const std::string input = sample("vault", 40);
  const Json apart = report(input, {"--layers", "outer=0.4,inner=-0.4", "--beams", path("b.obj")});
  EXPECT_FALSE(apart["layers"][0].contains("beams"));
  const Json twisted = apart["layers"][1]["beams"];
  EXPECT_EQ(twisted["with"], "outer");
  EXPECT_GT(twisted["max_planarity"].get<double>(), 1e-6);
  EXPECT_NEAR(planarity_of(mesh("b.obj")), twisted["max_planarity"].get<double>(), 1e-9);
  EXPECT_EQ(mesh("b.obj").face_count(), twisted["count"].get<int>());

  folder_.write("layers.json", R"({"layers": [{"name": "outer", "offset": 0.4},
    {"name": "inner", "offset": -0.4, "coplanar_with": "outer"}]})");
  for (const Options& options :
       {Options{"--layers", "outer=0.4,inner=-0.4", "--constraint", "coplanar-beams"},
        Options{"--layers", path("layers.json")}}) {
    Options with = options;
    with.insert(with.end(), {"--beams", path("b.obj")});
    const Json flat = report(input, with);
    EXPECT_FALSE(flat["layers"][0]["constraints"].contains("coplanar-beams"));
    EXPECT_EQ(flat["layers"][1]["constraints"]["coplanar-beams"]["violated"], 0);
    EXPECT_LT(flat["layers"][1]["beams"]["max_planarity"].get<double>(), 1e-7);
    EXPECT_LT(planarity_of(mesh("b.obj")), 1e-7);
  }
}

// A layer far beyond the centre of the dome is the other way round.
TEST_F(Layers, BeamsThatAreTurnedRoundAreTold) {
  const std::string input = sample("dome", 40);
  const Ended sound = solve(input, {"--layers", "a=0.2,b=-0.2", "--beams", path("b.obj")});
  EXPECT_EQ(sound.status, 0) << sound.err;
  EXPECT_EQ(sound.err.find("turned round"), std::string::npos) << sound.err;
  EXPECT_EQ(json("r.json")["layers"][1]["beams"]["turned_round"], 0);
  const Ended turned = solve(input, {"--layers", "a=0.2,b=-60", "--beams", path("b.obj")});
  const Json beams = json("r.json")["layers"][1]["beams"];
  EXPECT_GT(beams["turned_round"].get<int>(), 0);
  EXPECT_NE(turned.err.find("turned round"), std::string::npos) << turned.err;
  EXPECT_NE(turned.err.find("panel edge " + beams["most_twisted_edge"].dump() + ","), std::string::npos)
      << turned.err;
}

TEST_F(Layers, AThicknessGivesParallelPanelsAndFlatBeams) {
  const std::string input = sample("dome", 60);
  const Json thick = report(input, {"--thickness", "0.2", "--beams", path("b.obj")});
  EXPECT_FALSE(thick.contains("layers"));
  EXPECT_EQ(thick["parallel_offset"]["file"], path("p-offset.obj"));
  EXPECT_EQ(thick["beams"]["with"], "offset");
  EXPECT_LE(thick["beams"]["max_planarity"].get<double>(), 1e-9);
  EXPECT_LE(planarity_of(mesh("b.obj")), 1e-9);
  const PolygonMesh panels = mesh("p.obj"), offset = mesh("p-offset.obj");
  const Polygons faces = panels.faces();
  ASSERT_EQ(offset.faces(), faces);
  for (int f = 0; f < faces.size(); ++f) {
    const Vector3d normal = newell_vector(panels.positions(), faces[f]).normalized();
    const Vector3d foot = panels.positions().row(faces[f][0]);
    for (const int corner : faces[f])
      EXPECT_NEAR(normal.dot(Vector3d(offset.positions().row(corner)) - foot), 0.2, 1e-8);
  }
  // To the inside.
  report(input, {"--thickness", "-0.2"});
  EXPECT_LT(highest("p-offset.obj"), highest("p.obj"));
}

TEST_F(Layers, TheSummaryNamesThem) {
  const Ended both = run({"dual", sample("dome", 40), "-o", path("p.obj"), "--layers", "a=0.3,b=0",
                          "--thickness", "0.1", "--beams", path("b.obj")});
  EXPECT_EQ(both.status, 0) << both.err;
  for (const char* words : {"layer a\n", "layer b\n", "p-a.obj: ", "p-b-offset.obj", "b-a.obj", "twisted by"})
    EXPECT_NE(both.out.find(words), std::string::npos) << words << " is not in: " << both.out;
  EXPECT_TRUE(exists("b-a.obj") && exists("b-b.obj"));
}

TEST_F(Layers, RefuseListsThatAreNone) {
  const std::string input = sample("dome", 40);
  const auto refuse = [&](const Options& options, int status, const std::vector<std::string>& saying) {
    expect_refusal(solve(input, options), status, saying);
    EXPECT_EQ(files(), exists("layers.json") ? 2 : 1) << options.back();
  };
  refuse({"--layers", "outer"}, 2, {"name=offset"});
  refuse({"--layers", "outer=far"}, 2, {"'far'"});
  refuse({"--layers", "outer=nan"}, 2, {"'nan'"});
  refuse({"--layers", "a=1,a=2"}, 2, {"'a'", "twice"});
  refuse({"--layers", "=1"}, 2, {"no name"});
  refuse({"--layers", "../a=1"}, 2, {"'../a'", "file names"});
  refuse({"--beams", path("b.obj")}, 2, {"--beams", "--thickness"});
  refuse({"--layers", "a=1", "--beams", path("b.obj")}, 2, {"--beams", "several layers"});
  refuse({"--layers", "a=1,b=2", "--beams", path("b.dwg")}, 2, {".obj"});
  refuse({"--layers", path("none.json")}, 3, {"none.json"});
  refuse({"--layers", "a=0,b=0", "--beams", path("p-a.obj")}, 2, {"--beams", "same file"});

  const std::string file = path("layers.json");
  const auto refuse_file = [&](const std::string& content, const std::vector<std::string>& saying) {
    folder_.write("layers.json", content);
    std::vector<std::string> all{"layers.json"};
    all.insert(all.end(), saying.begin(), saying.end());
    refuse({"--layers", file}, 3, all);
  };
  refuse_file("{\n\"layers\": [}", {"as JSON", "line 2"});
  refuse_file(R"({"layers": [{"name": "a", "offset": 1e999}]})", {"as JSON", "1e999"});
  refuse_file("[]", {"layers"});
  refuse_file(R"({"layers": []})", {"no layer"});
  refuse_file(R"({"layers": [{"offset": 1}]})", {"layer 1", "no name"});
  refuse_file(R"({"layers": [{"name": "a"}, {"name": "b", "ofset": 1}]})",
              {"layer 2", "'ofset'", "offset, thickness"});
  refuse_file(R"({"layers": [{"name": "a", "offset": "far"}]})", {"'offset'", "far"});
  refuse_file(R"({"layers": [{"name": "a", "preset": "pretty"}]})", {"pretty", "smooth-shell"});
  folder_.write("layers.json", R"({"layers": [{"name": "a", "preset": "hhh"}]})");  // known, but no dual's
  refuse({"--layers", file}, 2, {"layer 'a'", "hhh", "smooth-shell"});
  refuse_file(R"({"layers": [{"name": "a", "weights": {"beauty": 1}}]})", {"beauty", "position"});
  refuse_file(R"({"layers": [{"name": "a", "weights": {"position": -1}}]})", {"position", "negative"});
  refuse_file(R"({"layers": [{"name": "a", "constraints": ["pretty"]}]})", {"pretty", "vertex"});
  refuse_file(R"({"layers": [{"name": "a", "side": "left"}]})", {"side", "left"});
  refuse_file(R"({"layers": [{"name": "a", "coplanar_with": "b"}, {"name": "b"}]})", {"'b'", "earlier"});
}

// Layers are solved one after the other, and none knows of the others.
TEST_F(Layers, LayersThatCrossAreTold) {
  const std::string input = sample("alpine-hut", 80);
  const auto crossings = [&](const std::string& first, const std::string& second) {
    const PolygonMesh a = mesh(first), b = mesh(second);
    const Polygons of_a = a.faces(), of_b = b.faces();
    const double touch = 1e-4 * json("r.json")["layers"][0]["mean_edge"].get<double>();
    return find_crossings({a.positions(), of_a}, {b.positions(), of_b}, touch).size();
  };
  const Ended close = solve(input, {"--layers", "a=0.2,b=0.21", "--no-penetration"});
  EXPECT_EQ(close.status, 1) << close.err;
  EXPECT_NE(close.err.find("layer b crosses layer a: "), std::string::npos) << close.err;
  const Json both = json("r.json")["layers"];
  EXPECT_GT(both[0]["crosses"]["b"].get<int>(), 0);
  EXPECT_EQ(both[0]["crosses"]["b"], both[1]["crosses"]["a"]);
  EXPECT_EQ(both[0]["crosses"].size(), 1u);
  EXPECT_EQ(both[1]["crosses"]["a"].get<size_t>(), crossings("p-a.obj", "p-b.obj"));

  const Ended apart = solve(input, {"--layers", "a=0.2,b=2", "--no-penetration"});
  EXPECT_EQ(apart.status, 0) << apart.err;
  EXPECT_EQ(json("r.json")["layers"][0]["crosses"], (Json{{"b", 0}}));

  // Nobody asked, so it is no failure.
  const Ended told =
      run({"dual", input, "-o", path("p.obj"), "--layers", "a=0.2,b=0.21", "--solver", "ipopt"});
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_NE(told.out.find("layer b crosses layer a: "), std::string::npos) << told.out;
}

TEST_F(Layers, OffsetsThatCrossAreTold) {
  const std::string input = sample("dome", 60);
  const Json thick = report(input, {"--offset", "0.2", "--thickness", "0.2", "--no-penetration"});
  EXPECT_EQ(thick["parallel_offset"]["crossings"], 0);
  EXPECT_TRUE(thick["parallel_offset"]["crosses"].empty());
  // Panels in front of the mesh, their other side in the midst of it.
  const Ended inwards = run({"dual", input, "-o", path("p.obj"), "--report", path("r.json"), "--offset",
                             "0.2", "--thickness", "-0.25", "--no-penetration"});
  EXPECT_EQ(inwards.status, 1) << inwards.err;
  EXPECT_NE(inwards.err.find("the offset crosses the mesh: "), std::string::npos) << inwards.err;
  EXPECT_NE(inwards.out.find("the offset crosses the mesh: "), std::string::npos) << inwards.out;
  const PolygonMesh offset = mesh("p-offset.obj"), roof = load_mesh(input).value().mesh;
  const Polygons panels = offset.faces(), faces = roof.faces();
  const Json sunk = json("r.json");
  EXPECT_EQ(sunk["parallel_offset"]["crossings"].get<size_t>(),
            find_crossings({offset.positions(), panels}, {roof.positions(), faces},
                           1e-4 * sunk["mean_edge"].get<double>())
                .size());

  // The offset of one in the midst of the other, and of the other's offset: each way.
  const std::string hut = sample("alpine-hut", 80);
  const Ended layers = solve(hut, {"--layers", "a=0.2,b=0.5", "--thickness", "0.3", "--no-penetration"});
  EXPECT_EQ(layers.status, 1) << layers.err;
  EXPECT_NE(layers.err.find("the offset of layer a crosses layer b: "), std::string::npos) << layers.err;
  const Json both = json("r.json")["layers"];
  EXPECT_GT(both[0]["parallel_offset"]["crosses"]["b"].get<int>(), 0);
  const PolygonMesh a = mesh("p-a-offset.obj"), b = mesh("p-b.obj"), b_offset = mesh("p-b-offset.obj");
  const Polygons of_a = a.faces(), of_b = b.faces();
  const double touch = 1e-4 * both[0]["mean_edge"].get<double>();
  EXPECT_EQ(both[0]["parallel_offset"]["crosses"]["b"].get<size_t>(),
            find_crossings({a.positions(), of_a}, {b.positions(), of_b}, touch).size() +
                find_crossings({a.positions(), of_a}, {b_offset.positions(), of_b}, touch).size());
  report(hut, {"--layers", "a=0.2,b=3", "--thickness", "0.3", "--no-penetration"});
}

// A layer may go without what the others keep; what was asked for by name stays.
TEST_F(Layers, NoPenetrationCanBeSwitchedOffForOne) {
  const std::string input = sample("dome", 40);
  folder_.write(
      "layers.json",
      R"({"layers": [{"name": "a", "offset": 0.2}, {"name": "b", "offset": 2, "no_penetration": false}]})");
  const Json both = report(input, {"--layers", path("layers.json"), "--no-penetration"});
  EXPECT_EQ(both["layers"][0]["no_penetration"], true);
  EXPECT_EQ(both["layers"][0]["demands"].size(), 3u);
  EXPECT_EQ(both["layers"][1]["no_penetration"], false);
  EXPECT_TRUE(both["layers"][1]["demands"].empty());
  EXPECT_TRUE(both["layers"][1]["crossings"].is_null());
  const Json named =
      report(input, {"--layers", path("layers.json"), "--no-penetration", "--constraint", "face"});
  ASSERT_EQ(named["layers"][1]["demands"].size(), 1u);
  EXPECT_EQ(named["layers"][1]["demands"][0]["name"], "face");
}

// What is wrong with a later layer is found before the first one is solved.
TEST_F(Layers, NothingIsWrittenIfALaterOneIsRefused) {
  const std::string input = sample("dome", 40);
  folder_.write("layers.json", R"({"layers": [{"name": "a"}, {"name": "b", "constraints": ["face@roof"]}]})");
  expect_refusal(solve(input, {"--layers", path("layers.json")}), 2, {"roof", "face"});
  EXPECT_EQ(files(), 2);
}

}  // namespace
}  // namespace planewright
