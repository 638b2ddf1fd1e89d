// Presets, weights, constraints, pins and references through the real binary: each with its effect on the
// file that is written, and what is refused.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "cli/command_line.h"
#include "core/design/presets.h"
#include "core/diagnose/crossings.h"
#include "core/diagnose/planarity.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/mesh_io.h"
#include "core/problem/demands/demand_catalogue.h"
#include "core/problem/energies/energy_catalogue.h"

namespace planewright {
namespace {

using test::Ended;
using Json = nlohmann::json;

class Steering : public test::CommandLineTest {
 protected:
  using Options = std::vector<std::string>;

  Ended solve(const std::string& command, const std::string& input, const Options& options) const {
    Options arguments{command, input, "-o", path("p.obj"), "--quiet", "--report", path("r.json")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
  }
  // The report of a solve that succeeds.
  Json report(const std::string& command, const std::string& input, const Options& options) const {
    const Ended ended = solve(command, input, options);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return json("r.json");
  }
  PolygonMesh written() const { return load_mesh(path("p.obj")).value().mesh; }
  // How far the panels of a closed dual lie in front of the vertices that they belong to, along their
  // normals.
  Vector lifts(const std::string& input) const {
    const PolygonMesh mesh = load_mesh(input).value().mesh, panels = written();
    const Polygons polygons = panels.faces();
    Vector out(mesh.vertex_count());
    for (int i = 0; i < mesh.vertex_count(); ++i) {
      const Vector3d normal = newell_vector(panels.positions(), polygons[i]).normalized();
      out[i] = normal.dot(panels.positions().row(polygons[i][0]) - mesh.positions().row(i));
    }
    return out;
  }
  void refuse(const std::string& input, const Options& options, int status,
              const std::vector<std::string>& saying) const {
    expect_refusal(solve("dual", input, options), status, saying);
    EXPECT_FALSE(exists("p.obj"));
  }
  // The vertex of a file's mesh that lies highest.
  static int top_vertex(const std::string& file) {
    Eigen::Index top = 0;
    load_mesh(file).value().mesh.positions().col(2).maxCoeff(&top);
    return static_cast<int>(top);
  }
};

TEST_F(Steering, APresetSetsTheWeightsAndSingleOnesWin) {
  const std::string input = sample("vault", 60);
  const Json preset = report("dual", input, {"--preset", "smooth-shell"});
  EXPECT_EQ(preset["preset"], "smooth-shell");
  EXPECT_EQ(preset["weights"], Json((*find_preset("smooth-shell"))->weights));
  EXPECT_TRUE(preset["energies"].contains("normal-smoothness"));

  const Json over = report("dual", input, {"--preset", "smooth-shell", "--weights", "position=2,fairing=0"});
  EXPECT_EQ(over["weights"]["position"], 2.0);
  EXPECT_EQ(over["weights"]["fairing"], 0.0);
  EXPECT_EQ(over["weights"]["normal-smoothness"], preset["weights"]["normal-smoothness"]);
  EXPECT_LT(over["displacement"]["rms"].get<double>(), preset["displacement"]["rms"].get<double>());
}

TEST_F(Steering, EveryPresetMakesPlanarPanels) {
  const std::string triangles = sample("dome", 40), quads = sample("twisted-roof", 40);
  for (const Preset& preset : presets()) {
    const Ended ended = solve(preset.for_planarize ? "planarize" : "dual",
                              preset.for_planarize ? quads : triangles, {"--preset", preset.name});
    EXPECT_EQ(ended.status, 0) << preset.name << ": " << ended.err;
    EXPECT_LE(json("r.json")["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9) << preset.name;
  }
}

TEST_F(Steering, ThePresetUncrossedDemandsIt) {
  const Json uncrossed = report("planarize", sample("twisted-roof", 40), {"--preset", "uncrossed"});
  EXPECT_EQ(uncrossed["demands"], Json::parse(R"([{"name": "uncrossed", "values": []}])"));
  EXPECT_EQ(uncrossed["constraints"]["uncrossed"]["violated"], 0);
  EXPECT_GT(uncrossed["constraints"]["uncrossed"]["rows"].get<int>(), 0);
  EXPECT_TRUE(uncrossed["diagnosis"]["crossing_panels"].empty());
}

TEST_F(Steering, WeightsOfZeroStillGiveAValidSolve) {
  const Json zero = report("dual", sample("dome", 60), {"--weights", "position=0"});
  EXPECT_EQ(zero["status"], "converged");
  EXPECT_LE(zero["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9);
}

TEST_F(Steering, UnknownAndUnfitPresetsListTheOthers) {
  const std::string input = sample("dome", 40);
  refuse(input, {"--preset", "pretty"}, 2, {"--preset", "pretty", "smooth-shell", "uncrossed", "hhh"});
  refuse(input, {"--preset", "hhl"}, 2, {"--preset", "hhl", "smooth-shell"});
}

// A band holds the panels where the offset alone would not.
TEST_F(Steering, AConstraintTakesItsValues) {
  const std::string input = sample("dome", 60);
  report("dual", input, {"--offset", "0.5"});
  EXPECT_GT(lifts(input).maxCoeff(), 0.4);
  EXPECT_LT(lifts(input).minCoeff(), 0.25);
  const Json band = report("dual", input, {"--offset", "0.5", "--constraint", "offset-band=0.25:0.4"});
  EXPECT_EQ(band["demands"], Json::parse(R"([{"name": "offset-band", "values": [0.25, 0.4]}])"));
  EXPECT_EQ(band["constraints"]["offset-band"]["violated"], 0);
  EXPECT_GE(lifts(input).minCoeff(), 0.25);
  EXPECT_LE(lifts(input).maxCoeff(), 0.4);
  // Without a lower end.
  const Json low = report("dual", input, {"--offset", "0.5", "--constraint", "offset-band=:0.1"});
  EXPECT_EQ(low["demands"], Json::parse(R"([{"name": "offset-band", "values": [null, 0.1]}])"));
  EXPECT_LE(lifts(input).maxCoeff(), 0.1);
  EXPECT_LT(lifts(input).minCoeff(), 0.1 - 1e-3);
}

TEST_F(Steering, ASelectionLimitsAConstraint) {
  const std::string input = sample("dome", 60);
  const int top = top_vertex(input);
  folder_.write("s.txt", "# the top\ntop: vertices " + std::to_string(top) + "\n");
  report("dual", input, {});
  EXPECT_LT(lifts(input)[top], 0.3);
  const Json raised =
      report("dual", input,
             {"--select", path("s.txt"), "--constraint", "offset-band=0.4:0.6@top", "--constraint", "star"});
  EXPECT_EQ(raised["demands"].size(), 2u);
  const Vector lift = lifts(input);
  EXPECT_GE(lift[top], 0.4);
  EXPECT_LE(lift[top], 0.6);
  EXPECT_LT(lift.minCoeff(), 0.1);  // others are not held
}

TEST_F(Steering, NoPenetrationKeepsPanelsClearOfTheMesh) {
  const std::string input = sample("saddle-roof", 60);
  const PolygonMesh mesh = load_mesh(input).value().mesh;
  const Polygons faces = mesh.faces();
  const auto crossings = [&] {
    const PolygonMesh panels = written();
    const Polygons polygons = panels.faces();
    return find_crossings({panels.positions(), polygons}, {mesh.positions(), faces}, 1e-9).size();
  };
  EXPECT_TRUE(report("dual", input, {})["crossings"].is_null());
  EXPECT_GT(crossings(), 0u);
  const Json clear = report("dual", input, {"--no-penetration", "--offset", "0.1"});
  EXPECT_EQ(crossings(), 0u);
  EXPECT_EQ(clear["crossings"], 0);
  EXPECT_EQ(clear["no_penetration"], true);
  for (const char* demand : {"vertex", "face", "edge"})
    EXPECT_EQ(clear["constraints"][demand]["violated"], 0) << demand;
  expect_refusal(solve("planarize", input, {"--no-penetration"}), 2, {"--no-penetration"});
}

TEST_F(Steering, TheMarginLiftsThePanels) {
  const std::string input = sample("dome", 60);
  const double edge =
      report("dual", input, {"--constraint", "face", "--margin", "0"})["mean_edge"].get<double>();
  EXPECT_GE(lifts(input).minCoeff(), -1e-9);
  EXPECT_LT(lifts(input).minCoeff(), 0.1 * edge);
  EXPECT_EQ(report("dual", input, {"--constraint", "face", "--margin", "0.2"})["margin"], 0.2);
  EXPECT_GE(lifts(input).minCoeff(), 0.2 * edge - 1e-9);
  for (const char* margin : {"-1", "nan", "x"}) {
    const Ended wrong = solve("dual", input, {"--margin", margin});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_EQ(wrong.err.find("e+308"), std::string::npos) << wrong.err;
  }
  EXPECT_NE(solve("dual", input, {"--margin", "-1"}).err.find("'-1' is negative"), std::string::npos);
  EXPECT_NE(solve("dual", input, {"--tolerance", "0"}).err.find("'0' is not positive"), std::string::npos);
}

TEST_F(Steering, TheSideSaysWhatInFrontMeans) {
  const std::string input = sample("dome", 60);
  EXPECT_EQ(report("dual", input, {"--constraint", "face", "--side", "outside"})["side"], "outside");
  EXPECT_GT(lifts(input).minCoeff(), 0.0);
  EXPECT_EQ(report("dual", input, {"--constraint", "face", "--side", "inside"})["side"], "inside");
  EXPECT_LT(lifts(input).maxCoeff(), 0.0);
  EXPECT_EQ(report("dual", input, {"--offset", "-0.1"})["side"], "inside");  // by the offset
  EXPECT_EQ(solve("dual", input, {"--side", "left"}).status, 2);
}

TEST_F(Steering, RefusesConstraintsThatAreNone) {
  const std::string input = sample("dome", 40);
  const Ended unknown = solve("dual", input, {"--constraint", "pretty"});
  expect_refusal(unknown, 2, {"--constraint", "pretty"});
  for (const DemandInfo& info : demand_catalogue())
    EXPECT_NE(unknown.err.find(info.name), std::string::npos) << unknown.err;
  refuse(input, {"--constraint", "vertex=1"}, 2, {"vertex=1", "more values"});
  refuse(input, {"--constraint", "offset-band=1:2:3"}, 2, {"offset-band=low:high"});
  refuse(input, {"--constraint", "offset-band=1:far"}, 2, {"'far'", "high"});
  refuse(input, {"--constraint", "offset-band=nan"}, 2, {"'nan'", "low"});
  refuse(input, {"--constraint", "face@"}, 2, {"face@"});
  refuse(input, {"--constraint", "face@roof"}, 2, {"--constraint", "roof", "face"});  // no such selection
  refuse(input, {"--constraint", "coplanar-beams"}, 2, {"coplanar-beams"});
}

TEST_F(Steering, RefusesBandsOfNothing) {
  const std::string input = sample("dome", 40);
  const Ended empty = solve("dual", input, {"--constraint", "offset-band=0.3:0.1"});
  EXPECT_TRUE(empty.status == 2 || empty.status == 4) << empty.status;
  expect_refusal(empty, empty.status, {"offset-band"});
  EXPECT_FALSE(exists("p.obj"));
}

TEST_F(Steering, APinnedCornerStaysThere) {
  const std::string input = sample("twisted-roof", 40);
  const Points before = load_mesh(input).value().mesh.positions();
  folder_.write("pins.txt", "vertex 7 " + std::to_string(before(7, 0)) + " - " +
                                std::to_string(before(7, 2) + 0.25) + "  # lifted\nvertex 9 * * *\n");
  const Json pinned = report("planarize", input, {"--pin", path("pins.txt")});
  EXPECT_EQ(pinned["pins"], 2);
  EXPECT_EQ(pinned["constraints"]["pin"]["rows"], 5);
  const Points after = written().positions();
  EXPECT_NEAR(after(7, 0), before(7, 0), 1e-6);  // as many digits as the file has
  EXPECT_NEAR(after(7, 2), before(7, 2) + 0.25, 1e-6);
  EXPECT_LT((after.row(9) - before.row(9)).norm(), 1e-7);
  EXPECT_GT((after.row(8) - before.row(8)).norm(), 1e-3);  // the others move
}

TEST_F(Steering, APinnedPlaneStaysThere) {
  const std::string input = sample("twisted-roof", 40);
  const PolygonMesh mesh = load_mesh(input).value().mesh;
  const Polygons faces = mesh.faces();
  const auto normal = [&](const Points& points) {
    return Vector3d(newell_vector(points, faces[5]).normalized());
  };
  folder_.write("pins.txt", "plane face 5\nplane face 11 0.1 0 2 3.5\n");
  EXPECT_EQ(report("planarize", input, {"--pin", path("pins.txt")})["plane_pins"], 2);
  const Points after = written().positions();
  EXPECT_LT((normal(after) - normal(mesh.positions())).norm(), 1e-8);
  const Vector3d given = Vector3d(0.1, 0.0, 2.0).normalized();
  for (const int corner : faces[11]) EXPECT_NEAR(given.dot(after.row(corner)), 3.5, 1e-8);
}

TEST_F(Steering, RefusesPinsOfNothing) {
  const std::string input = sample("dome", 40);
  folder_.write("pins.txt", "face 0 - - 1\nface 100000 0 0 0\n");
  refuse(input, {"--pin", path("pins.txt")}, 3, {"pins.txt:2", "no face 100000"});
  folder_.write("pins.txt", "vertex 0 - - 1\n");
  refuse(input, {"--pin", path("pins.txt")}, 3, {"pins.txt:1", "no point of vertex 0", "A dual has"});
  refuse(input, {"--pin", path("none.txt")}, 3, {"none.txt"});
  folder_.write("s.txt", "top: vertices 3\n\nrim: vertices 2-100000\n");
  refuse(input, {"--select", path("s.txt")}, 3, {"s.txt:3", "no vertex 100000"});
}

TEST_F(Steering, ContradictionsNameBoth) {
  const std::string input = sample("dome", 40);
  folder_.write("pins.txt", "face 0 - - 1\n\nface 0 0 0 1.5\n");
  refuse(input, {"--pin", path("pins.txt")}, 4, {"pins.txt:1", "pins.txt:3", "face 0"});
}

// The same twice is no mistake; two bands both hold, and where they exclude each other neither wins silently.
TEST_F(Steering, ConstraintsOfOneNameAllHold) {
  const std::string input = sample("dome", 40);
  const Ended apart =
      solve("dual", input, {"--constraint", "offset-band=0.1:0.2", "--constraint", "offset-band=0.3:0.4"});
  expect_refusal(apart, 4, {"offset-band", "contradict"});
  EXPECT_FALSE(exists("p.obj"));
  const Json both =
      report("dual", input, {"--constraint", "offset-band=0.25:0.4", "--constraint", "offset-band=0.1:0.3"});
  EXPECT_EQ(both["demands"].size(), 2u);
  EXPECT_GE(lifts(input).minCoeff(), 0.25);
  EXPECT_LE(lifts(input).maxCoeff(), 0.3);
  EXPECT_EQ(report("dual", input, {"--constraint", "face", "--constraint", "face"})["demands"].size(), 1u);
  // Over a preset's.
  const Json over = report("planarize", sample("twisted-roof", 40),
                           {"--preset", "uncrossed", "--constraint", "uncrossed=0.002:0.05"});
  EXPECT_EQ(over["demands"], Json::parse(R"([{"name": "uncrossed", "values": [0.002, 0.05]}])"));
}

// A selection of faces holds no panels of a dual.
TEST_F(Steering, AConstraintThatHoldsNothingIsTold) {
  folder_.write("s.txt", "roof: faces 0-3\n");
  const std::string input = sample("dome", 40);
  const Ended ended = run({"dual", input, "-o", path("p.obj"), "--report", path("r.json"), "--select",
                           path("s.txt"), "--constraint", "offset-band=0:1@roof", "--constraint", "star"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("asks nothing"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("'offset-band'"), std::string::npos) << ended.err;
  EXPECT_NE(ended.out.find("constraint offset-band: asks nothing"), std::string::npos) << ended.out;
  EXPECT_EQ(ended.out.find("met (0 rows"), std::string::npos) << ended.out;
  EXPECT_EQ(json("r.json")["demands_without_rows"], Json({"offset-band"}));
}

TEST_F(Steering, APinOutsideItsBandIsRefused) {
  const std::string input = sample("dome", 40);
  folder_.write("pins.txt", "face 0 100 100 100\n");
  refuse(input, {"--pin", path("pins.txt"), "--constraint", "height-band=-0.1:0.1"}, 4,
         {"pin", "height-band"});
}

// Closeness takes the panels to the reference, wherever the mesh is.
TEST_F(Steering, TheReferenceIsAnotherFile) {
  const std::string input = sample("dome", 60);
  const PolygonMesh mesh = load_mesh(input).value().mesh;
  Points raised = mesh.positions();
  raised.col(2).array() += 0.3;
  ASSERT_TRUE(save_mesh(path("raised.ply"), raised, mesh.faces()));
  const auto surface = ReferenceSurface::create(raised, mesh.faces(), "raised").value();
  const auto distance = [&] {
    const Points points = written().positions();
    double sum = 0.0;
    for (Eigen::Index j = 0; j < points.rows(); ++j)
      sum += std::abs(surface->closest(points.row(j), Vector3d::Zero()).distance);
    return sum / static_cast<double>(points.rows());
  };
  const Options weights{"--weights", "position=0.01,closeness=1"};
  EXPECT_TRUE(report("dual", input, weights)["reference"].is_null());
  const double before = distance();
  Options with = weights;
  with.insert(with.end(), {"--reference", path("raised.ply")});
  EXPECT_EQ(report("dual", input, with)["reference"], path("raised.ply"));
  EXPECT_LT(distance(), 0.5 * before);
  const std::string idle = "--reference changes nothing";
  EXPECT_EQ(solve("dual", input, with).err.find(idle), std::string::npos);
  EXPECT_NE(solve("dual", input, {"--reference", path("raised.ply")}).err.find(idle), std::string::npos);
}

TEST_F(Steering, RefusesReferencesThatCannotBeMeant) {
  const std::string input = sample("dome", 40);
  const PolygonMesh mesh = load_mesh(input).value().mesh;
  Points far = mesh.positions();
  far.col(0).array() += 1e5;
  ASSERT_TRUE(save_mesh(path("far.obj"), far, mesh.faces()));
  refuse(input, {"--preset", "close", "--reference", path("far.obj")}, 3, {"far.obj"});
  folder_.write("empty.obj", "v 0 0 0\nv 1 0 0\n");
  refuse(input, {"--preset", "close", "--reference", path("empty.obj")}, 3, {"empty.obj"});
  folder_.write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  refuse(input, {"--preset", "close", "--reference", path("line.obj")}, 3, {"line.obj"});
  refuse(input, {"--preset", "close", "--reference", path("none.obj")}, 3, {"none.obj"});
}

// Four corners that are not in one plane: no planar panel has them all.
TEST_F(Steering, DemandsThatCannotBeMetTogetherAreNamedAndCanBeWaived) {
  const std::string input = sample("twisted-roof", 40);
  const PolygonMesh mesh = load_mesh(input).value().mesh;
  const Polygons faces = mesh.faces();
  std::string pins;
  for (const int corner : faces[12]) pins += "vertex " + std::to_string(corner) + " * * *\n";
  folder_.write("pins.txt", pins);
  const Ended ended = solve("planarize", input, {"--pin", path("pins.txt")});
  EXPECT_EQ(ended.status, 4) << ended.err;
  EXPECT_NE(ended.err.find("cannot be met together"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("pin at point "), std::string::npos) << ended.err;
  EXPECT_TRUE(exists("p.obj"));  // the best state is kept
  const Json report = json("r.json");
  EXPECT_EQ(report["status"], "infeasible");
  ASSERT_FALSE(report["conflicts"].empty());
  EXPECT_LT(report["conflicts"].size(), 12u);  // not simply all of them
  EXPECT_EQ(report["conflicts"][0]["demand"], "pin");

  std::filesystem::rename(path("r.json"), path("first.json"));
  const Json waived =
      this->report("planarize", input, {"--pin", path("pins.txt"), "--waive", path("first.json")});
  EXPECT_EQ(waived["waived"], report["conflicts"]);
  EXPECT_TRUE(waived["conflicts"].empty());
}

TEST_F(Steering, AWaiverGivesUpWhereItSays) {
  const std::string input = sample("dome", 60);
  const int top = top_vertex(input);
  const Json plain = report("dual", input, {});
  const auto waiving = [&](int panel, int more_points = 0) {
    folder_.write("w.json",
                  R"({"tool": "planewright", "waived": [], "panels": )" + plain["panels"].dump() +
                      R"(, "points": )" + std::to_string(plain["points"].get<int>() + more_points) +
                      R"(, "conflicts": [{"demand": "offset-band", "element": {"kind": "panel", "index": )" +
                      std::to_string(panel) + "}}]}");
  };
  folder_.write("s.txt", "top: vertices " + std::to_string(top) + "\n");
  Options with{"--select", path("s.txt"), "--constraint", "offset-band=0.4:0.6@top",
               "--waive",  path("w.json")};
  waiving(top + 1);  // where nothing is demanded
  report("dual", input, with);
  EXPECT_GE(lifts(input)[top], 0.4);
  waiving(top);  // panels of a closed dual are numbered like the vertices
  const Json given_up = report("dual", input, with);
  EXPECT_EQ(given_up["waived"].size(), 1u);
  EXPECT_EQ(given_up["constraints"]["offset-band"]["waived"], 1);
  EXPECT_LT(lifts(input)[top], 0.3);

  std::filesystem::remove(path("p.obj"));
  waiving(100000);
  refuse(input, with, 3, {"w.json", "another design", "panel 100000"});
  waiving(top, 1);
  refuse(input, with, 3, {"w.json", "another design", "points"});
  folder_.write("w.json", "{}");
  refuse(input, with, 3, {"w.json", "no report"});
  refuse(input, {"--waive", path("none.json")}, 3, {"none.json"});
}

// Where everything is given up panels cross the mesh as they like, and that is told but no failure.
TEST_F(Steering, CrossingsAtPlacesGivenUpAreNoFailure) {
  const std::string input = sample("saddle-roof", 60);
  const Json plain = report("dual", input, {});
  Json waived = Json::array();
  const auto waive = [&](const char* demand, const char* kind, int index) {
    waived.push_back({{"demand", demand}, {"element", {{"kind", kind}, {"index", index}}}});
  };
  for (int i = 0; i < plain["panels"]; ++i)
    for (const char* demand : {"face", "no-penetration"}) waive(demand, "panel", i);
  for (int j = 0; j < plain["points"]; ++j) waive("vertex", "point", j);
  const Json earlier = {{"tool", "planewright"},
                        {"panels", plain["panels"]},
                        {"points", plain["points"]},
                        {"waived", waived},
                        {"conflicts", Json::array()}};
  folder_.write("w.json", earlier.dump());
  const Ended ended = run({"dual", input, "-o", path("p.obj"), "--report", path("r.json"), "--no-penetration",
                           "--waive", path("w.json")});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const Json crossed = json("r.json");
  EXPECT_GT(crossed["crossings"].get<int>(), 0);
  EXPECT_EQ(crossed["crossings"], crossed["crossings_waived"]);
  const std::string pairs = crossed["crossings"].dump(), rows = crossed["constraints"]["face"]["rows"].dump();
  EXPECT_EQ(crossed["constraints"]["face"]["waived"], crossed["constraints"]["face"]["rows"]);
  for (const std::string& words :
       {"panels that cross the mesh: " + pairs + " pairs, " + pairs + " at places given up",
        "constraint face: met (" + rows + " rows, " + rows + " given up)"})
    EXPECT_NE(ended.out.find(words), std::string::npos) << words << " is not in: " << ended.out;
}

TEST_F(Steering, ExplicitGoesWithNothingThatSteers) {
  const std::string input = sample("dome", 40);
  for (const Options& options : {Options{"--preset", "close"},
                                 {"--weights", "position=1"},
                                 {"--constraint", "face"},
                                 {"--no-penetration"},
                                 {"--margin", "1"},
                                 {"--side", "inside"},
                                 {"--pin", "p"},
                                 {"--select", "s"},
                                 {"--reference", "r"},
                                 {"--waive", "w"},
                                 {"--layers", "a=1"}}) {
    Options with{"--explicit"};
    with.insert(with.end(), options.begin(), options.end());
    EXPECT_EQ(solve("dual", input, with).status, 2) << options[0];
  }
  EXPECT_FALSE(exists("p.obj"));
}

TEST_F(Steering, InputsAreNeverOverwritten) {
  const std::string input = sample("dome", 40);
  folder_.write("pins.obj", "face 0 * * *\n");
  const Ended ended = run({"dual", input, "-o", path("pins.obj"), "--pin", path("pins.obj")});
  expect_refusal(ended, 2, {"--pin", "same file"});
  EXPECT_EQ(test::text_of(path("pins.obj")), "face 0 * * *\n");
}

TEST_F(Steering, TheManualNamesEverything) {
  const std::string manual =
      test::text_of(std::filesystem::path(PLANEWRIGHT_SOURCE_DIR) / "docs" / "command-line.md");
  const auto expect_named = [&](const std::string& name) {
    EXPECT_NE(manual.find("`" + name), std::string::npos) << name;
  };
  for (const EnergyInfo& info : energy_catalogue()) expect_named(info.name + "`");
  for (const DemandInfo& info : demand_catalogue()) expect_named(info.name + "`");
  for (const Preset& preset : presets())
    if (preset.name.size() != 3) expect_named(preset.name + "`");  // lll ... hhh
  const std::string help = run({"panels", "--help"}).out;
  int options = 0;
  for (size_t at = help.find("  --"); at != std::string::npos; at = help.find("  --", at + 1)) {
    const std::string option = help.substr(at + 2, help.find_first_of(" ,\n:", at + 2) - at - 2);
    expect_named(option);
    ++options;
  }
  EXPECT_GT(options, 15);
  for (const DemandInfo& info : demand_catalogue())
    EXPECT_NE(help.find(info.name), std::string::npos) << info.name;
  for (const Preset& preset : presets()) EXPECT_NE(help.find(preset.name), std::string::npos) << preset.name;
}

TEST_F(Steering, TheSummaryTellsEachConstraint) {
  const Ended dual =
      run({"dual", sample("dome", 40), "-o", path("p.obj"), "--offset", "0.2", "--no-penetration"});
  EXPECT_EQ(dual.status, 0) << dual.err;
  for (const char* words : {"constraint vertex: met (", "constraint face: met (", "constraint edge: met (",
                            "panels that cross the mesh: 0 pairs"})
    EXPECT_NE(dual.out.find(words), std::string::npos) << dual.out;
  EXPECT_EQ(dual.out.find("constraint incidence"), std::string::npos) << dual.out;
}

}  // namespace
}  // namespace planewright
