// dual, planarize and panels, end to end through the real binary.
#include <gtest/gtest.h>

#include "cli/command_line.h"
#include "core/diagnose/planarity.h"
#include "core/mesh/mesh_io.h"
#include "core/problem/energies/energy_catalogue.h"
#include "support/shared_meshes.h"

namespace planewright {
namespace {

using test::Ended;
using Json = nlohmann::json;

class SolveCommands : public test::CommandLineTest {
 protected:
  // Planarity of what a file says, relative to its box.
  static double planarity_of(const std::string& file) {
    const auto mesh = load_mesh(file);
    EXPECT_TRUE(mesh) << mesh.error().text();
    return mesh ? measure_planarity(mesh->mesh.positions(), mesh->mesh.faces()).max_relative_to_bbox : 1.0;
  }
};

TEST_F(SolveCommands, SampleToDualToCheckToReport) {
  const std::string input = sample("train-station", 120);
  const auto primal = load_mesh(input).value();
  const Ended dual = run({"dual", input, "-o", path("station.obj"), "--report", path("r.json")});
  ASSERT_EQ(dual.status, 0) << dual.err;
  EXPECT_NE(dual.out.find("station.obj: " + std::to_string(primal.mesh.vertex_count()) + " panels"),
            std::string::npos)
      << dual.out;
  EXPECT_NE(dual.out.find("status: converged"), std::string::npos);
  EXPECT_NE(dual.out.find("planarity: max"), std::string::npos);
  EXPECT_NE(dual.err.find("iteration 0"), std::string::npos) << dual.err;  // progress
  EXPECT_LE(planarity_of(path("station.obj")), 1e-9);

  const Json report = json("r.json");
  for (const char* key : {"tool",           "version",     "input",
                          "mode",           "solver",      "status",
                          "stop_reason",    "iterations",  "first_order_residual",
                          "peak_memory_mb", "seconds",     "panels",
                          "points",         "planarity",   "displacement",
                          "energies",       "constraints", "diagnosis",
                          "health",         "weights",     "offset"})
    EXPECT_TRUE(report.contains(key)) << key;
  EXPECT_EQ(report["tool"], "planewright");
  EXPECT_EQ(report["input"], input);
  EXPECT_EQ(report["mode"], "dual");
  EXPECT_NE(report["solver"], "");
  EXPECT_EQ(report["status"], "converged");
  EXPECT_GT(report["iterations"].get<int>(), 0);
  EXPECT_EQ(report["panels"], primal.mesh.vertex_count());
  EXPECT_LE(report["planarity"]["max_relative_to_bbox"].get<double>(), 1e-9);
  EXPECT_NEAR(report["planarity"]["max_relative_to_bbox"].get<double>(), planarity_of(path("station.obj")),
              1e-12);
  EXPECT_GT(report["displacement"]["rms"].get<double>(), 0.0);
  EXPECT_GT(report["energies"]["position"].get<double>(), 0.0);
  EXPECT_EQ(report["constraints"]["incidence"]["violated"], 0);
  for (const char* key : {"build", "solve", "total"}) EXPECT_GE(report["seconds"][key].get<double>(), 0.0);
  EXPECT_GE(report["seconds"]["total"].get<double>(), report["seconds"]["solve"].get<double>());

  const Ended check = run({"check", path("station.obj")});
  EXPECT_EQ(check.status, 0) << check.out << check.err;
  EXPECT_NE(check.out.find("\nplanar\n"), std::string::npos) << check.out;
  EXPECT_EQ(files(), 3);
}

TEST_F(SolveCommands, PlanarizeKeepsTheFaces) {
  const std::string input = sample("twisted-roof", 100);
  EXPECT_GT(planarity_of(input), 1e-4);
  const Ended planarize = run({"planarize", input, "-o", path("roof.off"), "--report", path("r.json")});
  ASSERT_EQ(planarize.status, 0) << planarize.err;
  const auto before = load_mesh(input).value(), after = load_mesh(path("roof.off")).value();
  EXPECT_EQ(after.mesh.faces(), before.mesh.faces());
  EXPECT_LE(planarity_of(path("roof.off")), 1e-9);
  EXPECT_EQ(json("r.json")["mode"], "planarize");
}

TEST_F(SolveCommands, EveryFormatHoldsThePlanarity) {
  const std::string input = sample("dome", 60);
  for (const char* name : {"p.obj", "p.off", "p.ply", "P.OBJ"}) {
    ASSERT_EQ(run({"dual", input, "-o", path(name), "--quiet"}).status, 0) << name;
    EXPECT_LE(planarity_of(path(name)), 1e-9) << name;
  }
  ASSERT_EQ(run({"dual", input, "-o", path("p.stl"), "--quiet"}).status, 0);
  EXPECT_GT(load_mesh(path("p.stl")).value().mesh.face_count(), 60);
}

TEST_F(SolveCommands, PanelsChoosesTheModeByTheMesh) {
  ASSERT_EQ(run({"panels", sample("dome", 60), "-o", path("a.obj"), "--report", path("a.json")}).status, 0);
  EXPECT_EQ(json("a.json")["mode"], "dual");
  ASSERT_EQ(
      run({"panels", sample("twisted-roof", 60), "-o", path("b.obj"), "--report", path("b.json")}).status, 0);
  EXPECT_EQ(json("b.json")["mode"], "planarize");
}

TEST_F(SolveCommands, QuietSaysNothingWhenAllIsWell) {
  const Ended quiet = run({"dual", sample("dome", 60), "-o", path("p.obj"), "--quiet"});
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.out, "");
  EXPECT_EQ(quiet.err, "");
}

TEST_F(SolveCommands, OptionsReachTheSolve) {
  const std::string input = sample("vault", 80);
  const auto report = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments{"dual",    input,      "-o",          path("p.obj"),
                                       "--quiet", "--report", path("r.json")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended dual = run(arguments);
    EXPECT_EQ(dual.status, 0) << dual.err;
    return json("r.json");
  };
  const Json plain = report({});
  EXPECT_EQ(plain["freedom"], "normals-and-offsets");
  EXPECT_EQ(plain["weights"]["position"], 1.0);

  const Json fair = report({"--weights", "fairing=2,position=0.5"});
  EXPECT_EQ(fair["weights"], (Json{{"fairing", 2.0}, {"position", 0.5}}));
  EXPECT_TRUE(fair["energies"].contains("fairing"));
  EXPECT_GT(fair["displacement"]["rms"].get<double>(), plain["displacement"]["rms"].get<double>());

  const Json lifted = report({"--offset", "0.5"});
  EXPECT_EQ(lifted["offset"], 0.5);
  const Json lowered = report({"--offset", "-0.5"});
  EXPECT_EQ(lowered["offset"], -0.5);

  const Json interior = report({"--border", "interior"});
  EXPECT_LT(interior["panels"].get<int>(), plain["panels"].get<int>());

  const Json normals = report({"--freedom", "normals"});
  EXPECT_EQ(normals["freedom"], "normals");
  EXPECT_GE(normals["energies"]["position"].get<double>(),
            0.999 * plain["energies"]["position"].get<double>());
}

// Whichever solver is asked for: planar panels near the design, and a report that says who made them.
TEST_F(SolveCommands, EverySolverMakesASmallRoofPlanar) {
  const std::string input = sample("vault", 80);
  double energy = 0.0;
  for (const char* solver : {"ipopt", "tangent", "auto"}) {
    SCOPED_TRACE(solver);
    const Ended dual =
        run({"dual", input, "-o", path("p.obj"), "--report", path("r.json"), "--quiet", "--solver", solver});
    ASSERT_EQ(dual.status, 0) << dual.err;
    EXPECT_LE(planarity_of(path("p.obj")), 1e-9);
    const Json report = json("r.json");
    EXPECT_EQ(report["status"], "converged");
    ASSERT_TRUE(report["solver"].is_string());
    EXPECT_NE(report["solver"], "");
    const double now = report["energies"]["position"];
    if (std::string(solver) == "ipopt") {
      EXPECT_EQ(report["solver"], "ipopt");
      energy = now;
    }
    EXPECT_LE(now, 1.05 * energy);
  }
}

TEST_F(SolveCommands, AnUnknownSolverIsAnsweredWithTheKnownOnes) {
  const std::string input = sample("dome", 50);
  for (const char* command : {"dual", "panels"})
    expect_refusal(run({command, input, "-o", path("p.obj"), "--solver", "guess"}), 2,
                   {"--solver", "guess", "ipopt", "tangent", "auto"});
  EXPECT_FALSE(exists("p.obj"));
}

TEST_F(SolveCommands, AWrongNameIsAnsweredInWordsAndANumberIsNone) {
  const std::string input = sample("dome", 50);
  for (const auto& [option, known] :
       {std::pair("--solver", "none of: ipopt, tangent, auto"),
        std::pair("--freedom", "none of: fixed, normals, all"),
        std::pair("--side", "none of: outside, inside"), std::pair("--border", "none of: closed, interior")})
    for (const char* given : {"guess", "0"})
      expect_refusal(run({"dual", input, "-o", path("p.obj"), option, given}), 2, {option, given, known});
  EXPECT_FALSE(exists("p.obj"));
}

// There is nothing to solve for.
TEST_F(SolveCommands, ExplicitGoesWithNoSolver) {
  const Ended refused =
      run({"dual", sample("dome", 50), "-o", path("p.obj"), "--explicit", "--solver", "ipopt"});
  expect_refusal(refused, 2, {"--explicit", "--solver"});
  EXPECT_FALSE(exists("p.obj"));
}

TEST_F(SolveCommands, OffsetLiftsThePanels) {
  const std::string input = sample("dome", 100);
  const auto height = [&](const std::string& offset) {
    EXPECT_EQ(run({"dual", input, "-o", path("p.obj"), "--quiet", "--offset", offset}).status, 0);
    return load_mesh(path("p.obj")).value().mesh.positions().col(2).maxCoeff();
  };
  const double at = height("0");
  EXPECT_NEAR(height("0.25") - at, 0.25, 0.02);
  EXPECT_NEAR(height("-0.25") - at, -0.25, 0.02);
}

TEST_F(SolveCommands, ALimitOfIterationsEndsWithStatusOne) {
  const Ended limited = run({"dual", sample("train-station", 120), "-o", path("p.obj"), "--report",
                             path("r.json"), "--max-iterations", "1"});
  EXPECT_EQ(limited.status, 1);
  EXPECT_NE(limited.err.find("limit of 1 iterations"), std::string::npos) << limited.err;
  EXPECT_EQ(json("r.json")["status"], "planar, not converged");
  EXPECT_EQ(json("r.json")["iterations"], 1);
  // Written all the same, and planar.
  EXPECT_LE(planarity_of(path("p.obj")), 1e-9);
}

TEST_F(SolveCommands, ExplicitNamesThePointsItCouldNotCompute) {
  const Ended explicit_run =
      run({"dual", sample("vault", 80), "-o", path("p.obj"), "--explicit", "--report", path("r.json")});
  EXPECT_EQ(explicit_run.status, 1);
  EXPECT_NE(explicit_run.err.find("could not be computed"), std::string::npos) << explicit_run.err;
  EXPECT_NE(explicit_run.err.find("fewer than three planes"), std::string::npos) << explicit_run.err;
  EXPECT_NE(explicit_run.err.find("the first is point "), std::string::npos) << explicit_run.err;
  EXPECT_EQ(json("r.json")["solver"], "explicit");
  EXPECT_TRUE(exists("p.obj"));
}

// A sphere-like design has every point: the baseline then succeeds.
TEST_F(SolveCommands, ExplicitSucceedsWhereEveryPointIsDetermined) {
  folder_.write(
      "octahedron.off",
      "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n"
      "3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
  const Ended explicit_run = run({"dual", path("octahedron.off"), "-o", path("p.obj"), "--explicit"});
  EXPECT_EQ(explicit_run.status, 0) << explicit_run.err;
  const auto box = load_mesh(path("p.obj")).value();
  EXPECT_NEAR((box.mesh.positions().cwiseAbs().array() - 1.0).abs().maxCoeff(), 0.0, 1e-14);
}

TEST_F(SolveCommands, NotesWhatIsWrongWithTheInput) {
  folder_.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nv 9 9 9\nf 1 2 3 4\n");
  const Ended planarize =
      run({"planarize", path("mesh.obj"), "-o", path("p.obj"), "--report", path("r.json")});
  EXPECT_EQ(planarize.status, 0) << planarize.err;
  EXPECT_NE(planarize.err.find("1 isolated vertex"), std::string::npos) << planarize.err;
  EXPECT_EQ(json("r.json")["health"]["defects"][0]["kind"], "isolated vertex");
}

TEST_F(SolveCommands, AreDeterministic) {
  const std::string input = sample("alpine-hut", 100);
  for (const char* name : {"a.obj", "b.obj"})
    ASSERT_EQ(run({"dual", input, "-o", path(name), "--quiet"}).status, 0);
  EXPECT_EQ(test::text_of(path("a.obj")), test::text_of(path("b.obj")));
}

TEST_F(SolveCommands, RefuseAMissingFile) {
  expect_refusal(run({"dual", path("none.obj"), "-o", path("p.obj")}), 3, {"none.obj", "no such file"});
  EXPECT_EQ(files(), 0);
}

TEST_F(SolveCommands, RefuseAFileThatIsNoMesh) {
  folder_.write("text.obj", "this is\nno mesh\n");
  expect_refusal(run({"dual", path("text.obj"), "-o", path("p.obj")}), 3, {"text.obj"});
  folder_.write("bad.obj", "v 0 0 0\nv 1 0 zero\n");
  expect_refusal(run({"dual", path("bad.obj"), "-o", path("p.obj")}), 3, {"bad.obj:2"});
  EXPECT_FALSE(exists("p.obj"));
}

TEST_F(SolveCommands, RefuseAnEndingTheyCannotWrite) {
  // Before anything is read: the input does not even exist.
  for (const char* name : {"p.dwg", "p", "p.obj.gz"})
    expect_refusal(run({"dual", path("none.obj"), "-o", path(name)}), 2, {".obj", ".ply"});
}

TEST_F(SolveCommands, RefuseUnknownOptionsAndValues) {
  const std::string input = sample("dome", 50);
  const std::vector<std::vector<std::string>> wrong{
      {"--no-such-option"},       {"--freedom", "some"},        {"--border", "ajar"},  {"--solver", "guess"},
      {"--unit", "furlong"},      {"--tolerance", "0"},         {"--tolerance", "-1"}, {"--tolerance", "x"},
      {"--max-iterations", "-1"}, {"--max-iterations", "many"}, {"--offset", "far"},   {"stray"}};
  for (const auto& options : wrong) {
    std::vector<std::string> arguments{"dual", input, "-o", path("p.obj")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended refused = run(arguments);
    EXPECT_EQ(refused.status, 2) << options[0] << ": " << refused.err;
    EXPECT_FALSE(refused.err.empty());
  }
  EXPECT_EQ(run({"planarize", input, "-o", path("p.obj"), "--border", "closed"}).status, 2);
  EXPECT_EQ(run({"dual", input}).status, 2);
  EXPECT_EQ(run({}).status, 2);
  EXPECT_EQ(run({"frobnicate"}).status, 2);
  EXPECT_EQ(files(), 1);
}

TEST_F(SolveCommands, RefuseWeightsThatAreNone) {
  const std::string input = sample("dome", 50);
  const auto with = [&](const std::string& weights) {
    return run({"dual", input, "-o", path("p.obj"), "--weights", weights});
  };
  const Ended unknown = with("beauty=1");
  expect_refusal(unknown, 2, {"beauty"});
  for (const EnergyInfo& info : energy_catalogue())
    EXPECT_NE(unknown.err.find(info.name), std::string::npos) << unknown.err;
  expect_refusal(with("position"), 2, {"name=value"});
  expect_refusal(with("position=-1"), 2, {"position", "-1"});
  expect_refusal(with("position=nan"), 2, {"nan"});
  expect_refusal(with("position=1e999"), 2, {"1e999"});
  expect_refusal(with("position=1x"), 2, {"1x"});
  expect_refusal(with("position=1,position=2"), 2, {"twice"});
  expect_refusal(with("position=1,,fairing=1"), 2, {"name=value"});
  EXPECT_FALSE(exists("p.obj"));
}

TEST_F(SolveCommands, RefuseAnOffsetThatIsNotFinite) {
  const std::string input = sample("dome", 50);
  for (const char* offset : {"nan", "inf"}) {
    EXPECT_EQ(run({"dual", input, "-o", path("p.obj"), "--offset", offset}).status, 2) << offset;
    EXPECT_FALSE(exists("p.obj"));
  }
}

TEST_F(SolveCommands, RefuseToWriteIntoAFolderThatIsNotThere) {
  const Ended refused = run({"dual", sample("dome", 50), "-o", path("not/there.obj"), "--quiet"});
  expect_refusal(refused, 5, {"not/there.obj", "No such file or directory"});
  EXPECT_EQ(files(), 1);
}

// A disk that is full: the old file stays, nothing else is left.
TEST_F(SolveCommands, KeepTheOldFileWhenTheDiskIsFull) {
  const std::string input = sample("dome", 200);
  folder_.write("p.obj", "old");
  const Ended refused = run({"dual", input, "-o", path("p.obj"), "--quiet"}, "trap '' XFSZ; ulimit -f 2; ");
  expect_refusal(refused, 5, {"p.obj", "File too large"});
  EXPECT_EQ(test::text_of(path("p.obj")), "old");
  EXPECT_EQ(files(), 2);
}

TEST_F(SolveCommands, RefuseAReportThatCannotBeWritten) {
  const Ended refused =
      run({"dual", sample("dome", 50), "-o", path("p.obj"), "--report", path("not/there.json"), "--quiet"});
  expect_refusal(refused, 5, {"not/there.json"});
}

TEST_F(SolveCommands, RefuseFixedPlanesWithoutCommonPoints) {
  const Ended refused =
      run({"planarize", sample("twisted-roof", 60), "-o", path("p.obj"), "--freedom", "fixed"});
  expect_refusal(refused, 3, {"point ", "fixed planes", "Free the normals"});
  EXPECT_FALSE(exists("p.obj"));
}

TEST_F(SolveCommands, RefuseAnInteriorDualWithoutInnerVertices) {
  folder_.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_refusal(run({"dual", path("one.obj"), "-o", path("p.obj"), "--border", "interior"}), 3,
                 {"border", "closed"});
}

TEST_F(SolveCommands, HelpAndVersion) {
  const Ended help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* command : {"sample", "dual", "planarize", "panels", "check", "render"})
    EXPECT_NE(help.out.find(command), std::string::npos);
  const Ended of_dual = run({"dual", "--help"});
  EXPECT_EQ(of_dual.status, 0);
  for (const char* option :
       {"--weights", "--offset", "--border", "--freedom", "--report", "--max-iterations"})
    EXPECT_NE(of_dual.out.find(option), std::string::npos) << option;
  const Ended version = run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_FALSE(version.out.empty());
}

TEST_F(SolveCommands, ARealRoofsDual) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(meshes);
  const Ended dual = run({"dual", (meshes / "tri/train-station.off").string(), "-o", path("station.obj"),
                          "--report", path("r.json"), "--quiet"});
  EXPECT_EQ(dual.status, 0) << dual.err;
  EXPECT_LE(planarity_of(path("station.obj")), 1e-9);
  EXPECT_EQ(json("r.json")["panels"], 1753);
  EXPECT_EQ(json("r.json")["status"], "converged");
}

TEST_F(SolveCommands, ARealSculptureMadePlanar) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(meshes);
  const Ended planarize = run({"planarize", (meshes / "quad/fertility_quad.off").string(), "-o",
                               path("fertility.obj"), "--report", path("r.json"), "--quiet"});
  EXPECT_EQ(planarize.status, 0) << planarize.err;
  EXPECT_LE(planarity_of(path("fertility.obj")), 1e-9);
  const Json report = json("r.json");
  EXPECT_EQ(report["panels"], 3357);
  EXPECT_LE(report["displacement"]["rms_edges"].get<double>(), 0.155);
  EXPECT_LE(report["displacement"]["max_edges"].get<double>(), 0.70);
}

}  // namespace
}  // namespace planewright
