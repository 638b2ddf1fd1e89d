// Classes, sheets, verdicts and failures in the schedules, each with faults.
#include <gtest/gtest.h>

#include "core/certify/schedule_entries.h"
#include "support/certify_sample.h"

namespace planewright {
namespace {

using sample::replaced;
using sample::Strip;
using sample::text;
using Names = std::vector<std::string>;

class CertificateSchedules : public ::testing::Test {
 protected:
  Names csv(const std::string& from, const std::string& to) const {
    return strip.failures("p.csv", FileKind::PanelCsv, replaced(strip.panel_csv(), from, to));
  }
  Names json(const std::string& from, const std::string& to) const {
    return strip.failures("a.json", FileKind::ScheduleJson, replaced(strip.json(), from, to));
  }
  Strip strip;
};

TEST_F(CertificateSchedules, Classes) {
  const Names wrong{"classes"}, members{"members of classes"};
  EXPECT_EQ(csv("A-1,7,1,no", "A-1,7,2,no"), wrong);
  EXPECT_EQ(csv("A-1,7,1,no", "A-1,7,,no"), wrong);
  EXPECT_EQ(csv("A-1,7,1,no", "A-1,7,1,yes"), wrong);
  EXPECT_EQ(csv("A-1,7,1,no", "A-1,7,1,"), wrong);
  EXPECT_EQ(json(R"("class":1)", R"("class":2)"), wrong);
  EXPECT_EQ(json(R"("class":1)", R"("class":null)"), wrong);
  EXPECT_EQ(json(R"("class":1,)", ""), wrong);
  EXPECT_EQ(json(R"("class":1,"mirrored":true)", R"("class":1,"mirrored":false)"), wrong);
  EXPECT_EQ(json(R"("mirrored":true,"shift":2)", R"("mirrored":false,"shift":2)"), members);
  EXPECT_EQ(json(R"("shift":2)", R"("shift":1)"), members);
  EXPECT_EQ(json(R"([[{"panel":"A-1")", R"([[{"panel":"A-3")"), members);
  EXPECT_EQ(json(R"("deviation_mm":0)", R"("deviation_mm":0.05)"), members);
  EXPECT_EQ(json(R"("classes":[[)", R"("classes":[[],[)"), members);
}

TEST_F(CertificateSchedules, SheetsAreThoseThatShowThePart) {
  const Names wrong{"sheets"};
  EXPECT_EQ(csv(",1,pass", ",2,pass"), wrong);
  EXPECT_EQ(csv(",1,pass", ",,pass"), wrong);
  EXPECT_EQ(csv(",1,pass", ",one,pass"), wrong);
  EXPECT_EQ(json(R"("sheet":1)", R"("sheet":2)"), wrong);
  EXPECT_EQ(json(R"("sheet":1)", R"("sheet":null)"), wrong);
  EXPECT_EQ(json(R"("sheet":1)", R"("sheet":"1")"), wrong);
}

TEST_F(CertificateSchedules, NoSheetForWhatIsLeftOutOrInRows) {
  const std::string good_csv = strip.panel_csv(), good_json = strip.json();
  Strip other;
  auto& d = other.content.drawings[0];
  std::erase_if(d.lines, [](const auto& l) { return l.panel == 2; });
  std::erase_if(d.texts, [](const auto& t) { return t.panel == 2; });
  other.content.left_out = {2};
  EXPECT_EQ(other.failures("p.csv", FileKind::PanelCsv, good_csv), (Names{"sheets"}));
  EXPECT_EQ(other.failures("a.json", FileKind::ScheduleJson, good_json),
            (Names{"sheets", "places on sheets"}));
  const size_t last = good_csv.rfind(",1,pass");
  EXPECT_EQ(other.failures("p.csv", FileKind::PanelCsv, std::string(good_csv).replace(last, 7, ",,pass")),
            Names{});
  Strip rows;
  rows.content.nesting.reset();
  EXPECT_EQ(rows.failures("p.csv", FileKind::PanelCsv, good_csv), (Names{"sheets"}));
  EXPECT_EQ(rows.failures("a.json", FileKind::ScheduleJson, good_json),
            (Names{"sheets", "places on sheets"}));
}

TEST_F(CertificateSchedules, VerdictsAndFailures) {
  const Names wrong{"verdicts and failures"};
  EXPECT_EQ(csv(",pass", ",fail"), wrong);
  EXPECT_EQ(csv(",fail,", ",pass,"), wrong);
  EXPECT_EQ(csv("edge_min side 2", "edge_max side 2"), wrong);
  EXPECT_EQ(csv("edge_min side 2", "edge_min side 3"), wrong);
  EXPECT_EQ(csv("edge_min side 2: " + text(sample::kSide) + " < 50; ", ""), wrong);
  EXPECT_EQ(csv(text(sample::kSide) + " < 50", text(sample::kSide) + " > 50"), wrong);
  EXPECT_EQ(csv(" < 50", " < 51"), wrong);
  EXPECT_EQ(csv("area_max: 0.5", "area_max: 0.6"), wrong);
  EXPECT_EQ(csv("pass,", "pass,planarity: 0.7 > 0.5"), wrong);
  EXPECT_EQ(json("\"pass\"", "\"fail\""), wrong);
  EXPECT_EQ(json("\"fail\"", "\"pass\""), wrong);
  EXPECT_EQ(json(R"("edge_min","side":2)", R"("edge_min","side":1)"), wrong);
  EXPECT_EQ(json(R"("area_max")", R"("area_min")"), wrong);
  EXPECT_EQ(json(R"("limit":0.25})", R"("limit":0.26})"), wrong);
  EXPECT_EQ(json(R"("limit":0.25})", R"("limit":null})"), wrong);
  EXPECT_EQ(json(R"("failures":[],)", ""), wrong);
  EXPECT_EQ(json(R"("failures":[],)", R"("failures":[7],)"), wrong);
  EXPECT_EQ(json(R"("passed":2)", R"("passed":3)"), (Names{"totals"}));
  EXPECT_EQ(json(R"("failed":1,)", ""), (Names{"totals"}));
  // A verdict that its own failures do not bear out.
  strip.verdicts.pass[0] = false;
  EXPECT_EQ(csv(",pass", ",fail"), wrong);
}

TEST_F(CertificateSchedules, CrossingHasNoNumbersInATable) {
  strip.verdicts.failures = {{1, ToleranceKind::EdgeMin, 1, sample::kSide, 50.0},
                             {1, ToleranceKind::CrossesItself, -1, 1.0, 0.0}};
  const std::string all = "edge_min side 2: " + text(sample::kSide) +
                          " < 50; edge_min side 4: " + text(sample::kSide) + " < 50; area_max: 0.5 > 0.25";
  const std::string first = all.substr(0, all.find("; "));
  EXPECT_EQ(csv(all, first + "; crosses_itself"), Names{});
  EXPECT_EQ(csv(all, first), (Names{"verdicts and failures"}));
  EXPECT_EQ(csv(all, first + "; crosses_itself side 1"), (Names{"verdicts and failures"}));
}

TEST_F(CertificateSchedules, PlacesAreThoseOfTheDrawings) {
  const Names wrong{"places on sheets"};
  EXPECT_EQ(json(R"("rotation_rad":0)", R"("rotation_rad":1e-5)"), wrong);
  EXPECT_EQ(json(R"("shift_mm":[10,)", R"("shift_mm":[10.001,)"), wrong);
  EXPECT_EQ(json(R"("shift_mm":[10,)", R"("shift_mm":[10.0000001,)"), Names{});
  EXPECT_EQ(json(R"({"panel":"A-1","rotation)", R"({"panel":"A-2","rotation)"), wrong);
  EXPECT_EQ(json(R"("width_mm":150)", R"("width_mm":151)"), wrong);
  EXPECT_EQ(json(R"("unplaced":[])", R"("unplaced":["A-1"])"), wrong);
  EXPECT_EQ(json(R"("filled":0.)", R"("filled":0.9)"), wrong);
  EXPECT_EQ(json(R"("sheets":[{)", R"("sheets":[{"parts":[]},{)"), wrong);
  EXPECT_EQ(json(R"("nesting":{)", R"("nested":{)"), wrong);
}

TEST(FailuresOfATable, AreReadAsTheyAreWritten) {
  EXPECT_TRUE(failures_in("")->empty());
  const auto read = failures_in("edge_min side 3: 24.1 < 50; planarity: 0.7 > 0.5; crosses_itself");
  ASSERT_TRUE(read && read->size() == 3);
  EXPECT_EQ((*read)[0].kind, "edge_min");
  EXPECT_EQ((*read)[0].side, 3.0);
  EXPECT_EQ((*read)[0].measured, 24.1);
  EXPECT_EQ((*read)[1].limit, 0.5);
  EXPECT_FALSE((*read)[1].side);
  EXPECT_EQ((*read)[2].kind, "crosses_itself");
  for (const char* bad : {"planarity: 0.7 < 0.5", "planarity: 0.7", "planarity: > 0.5", "planarity: 0.7 >",
                          "planarity: a > b", "edge_min side x: 1 < 2", "planarity: <"})
    EXPECT_FALSE(failures_in(bad)) << bad;
}

}  // namespace
}  // namespace planewright
