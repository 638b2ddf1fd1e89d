#include "core/edit/project_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "support/projects.h"
#include "support/temporary_folder.h"

namespace planewright {
namespace {

using test::busy_project;
using test::expect_same_project;

std::string text_of(const Project& project) {
  const auto text = format_project(project);
  EXPECT_TRUE(text) << (text ? "" : text.error().text());
  return text.value_or(std::string());
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << "'" << what << "' is not in the file";
  return at == text.npos ? text : text.replace(at, what.size(), by);
}

void expect_unreadable(const std::string& text, const std::vector<std::string>& saying) {
  const auto read = read_project(text, "roof.planewright");
  ASSERT_FALSE(read) << saying.front();
  EXPECT_EQ(read.error().code, ErrorCode::Unreadable);
  EXPECT_TRUE(read.error().where.starts_with("roof.planewright")) << read.error().where;
  EXPECT_FALSE(read.error().remedy.empty()) << read.error().text();
  for (const std::string& words : saying)
    EXPECT_NE(read.error().text().find(words), std::string::npos)
        << "'" << words << "' is not in: " << read.error().text();
}

// A project of one triangle, with whatever else the file is to say.
std::string triangle(const std::string& more = {}) {
  return R"({"format": "planewright project", "version": 1,
 "mesh": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "faces": [[0, 1, 2]]})" +
         (more.empty() ? std::string() : ",\n " + more) + "}\n";
}
std::string layer(const std::string& members) {
  return triangle(R"("design": {"layers": [{)" + members + "}]}");
}
std::string demands(const std::string& members) {
  return layer(R"("settings": {"demands": {)" + members + "}}");
}

TEST(ProjectFile, KeepsEveryFieldBitForBit) {
  const Project project = busy_project();
  const std::string text = text_of(project);
  const auto read = read_project(text, "other.planewright");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->warnings, std::vector<std::string>{});
  expect_same_project(read->project, project);
  // == does not tell 0 from -0.
  EXPECT_TRUE(std::signbit(*read->project.design.layers[0].settings.demands.pins[0].at[2]));
  EXPECT_EQ(text_of(read->project), text);
}

TEST(ProjectFile, KeepsANewProjectWithoutNumbersOrNames) {
  const Project project = new_project("dome", make_sample("dome", 40).value(), {});
  const std::string text = text_of(project);
  EXPECT_EQ(text.find("\"numbers\""), text.npos);
  EXPECT_EQ(text.find("\"panel_names\""), text.npos);
  EXPECT_EQ(text.find("\"edges\""), text.npos);
  const auto read = read_project(text, "x");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->project.names, project.names);
  EXPECT_EQ(read->project.name, "dome");
  EXPECT_TRUE(read->project.solved.size() == 1 && !read->project.solved[0]);
}

TEST(ProjectFile, WhatIsAbsentIsAsItBegins) {
  const auto read = read_project(triangle(), "a folder/roof.planewright");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->project.name, "roof");
  EXPECT_EQ(read->project.design, Design{});
  EXPECT_EQ(read->project.contract, WorkshopContract{});
  EXPECT_EQ(read->warnings, std::vector<std::string>{});
}

// The indented block of docs/project-file.md.
TEST(ProjectFile, TheExampleOfTheDocumentationReads) {
  std::ifstream docs(std::string(PLANEWRIGHT_SOURCE_DIR) + "/docs/project-file.md");
  std::string example, line;
  while (std::getline(docs, line))
    if (line.starts_with("    ")) example += line + "\n";
  const auto read = read_project(example, "example");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->warnings, std::vector<std::string>{});
  EXPECT_EQ(read->project.contract.density, 2500.0);
  EXPECT_EQ(read->project.design.layers[0].settings.demands.pins.size(), 1u);
}

TEST(ProjectFile, KeepsHowFlipsHaveNumberedTheEdges) {
  PolygonMesh mesh = make_torus(8, 8);
  for (int e = 0; e < mesh.edge_count(); e += 7) mesh.flip(e);
  const Project project = new_project("torus", mesh, {});
  EXPECT_NE(text_of(project).find("\"edges\""), std::string::npos);
  const auto read = read_project(text_of(project), "x");
  ASSERT_TRUE(read) << read.error().text();
  test::expect_same_mesh(read->project.mesh, mesh);
}

TEST(ProjectFile, NumbersComeBackToTheBit) {
  Project project = new_project("x", make_sample("dome", 40).value(), {});
  for (const double value : {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, 123456789.123456789, -0.0}) {
    project.design.layers[0].thickness = value;
    const auto read = read_project(text_of(project), "x");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read->project.design.layers[0].thickness),
              std::bit_cast<std::uint64_t>(value));
  }
}

TEST(ProjectFile, UnknownKeysAreWarnedOf) {
  const auto read = read_project(triangle(R"("colour": 1, "design": {"layers": [{"gloss": {}}]})"), "r.pw");
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->warnings.size(), 2u);
  EXPECT_NE(read->warnings[0].find("r.pw, design.layers[0].gloss"), std::string::npos) << read->warnings[0];
  EXPECT_NE(read->warnings[1].find("r.pw, colour"), std::string::npos) << read->warnings[1];
}

TEST(ProjectFile, RefusesOtherFormatsAndVersions) {
  expect_unreadable("", {"the file is empty"});
  expect_unreadable(" \n\n", {"the file is empty"});
  expect_unreadable("[]", {"there is a list instead of an object"});
  expect_unreadable("{}", {"format", "no project of Planewright"});
  expect_unreadable(R"({"format": "planewright tolerances", "version": 1})", {"no project of Planewright"});
  expect_unreadable(R"({"format": "planewright project"})", {"version", "missing"});
  expect_unreadable(replaced(triangle(R"("new": 1)"), "\"version\": 1", "\"version\": 2"),
                    {"of version 2", "reads up to 1", "newer Planewright"});
  expect_unreadable(replaced(triangle(), "\"version\": 1", "\"version\": 0"), {"version", "out of range"});
  expect_unreadable(replaced(triangle(), "\"version\": 1", "\"version\": \"1\""),
                    {"a text instead of a whole number"});
}

TEST(ProjectFile, SaysInWhichLineItIsNoJson) {
  const std::string text = text_of(busy_project());
  expect_unreadable(text.substr(0, text.size() / 2), {"roof.planewright:", "no JSON", "ends early"});
  expect_unreadable(replaced(triangle(), "[0, 1, 2]", "[0, 1 2]"), {"roof.planewright:2", "no JSON"});
  expect_unreadable(replaced(triangle(), "[1, 0, 0]", "[1, NaN, 0]"), {"roof.planewright:2", "NaN"});
  expect_unreadable(replaced(triangle(), "[1, 0, 0]", "[1, nan, 0]"), {"roof.planewright:2", "NaN"});
  expect_unreadable(replaced(triangle(), "[1, 0, 0]", "[1, -inf, 0]"), {"roof.planewright:2", "infinite"});
  expect_unreadable(replaced(triangle(), "[1, 0, 0]", "[1, 1e999, 0]"),
                    {"roof.planewright:2", "too large", "1e999"});
  expect_unreadable(triangle() + "rest", {"roof.planewright:3", "no JSON"});
  expect_unreadable(std::string("\x7f\x00\xff\xfe", 4), {"roof.planewright:1", "no JSON"});
  // Brackets without end use no stack.
  expect_unreadable(std::string(1000000, '['), {"no JSON"});
  expect_unreadable(triangle("\"x\": " + std::string(100000, '[') + std::string(100000, '[')), {"no JSON"});
}

TEST(ProjectFile, SaysWhatIsWrongWithTheMesh) {
  const auto with = [](const std::string& mesh) {
    return R"({"format": "planewright project", "version": 1, "mesh": )" + mesh + "}";
  };
  expect_unreadable(R"({"format": "planewright project", "version": 1})", {"mesh", "missing"});
  expect_unreadable(with("3"), {"mesh", "a number instead of an object"});
  expect_unreadable(with(R"({"faces": []})"), {"mesh.vertices", "missing"});
  expect_unreadable(with(R"({"vertices": [[0,0,0]], "faces": []})"), {"mesh.faces", "no faces"});
  expect_unreadable(replaced(triangle(), "[1, 0, 0]", "[1, 0]"), {"mesh.vertices[1]", "2 numbers"});
  expect_unreadable(replaced(triangle(), "[1, 0, 0]", "[1, null, 0]"), {"mesh.vertices[1][1]", "NaN"});
  expect_unreadable(replaced(triangle(), "[1, 0, 0]", "[1, \"0\", 0]"),
                    {"mesh.vertices[1][1]", "a text instead of a number"});
  expect_unreadable(replaced(triangle(), "[0, 1, 2]", "[0, 1, 3]"),
                    {"mesh.faces[0][2]", "3 is out of range", "from 0 to 2"});
  expect_unreadable(replaced(triangle(), "[0, 1, 2]", "[0, 1, -1]"), {"mesh.faces[0][2]", "out of range"});
  expect_unreadable(replaced(triangle(), "[0, 1, 2]", "[0, 1, 18446744073709551615]"),
                    {"mesh.faces[0][2]", "out of range"});
  expect_unreadable(replaced(triangle(), "[0, 1, 2]", "[0, 1, 2.0]"), {"mesh.faces[0][2]", "whole number"});
  expect_unreadable(replaced(triangle(), "[0, 1, 2]", "[0, 1]"), {"mesh, face 0", "fewer than 3"});
  expect_unreadable(replaced(triangle(), "[0, 1, 2]", "[0, 1, 1]"), {"mesh, face 0", "twice"});
  const auto edges = [](const std::string& list) {
    return replaced(triangle(), "\"faces\"", "\"edges\": " + list + ", \"faces\"");
  };
  expect_unreadable(edges("[[0, 1]]"), {"mesh, edges", "3 edges, but 1"});
  expect_unreadable(edges("[[0, 1], [1, 2], [0, 2]]"), {"mesh, edge 2", "from vertex 0 to vertex 2"});
  expect_unreadable(edges("[[0, 1], [1, 2], [1, 2]]"), {"mesh, edge 2", "twice"});
  expect_unreadable(edges("[[0, 1, 2]]"), {"mesh.edges[0]", "two ends"});
}

TEST(ProjectFile, SaysWhatIsWrongWithTheDesign) {
  expect_unreadable(triangle(R"("design": {"layers": []})"), {"design.layers", "no layer"});
  expect_unreadable(triangle(R"("design": {"layers": {}})"), {"design.layers", "instead of a list"});
  expect_unreadable(layer(R"("name": 3)"), {"design.layers[0].name", "a number instead of a text"});
  expect_unreadable(layer(R"("visible": 1)"), {"design.layers[0].visible", "instead of true or false"});
  expect_unreadable(layer(R"("coplanar_with": 0)"), {"design.layers[0].coplanar_with", "out of range"});
  const std::string at = "design.layers[0].settings.";
  const auto settings = [](const std::string& members) { return layer("\"settings\": {" + members + "}"); };
  expect_unreadable(settings(R"("mode": "cubes")"), {at + "mode", "dual, planarize, cluster"});
  expect_unreadable(settings(R"("border": true)"), {at + "border", "closed, interior"});
  expect_unreadable(settings(R"("tolerance": 0)"), {at + "tolerance", "not positive"});
  expect_unreadable(settings(R"("max_iterations": -1)"), {at + "max_iterations", "0 or more"});
  expect_unreadable(settings(R"("weights": {"fairing": -1})"), {at + "weights.fairing", "negative"});
  expect_unreadable(settings(R"("weights": [1])"), {at + "weights", "no object"});
  expect_unreadable(settings(R"("offset": null)"), {at + "offset", "no NaN"});
  expect_unreadable(demands(R"("margin": -1)"), {at + "demands.margin", "negative"});
  expect_unreadable(demands(R"("list": [{"on": true}])"), {at + "demands.list[0].name", "missing"});
  expect_unreadable(demands(R"("list": [{"name": "x", "values": [1, "2"]}])"),
                    {at + "demands.list[0].values[1]"});
  expect_unreadable(demands(R"("pins": [{"of": "vertex", "element": 3, "at": [0, 0, 0]}])"),
                    {at + "demands.pins[0].element", "3 is out of range", "from 0 to 2"});
  expect_unreadable(demands(R"("pins": [{"of": "face", "element": 1, "at": [0, 0, 0]}])"),
                    {at + "demands.pins[0].element", "out of range"});
  expect_unreadable(demands(R"("pins": [{"of": "face", "element": 0, "at": [0, 0]}])"),
                    {at + "demands.pins[0].at", "2 coordinates", "null"});
  expect_unreadable(demands(R"("plane_pins": [{"panel_of": 3}])"),
                    {at + "demands.plane_pins[0].panel_of", "out of range"});
  expect_unreadable(demands(R"("plane_pins": [{"panel_of": 0, "normal": [0, 0, 0], "distance": 1}])"),
                    {at + "demands.plane_pins[0].normal", "not all 0"});
  expect_unreadable(demands(R"("plane_pins": [{"panel_of": 0, "distance": 1}])"), {"no normal"});
  expect_unreadable(demands(R"("waived": [{"demand": "face", "of": "panel", "index": 3}])"),
                    {at + "demands.waived[0].index", "no panel 3"});
  expect_unreadable(triangle(R"("design": {"selections": [{"name": "", "faces": [0]}]})"),
                    {"design.selections[0].name", "no name"});
  expect_unreadable(triangle(R"("design": {"selections": [{"name": "a"}, {"name": "a"}]})"),
                    {"design.selections[1].name", "two selections 'a'"});
  expect_unreadable(triangle(R"("design": {"selections": [{"name": "a", "edges": [3]}]})"),
                    {"design.selections[0].edges[0]", "out of range"});
}

TEST(ProjectFile, SaysWhatIsWrongWithTheWorkshop) {
  expect_unreadable(triangle(R"("workshop": {"unit": "furlong"})"), {"workshop.unit", "furlong"});
  expect_unreadable(triangle(R"("workshop": {"gap": -1})"), {"workshop.gap", "negative"});
  expect_unreadable(triangle(R"("workshop": {"names": "runes"})"), {"workshop.names", "row-letter, plain"});
  expect_unreadable(triangle(R"("workshop": {"tolerances": {"planarity": "thin"}})"),
                    {"workshop.tolerances"});
  const std::string names = R"("panel_names": [{"mode": "dual", "names": )";
  expect_unreadable(triangle(names + R"([[0, "A-1"], [1, "A-1"]]}])"),
                    {"panel_names[0].names", "panels 0 and 1 are both called 'A-1'"});
  expect_unreadable(triangle(names + R"([[0, "A-1"], [0, "A-2"]]}])"), {"panel 0 is named twice"});
  expect_unreadable(triangle(names + R"([[0, "A 1"]]}])"), {"'A 1' is no name for a panel"});
  expect_unreadable(triangle(names + R"([[-1, "A-1"]]}])"), {"out of range"});
  expect_unreadable(triangle(names + R"(["A-1"]}])"), {"panel_names[0].names[0]", "no pair"});
  expect_unreadable(triangle(names + R"([]}, {"mode": "dual", "names": []}])"), {"earlier entry"});
}

TEST(ProjectFile, SaysWhatIsWrongWithTheNumbers) {
  const auto numbers = [](const std::string& vertices, const std::string& closed = "[0, 1, 2]",
                          int given = 3) {
    return triangle(
        R"("numbers": {"opened": {"vertices": 3, "edges": 3, "faces": 1}, "given": {"vertices": )" +
        std::to_string(given) + R"(, "edges": 3, "faces": 1}, "vertices": )" + vertices +
        R"(, "edges": [0, 1, 2], "faces": [0], "panels_closed": )" + closed +
        R"(, "panels_interior": [0, 1, 2]})");
  };
  EXPECT_TRUE(read_project(numbers("[2, 0, 1]"), "x"));
  expect_unreadable(numbers("[0, 1]"), {"numbers.vertices", "2 numbers instead of 3"});
  expect_unreadable(numbers("[0, 1, 1]"), {"numbers.vertices", "1 is given twice"});
  expect_unreadable(numbers("[0, 1, 3]"), {"numbers.vertices[2]", "out of range"});
  expect_unreadable(numbers("[0, 1, 2]", "[0, 1, 3]"), {"numbers.panels_closed[2]", "out of range"});
  expect_unreadable(numbers("[0, 1, 1]", "[0, 1, 2]", 2), {"numbers.given", "fewer"});
}

// Bytes changed, lost or doubled: an error or another project, never a crash.
TEST(ProjectFile, AnyDamageIsAnErrorOrReadsAgain) {
  const std::string whole = text_of(busy_project());
  std::mt19937 random(7);
  int refused = 0;
  for (int run = 0; run < 400; ++run) {
    std::string text = whole;
    for (int k = 0; k < 1 + run % 3; ++k) {
      const size_t at = random() % text.size();
      if (run % 4 == 0)
        text.erase(at, random() % 40);
      else if (run % 4 == 1)
        text.insert(at, text.substr(random() % text.size(), random() % 40));
      else
        text[at] = "0123456789-.,[]{}\"eE n"[random() % 22];
    }
    const auto read = read_project(text, "damaged");
    if (read) {
      EXPECT_TRUE(format_project(read->project)) << run;
    } else {
      EXPECT_EQ(read.error().code, ErrorCode::Unreadable);
      ++refused;
    }
  }
  EXPECT_GT(refused, 200);
}

TEST(ProjectFile, SolvedPanelsThatDoNotFitAreLeftOut) {
  Project project = busy_project();
  project.solved[0]->x.conservativeResize(project.solved[0]->x.rows() - 1, 3);
  project.solved[2]->n.row(4) *= 1.1;
  const auto read = read_project(text_of(project), "x");
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->project.solved.size(), 3u);
  EXPECT_FALSE(read->project.solved[0] || read->project.solved[2]);
  ASSERT_EQ(read->warnings.size(), 2u);
  EXPECT_NE(read->warnings[0].find("solved[0]"), std::string::npos) << read->warnings[0];
  EXPECT_NE(read->warnings[0].find("points"), std::string::npos) << read->warnings[0];
  EXPECT_NE(read->warnings[1].find("normal 4 is not of length 1"), std::string::npos) << read->warnings[1];

  project = busy_project();
  project.solved[1] = project.solved[0];
  project.design.layers[1].settings.mode = ComplexKind::Cluster;  // whose regions are not there
  const auto clustered = read_project(text_of(project), "x");
  ASSERT_TRUE(clustered) << clustered.error().text();
  EXPECT_TRUE(clustered->project.solved[0] && !clustered->project.solved[1]);
  ASSERT_EQ(clustered->warnings.size(), 1u);
  EXPECT_NE(clustered->warnings[0].find("clustering"), std::string::npos) << clustered->warnings[0];
}

TEST(ProjectFile, RefusesBrokenLists) {
  expect_unreadable(triangle(R"("solved": 3)"), {"solved", "instead of a list"});
  expect_unreadable(triangle(R"("solved": [{"layer": 1}])"), {"solved[0].layer", "out of range"});
  expect_unreadable(triangle(R"("solved": [{"layer": 0, "points": [[0, 0]]}])"), {"solved[0].points[0]"});
  const std::string none = R"({"layer": 0, "points": [], "normals": [], "offsets": []})";
  expect_unreadable(triangle("\"solved\": [" + none + ", " + none + "]"), {"solved[1].layer", "there twice"});
}

TEST(ProjectFile, RefusesToWriteWhatJsonCannotSay) {
  Project project = busy_project();
  project.design.layers[0].settings.offset = std::numeric_limits<double>::quiet_NaN();
  const auto offset = format_project(project);
  ASSERT_FALSE(offset);
  EXPECT_EQ(offset.error().code, ErrorCode::Refused);
  EXPECT_EQ(offset.error().where, "design.layers[0].settings.offset");
  EXPECT_NE(offset.error().what.find("not finite"), std::string::npos);

  project = busy_project();
  project.solved[2]->x(5, 1) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(format_project(project).error().where, "solved[1].points[5][1]");

  project = busy_project();
  project.design.reference = "r\xff.obj";
  const auto reference = format_project(project);
  ASSERT_FALSE(reference);
  EXPECT_EQ(reference.error().where, "design.reference");
  EXPECT_NE(reference.error().what.find("UTF-8"), std::string::npos);
}

TEST(ProjectFile, IsSavedWholeOrNotAtAll) {
  const test::TemporaryFolder folder;
  const auto path = folder / "roof.planewright";
  Project project = busy_project();
  ASSERT_TRUE(save_project(path, project));
  const auto read = load_project(path);
  ASSERT_TRUE(read) << read.error().text();
  expect_same_project(read->project, project);

  project.design.layers[0].thickness = std::numeric_limits<double>::infinity();
  const auto refused = save_project(path, project);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, path.string() + ", design.layers[0].thickness");
  EXPECT_TRUE(load_project(path)) << "what was there is gone";

  EXPECT_EQ(save_project(folder / "none" / "x.planewright", busy_project()).error().code,
            ErrorCode::Unwritable);
  EXPECT_EQ(load_project(folder / "missing.planewright").error().code, ErrorCode::Unreadable);
  EXPECT_EQ(load_project(folder.path()).error().code, ErrorCode::Unreadable);
  EXPECT_NE(load_project("/dev/zero").error().what.find("device"), std::string::npos);
}

TEST(ProjectFile, IsKnownByEndingOrContent) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(is_project_file("missing.planewright"));
  EXPECT_TRUE(is_project_file("missing.PLANEWRIGHT"));
  EXPECT_FALSE(is_project_file("missing.json"));
  EXPECT_FALSE(is_project_file(folder.path()));
  EXPECT_TRUE(is_project_file(folder.write("a.json", "\n" + triangle())));
  EXPECT_FALSE(is_project_file(folder.write("b.json", "{\"format\": \"planewright tolerances\"}")));
  EXPECT_FALSE(is_project_file(folder.write("c.obj", "# planewright project\nv 0 0 0\n")));
  EXPECT_FALSE(is_project_file(folder.write("d.obj", "")));
}

}  // namespace
}  // namespace planewright
