#include "core/writers/schedule_writers.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/python.h"
#include "support/writer_scenes.h"

namespace planewright {
namespace {

using namespace test;
using Json = nlohmann::json;

constexpr const char* kCsv = R"(
import sys, csv, json
text = open(sys.argv[1], newline="").read()
assert text.count("\n") == text.count("\r\n")
print(json.dumps(list(csv.DictReader(text.splitlines()))))
)";

struct Fixture {
  WorkshopModel model = named_cube(1000.0 / 3.0, {1e6, 0.1, 0.0});
  std::vector<PanelPassport> passports;
  ToleranceVerdicts verdicts;
  std::vector<CongruenceClass> classes{{{{0}, {1}, {2}}}, {{{3}, {4, true, 1, 0.01}, {5}}}};
  Nesting nesting;
  ScheduleSources sources;

  Fixture() {
    for (int p = 0; p < 6; ++p) {
      PanelPassport passport;
      passport.panel = p;
      passport.area = 1e6 / 9.0;
      passport.perimeter = 4000.0 / 3.0;
      passport.planarity = 1e-7 / 3.0;
      passport.sides = {{p == 0 ? -1 : 0, 1000.0 / 3.0, 90.0, 270.0, -45.0}, {5, 333.0, 90.0, 180.0, 0.0}};
      passports.push_back(passport);
    }
    passports[1].weight = 12.5;
    passports[1].distance = std::numeric_limits<double>::quiet_NaN();
    verdicts.pass = {true, true, false, true, true, true};
    verdicts.failures = {{2, ToleranceKind::EdgeMin, 1, 24.1, 50.0}, {2, ToleranceKind::CrossesItself}};
    verdicts.passed = 5;
    verdicts.failed = 1;
    nesting.sheets.resize(2);
    nesting.sheets[1].parts = {{4, 0.5, {1.0, 2.0}}};
    nesting.unplaced = {5};
    sources = {&model, &passports, &verdicts, &classes};
    sources.nesting = &nesting;
    sources.thickness = 20.0;
  }
};

TEST(ScheduleWriters, PanelTableReadsBack) {
  const std::string python = python_with("csv");
  if (python.empty()) GTEST_SKIP() << "no python";
  const Fixture f;
  const Json rows = read_with_python(python, kCsv, format_panel_csv(f.sources), "panels.csv");
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0].size(), 15u);
  for (size_t p = 0; p < 6; ++p) {
    EXPECT_EQ(rows[p]["name"], f.model.names[p]);
    EXPECT_EQ(std::stod(rows[p]["area_m2"].get<std::string>()), 1e6 / 9.0 * 1e-6);
    EXPECT_EQ(std::stod(rows[p]["planarity_mm"].get<std::string>()), 1e-7 / 3.0);
  }
  EXPECT_EQ(rows[5]["number"], "7");
  EXPECT_EQ(rows[4]["class"], "2");
  EXPECT_EQ(rows[4]["mirrored"], "yes");
  EXPECT_EQ(rows[4]["sheet"], "2");
  EXPECT_EQ(rows[5]["sheet"], "");
  EXPECT_EQ(rows[1]["weight_kg"], "12.5");
  EXPECT_EQ(rows[1]["distance_mm"], "");
  EXPECT_EQ(rows[2]["verdict"], "fail");
  EXPECT_EQ(rows[2]["failures"], "edge_min side 2: 24.1 < 50; crosses_itself");
  EXPECT_EQ(rows[3]["verdict"], "pass");
}

TEST(ScheduleWriters, EdgeTableReadsBack) {
  const std::string python = python_with("csv");
  if (python.empty()) GTEST_SKIP() << "no python";
  Fixture f;
  f.model.names[5] = "odd, \"name\"";
  const Json rows = read_with_python(python, kCsv, format_edge_csv(f.sources), "edges.csv");
  ASSERT_EQ(rows.size(), 12u);
  EXPECT_EQ(rows[0]["neighbour"], "");
  EXPECT_EQ(rows[1]["neighbour"], "odd, \"name\"");
  EXPECT_EQ(rows[1]["side"], "2");
  EXPECT_EQ(rows[2]["neighbour"], "A-1");
  EXPECT_EQ(std::stod(rows[2]["length_mm"].get<std::string>()), 1000.0 / 3.0);
  EXPECT_EQ(rows[2]["dihedral_deg"], "270");
  EXPECT_EQ(rows[2]["bevel_deg"], "-45");
}

TEST(ScheduleWriters, JsonHoldsEverythingAndGivesNamesBack) {
  const Fixture f;
  const std::string text = format_schedule_json(f.sources);
  const Json json = Json::parse(text);
  EXPECT_EQ(json["unit"], "mm");
  EXPECT_EQ(json["panels"].size(), 6u);
  EXPECT_EQ(json["panels"][1]["corners_mm"][2][0].get<double>(), 1e6 + 1000.0 / 3.0);
  EXPECT_TRUE(json["panels"][1]["distance_mm"].is_null());
  EXPECT_EQ(json["panels"][2]["failures"][0]["side"], 2);
  EXPECT_EQ(json["nesting"]["unplaced"], Json::array({"C-1"}));
  EXPECT_EQ(json["classes"][1][1]["mirrored"], true);
  const auto kept = read_kept_names(text, "schedule.json");
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->size(), 6u);
  EXPECT_EQ(kept->back(), (std::pair<int, std::string>(7, "C-1")));
}

TEST(ScheduleWriters, NamesThatCannotBeReadAreRefused) {
  const std::string head = R"({"format": "planewright schedule", "version": 1, "names": )";
  for (const std::string& bad :
       {std::string("not json"), std::string("{}"), std::string("[1]"), head + "3}", head + "[1]}",
        head + R"([{"number": 1.5, "name": "A"}]})", head + R"([{"number": -1, "name": "A"}]})",
        head + R"([{"number": 1, "name": ""}]})",
        head + R"([{"number": 1, "name": "A"}, {"number": 1, "name": "B"}]})",
        head + R"([{"number": 1, "name": "A"}, {"number": 2, "name": "A"}]})",
        std::string(R"({"format": "planewright schedule", "version": 2, "names": []})")}) {
    const auto read = read_kept_names(bad, "old.json");
    ASSERT_FALSE(read) << bad;
    EXPECT_EQ(read.error().code, ErrorCode::Unreadable);
    EXPECT_NE(read.error().text().find("old.json"), std::string::npos);
  }
  EXPECT_TRUE(read_kept_names(head + "[]}", "old.json"));
}

}  // namespace
}  // namespace planewright
