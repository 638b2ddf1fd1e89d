// export through the real binary: a folder of certified files, and what it refuses.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

#include "cli/command_line.h"

namespace planewright {
namespace {

using test::Ended;
using test::text_of;

class Export : public test::CommandLineTest {
 protected:
  // Planar panels of the dome's dual; in feet they are about a square metre each.
  std::string panels() const {
    const std::string file = path("panels.obj");
    const Ended made = run({"dual", sample("dome", 60), "-o", file, "--quiet"});
    EXPECT_EQ(made.status, 0) << made.err;
    return file;
  }
  std::set<std::string> files_in(const std::string& folder) const {
    std::set<std::string> names;
    const std::filesystem::path root = folder_ / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
      if (entry.is_regular_file()) names.insert(std::filesystem::relative(entry.path(), root).string());
    return names;
  }
  std::set<std::string> hidden_files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      if (entry.path().filename().string().starts_with(".")) names.insert(entry.path().filename().string());
    return names;
  }
};

TEST_F(Export, AllFormatsAreWrittenAndCertified) {
  const Ended ended = run({"export", panels(), "-o", path("out"), "--format", "all", "--unit", "ft",
                           "--sheet", "3210x6000", "--thickness", "20", "--gap", "8", "--density", "2500"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::set<std::string> files = files_in("out");
  for (const char* name :
       {"sheets/sheet-01.dxf", "sheets/sheet-01.svg", "sheets.pdf", "panels.csv", "edges.csv",
        "schedule.json", "panels.obj", "panels.ply", "panels.stl", "panels.glb", "solids.obj", "solids.ply",
        "solids.stl", "solids.3mf", "solids.glb", "certificate.json", "certificate.html"})
    EXPECT_TRUE(files.contains(name)) << name;
  const auto certificate = json("out/certificate.json");
  EXPECT_EQ(certificate["pass"], true);
  EXPECT_NE(ended.out.find("all files read back as they should"), std::string::npos) << ended.out;
  EXPECT_TRUE(hidden_files().empty());
}

// On one page at 1:500 names are wider than narrow panels: a name is where its middle is, not where it
// begins.
TEST_F(Export, WithoutSheetsALargeRoofFitsOnePageAndIsCertified) {
  const std::string roof = std::string(PLANEWRIGHT_SOURCE_DIR) + "/assets/train-station.obj";
  ASSERT_EQ(run({"dual", roof, "-o", path("roof.obj"), "--quiet"}).status, 0);
  const Ended ended = run({"export", path("roof.obj"), "-o", path("out"), "--format", "pdf", "--unit", "m"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(json("out/certificate.json")["pass"], true) << ended.err;
}

TEST_F(Export, AMeshNeedsAUnit) {
  expect_refusal(run({"export", panels(), "-o", path("out"), "--format", "dxf"}), 2, {"--unit mm"});
  expect_refusal(run({"export", panels(), "-o", path("out"), "--format", "dxf", "--unit", "ell"}), 2,
                 {"--unit", "ell", "mm, cm, m, in or ft"});
  EXPECT_FALSE(exists("out"));
}

TEST_F(Export, UnitsGiveTheSameVerdicts) {
  // The same dome in feet, millimetres, inches and metres.
  const std::string in_feet = text_of(panels());
  std::vector<std::string> verdicts;
  for (const auto& [unit, factor] :
       std::vector<std::pair<std::string, double>>{{"ft", 1.0}, {"mm", 304.8}, {"in", 12.0}, {"m", 0.3048}}) {
    std::istringstream lines(in_feet);
    std::ofstream scaled(path(unit + ".obj"));
    scaled.precision(17);
    for (std::string line; std::getline(lines, line);) {
      double x, y, z;
      if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3)
        scaled << "v " << factor * x << ' ' << factor * y << ' ' << factor * z << '\n';
      else
        scaled << line << '\n';
    }
    scaled.close();
    const Ended ended =
        run({"export", path(unit + ".obj"), "-o", path("out-" + unit), "--format", "csv", "--unit", unit,
             "--edge-min", "400", "--area-max", "1.2", "--interior-max", "131"});
    ASSERT_EQ(ended.status, 1) << ended.err;
    std::smatch found;
    const std::regex line("tolerances .*");
    ASSERT_TRUE(std::regex_search(ended.out, found, line)) << ended.out;
    verdicts.push_back(found.str());
  }
  EXPECT_EQ(verdicts[0], verdicts[1]);
  EXPECT_EQ(verdicts[0], verdicts[2]);
  EXPECT_EQ(verdicts[0], verdicts[3]);
  EXPECT_EQ(verdicts[0].find(" 0 pass"), std::string::npos);
  EXPECT_EQ(verdicts[0].find(" 0 fail"), std::string::npos);
}

TEST_F(Export, RefusesOrMarksWhatFails) {
  const std::string file = panels();
  const Ended refused = run({"export", file, "-o", path("out"), "--format", "dxf", "--unit", "ft",
                             "--edge-min", "540", "--on-failure", "refuse"});
  expect_refusal(refused, 3, {"panels fail", "edge length", "below 540 mm"});
  EXPECT_FALSE(exists("out"));
  const Ended marked =
      run({"export", file, "-o", path("out"), "--format", "dxf", "--unit", "ft", "--edge-min", "540"});
  EXPECT_EQ(marked.status, 1) << marked.err;
  EXPECT_NE(text_of(folder_ / "out/parts.dxf").find("FAILS: "), std::string::npos);
}

TEST_F(Export, NothingIsOverwrittenUnasked) {
  const std::string file = panels();
  const std::vector<std::string> command{"export",  file,     "-o", path("out"), "--format",
                                         "dxf,csv", "--unit", "ft", "--sheet",   "3210x6000"};
  ASSERT_EQ(run(command).status, 0);
  const std::string before = text_of(folder_ / "out/panels.csv");
  folder_.write("out/panels.csv", "mine");
  expect_refusal(run(command), 5, {"sheets/sheet-01.dxf", "--overwrite"});
  EXPECT_EQ(text_of(folder_ / "out/panels.csv"), "mine");
  std::vector<std::string> again = command;
  again.push_back("--overwrite");
  ASSERT_EQ(run(again).status, 0);
  EXPECT_EQ(text_of(folder_ / "out/panels.csv"), before);
}

TEST_F(Export, OverwritingLeavesNoSheetsOfEarlierExports) {
  const std::string file = panels();
  ASSERT_EQ(
      run({"export", file, "-o", path("out"), "--format", "svg", "--unit", "ft", "--sheet", "1500x1500"})
          .status,
      0);
  const auto many = files_in("out");
  folder_.write("out/mine.txt", "");
  ASSERT_EQ(run({"export", file, "-o", path("out"), "--format", "svg", "--unit", "ft", "--sheet",
                 "12000x12000", "--overwrite"})
                .status,
            0);
  const auto few = files_in("out");
  EXPECT_LT(few.size(), many.size());
  EXPECT_TRUE(few.contains("mine.txt"));
  EXPECT_TRUE(few.contains("sheets/sheet-01.svg"));
}

TEST_F(Export, NamesAreKeptFromAnEarlierSchedule) {
  const std::string file = panels();
  ASSERT_EQ(run({"export", file, "-o", path("first"), "--format", "json", "--unit", "ft"}).status, 0);
  ASSERT_EQ(run({"export", file, "-o", path("plain"), "--format", "json", "--unit", "ft", "--names", "plain",
                 "--keep-names", path("first/schedule.json")})
                .status,
            0);
  const auto first = json("first/schedule.json"), plain = json("plain/schedule.json");
  ASSERT_FALSE(first["panels"].empty());
  for (std::size_t k = 0; k < first["panels"].size(); ++k)
    EXPECT_EQ(first["panels"][k]["name"], plain["panels"][k]["name"]);
}

TEST_F(Export, AProjectBringsItsUnitAndItsPanels) {
  const Ended made = run({"dual", sample("dome", 60), "-o", path("panels.obj"), "--project",
                          path("dome.planewright"), "--unit", "cm", "--quiet"});
  ASSERT_EQ(made.status, 0) << made.err;
  ASSERT_EQ(run({"export", path("dome.planewright"), "-o", path("project"), "--format", "json"}).status, 0);
  ASSERT_EQ(
      run({"export", path("panels.obj"), "-o", path("mesh"), "--format", "json", "--unit", "cm"}).status, 0);
  const auto project = json("project/schedule.json"), mesh = json("mesh/schedule.json");
  ASSERT_EQ(project["panels"].size(), mesh["panels"].size());
  for (std::size_t k = 0; k < mesh["panels"].size(); ++k)
    EXPECT_NEAR(project["panels"][k]["area_m2"].get<double>(), mesh["panels"][k]["area_m2"].get<double>(),
                1e-12);
  expect_refusal(
      run({"export", path("dome.planewright"), "-o", path("out"), "--format", "json", "--unit", "ft"}), 2,
      {"its own unit, cm"});
  expect_refusal(
      run({"export", path("dome.planewright"), "-o", path("out"), "--format", "json", "--layer", "roof"}), 2,
      {"roof"});
}

TEST_F(Export, DistancesAreMeasuredFromASurfaceOrNotAtAll) {
  const std::string mesh = sample("dome", 60);
  ASSERT_EQ(run({"dual", mesh, "-o", path("panels.obj"), "--project", path("dome.planewright"), "--unit",
                 "ft", "--quiet"})
                .status,
            0);
  folder_.write("sheet.json", R"({"format": "planewright tolerances", "version": 1, "distance_mm": 5})");
  expect_refusal(run({"export", path("panels.obj"), "-o", path("out"), "--format", "csv", "--unit", "ft",
                      "--tolerances", path("sheet.json")}),
                 2, {"--distance", "--reference"});
  EXPECT_FALSE(exists("out"));
  const Ended named = run({"export", path("panels.obj"), "-o", path("out"), "--format", "csv", "--unit", "ft",
                           "--tolerances", path("sheet.json"), "--reference", mesh});
  EXPECT_EQ(named.status, 1) << named.err;
  EXPECT_NE(named.err.find("distance"), std::string::npos) << named.err;
  // A project knows the surface that its panels were made for.
  const Ended known = run({"export", path("dome.planewright"), "-o", path("known"), "--format", "csv",
                           "--tolerances", path("sheet.json")});
  EXPECT_EQ(known.out.substr(0, known.out.find("wrote")), named.out.substr(0, named.out.find("wrote")));
}

TEST_F(Export, BadInputIsNamed) {
  const std::string file = panels();
  const auto refused = [&](const std::vector<std::string>& options, int status,
                           const std::vector<std::string>& saying) {
    std::vector<std::string> command{"export", file, "-o", path("out"), "--unit", "ft"};
    command.insert(command.end(), options.begin(), options.end());
    expect_refusal(run(command), status, saying);
    EXPECT_FALSE(exists("out"));
  };
  refused({"--format", "dwg"}, 2, {"dwg", "dxf"});
  refused({"--format", "dxf", "--sheet", "3210"}, 2, {"--sheet", "3210x6000"});
  refused({"--format", "dxf", "--sheet", "100x100"}, 3, {"no panel fits a sheet of 100 x 100 mm"});
  refused({"--format", "dxf", "--thickness", "0"}, 2, {"--thickness"});
  refused({"--format", "3mf"}, 2, {"3mf", "thickness"});
  refused({"--format", "dxf", "--edge-min", "20", "--edge-max", "10"}, 2, {"edge"});
  refused({"--format", "dxf", "--tolerances", path("missing.json")}, 3, {"missing.json"});
  folder_.write("sheet.json", R"({"format": "planewright tolerances", "version": 1, "planarty": 1})");
  refused({"--format", "dxf", "--tolerances", path("sheet.json")}, 3,
          {"sheet.json", "planarty", "planarity"});
  expect_refusal(run({"export", file, "-o", path("no/out"), "--format", "dxf", "--unit", "ft"}), 5,
                 {"no/out"});
  folder_.write("a-file", "");
  expect_refusal(run({"export", file, "-o", path("a-file"), "--format", "dxf", "--unit", "ft"}), 5,
                 {"a-file"});
}

TEST_F(Export, AFullDiskLeavesNothing) {
  const Ended ended = run({"export", panels(), "-o", path("out"), "--format", "all", "--unit", "ft"},
                          "trap '' XFSZ; ulimit -f 8;");
  EXPECT_EQ(ended.status, 5) << ended.err;
  EXPECT_NE(ended.err.find("cannot be written"), std::string::npos) << ended.err;
  EXPECT_FALSE(exists("out"));
  EXPECT_TRUE(hidden_files().empty());
}

TEST_F(Export, APanelThatCrossesItselfIsNamed) {
  folder_.write("bow.obj",
                "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 3 0 0\nv 4 0 0\nv 4 1 0\nf 1 2 3 4\nf 5 6 7\n");
  const Ended refused = run({"export", path("bow.obj"), "-o", path("out"), "--format", "dxf", "--unit", "ft",
                             "--names", "plain", "--on-failure", "refuse"});
  expect_refusal(refused, 3, {"crosses itself"});
  const Ended marked = run({"export", path("bow.obj"), "-o", path("out"), "--format", "dxf,csv", "--unit",
                            "m", "--names", "plain"});
  EXPECT_EQ(marked.status, 1);
  EXPECT_NE(marked.err.find("cross"), std::string::npos) << marked.err;
  EXPECT_NE(text_of(folder_ / "out/panels.csv").find("cross"), std::string::npos);
}

TEST_F(Export, APanelWithoutSolidIsLeftOutOfSolidsAndTheRestIsCertified) {
  // Counted from 1 the first panel has no solid, so that numbers in files do not begin at 0.
  folder_.write("bow.obj",
                "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 3 0 0\nv 4 0 0\nv 4 1 0\nf 1 2 3 4\nf 5 6 7\n");
  const Ended ended = run({"export", path("bow.obj"), "-o", path("out"), "--format", "obj,ply,stl,3mf,gltf",
                           "--unit", "m", "--thickness", "20"});
  EXPECT_EQ(ended.status, 1);
  for (const auto& file : json("out/certificate.json")["files"])
    EXPECT_EQ(file["pass"], true) << file.dump(1);
}

}  // namespace
}  // namespace planewright
