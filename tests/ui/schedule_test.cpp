// The schedule without a window: cells, order, filters, sums and what is copied, of panels known by hand.
#include "ui/schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "support/panel_designs.h"
#include "ui/schedule_filter.h"

namespace planewright::ui {
namespace {

using Column = ScheduleColumn;

std::shared_ptr<PreparedWorkshop> prepared(const PanelDesign& design, WorkshopOptions options,
                                           const ToleranceSheet& sheet = {}, double thickness = 0.0,
                                           double density = 0.0, bool thorough = true) {
  auto made = std::make_shared<PreparedWorkshop>();
  made->model = model_of(design, options);
  made->passports = make_passports(*made->model, {.thickness = thickness, .density = density});
  if (thorough) {
    made->classes = congruence_classes(*made->model, made->passports);
    made->class_of_panel.assign(made->passports.size(), -1);
    for (std::size_t c = 0; c < made->classes.size(); ++c)
      for (const CongruenceMember& member : made->classes[c].members)
        made->class_of_panel[static_cast<std::size_t>(member.panel)] = static_cast<int>(c);
  }
  made->verdicts = check_tolerances(*made->model, made->passports, sheet);
  return made;
}

// Twelve rectangles of 100 (i + 1) x 1000 mm, apart from one another, named 1 to 12; the last is like the
// first.
std::shared_ptr<PreparedWorkshop> rectangles(const ToleranceSheet& sheet = {}, double density = 0.0,
                                             bool thorough = true) {
  std::vector<std::vector<std::array<double, 2>>> outlines;
  for (int i = 0; i < 12; ++i) {
    const double x = 5000.0 * i, w = 100.0 * (i < 11 ? i + 1 : 1);
    outlines.push_back({{x, 0}, {x + w, 0}, {x + w, 1000}, {x, 1000}});
  }
  WorkshopOptions options = in_unit(LengthUnit::Millimetre);
  options.names = NameStyle::Plain;
  return prepared(flat_panels(outlines), options, sheet, density > 0 ? 10.0 : 0.0, density, thorough);
}

std::vector<std::string> names(const Schedule& schedule, const ScheduleQuery& query,
                               const std::vector<bool>& selected = {}) {
  std::vector<std::string> found;
  for (const int panel : make_schedule_list(schedule, query, selected).panels)
    found.push_back(schedule.name(panel));
  return found;
}

std::vector<std::string> filtered(const Schedule& schedule, const std::string& filter) {
  return names(schedule, {.filter = filter});
}
std::string error_of(const Schedule& schedule, const std::string& filter) {
  return make_schedule_list(schedule, {.filter = filter}, {}).filter_error;
}
using Names = std::vector<std::string>;

TEST(ScheduleTest, CellsReadAsAWorkshopReadsThem) {
  const Schedule schedule = make_schedule(rectangles({.edge_min = 150.0}, 2500.0));
  EXPECT_EQ(cell_text(schedule, 1, Column::Name), "2");
  EXPECT_EQ(cell_text(schedule, 1, Column::Corners), "4");
  EXPECT_EQ(cell_text(schedule, 1, Column::Area), "0.2");
  EXPECT_EQ(cell_text(schedule, 1, Column::EdgeMin), "200");
  EXPECT_EQ(cell_text(schedule, 1, Column::EdgeMax), "1,000");
  EXPECT_EQ(cell_text(schedule, 1, Column::InteriorMin), "90");
  EXPECT_EQ(cell_text(schedule, 1, Column::BevelMax), "0");
  EXPECT_EQ(cell_text(schedule, 1, Column::Distance), "–") << "no reference, no distance";
  EXPECT_EQ(cell_text(schedule, 1, Column::Weight), "5");
  EXPECT_EQ(cell_text(schedule, 1, Column::Size), "1,000 × 200");
  EXPECT_EQ(cell_text(schedule, 0, Column::Class), "1 ×2");
  EXPECT_EQ(cell_text(schedule, 1, Column::Class), "2 ×1");
  EXPECT_EQ(cell_text(schedule, 1, Column::Verdict), "pass");
  // Two edges of 100 mm.
  EXPECT_EQ(cell_text(schedule, 0, Column::Verdict), "edge length 100 < 150 mm, and 1 more");
}

TEST(ScheduleTest, WhatRoundsToTheLimitIsToldApartFromIt) {
  const Schedule schedule = make_schedule(rectangles({.edge_max = 999.99}));
  const std::string text = cell_text(schedule, 3, Column::Verdict);
  EXPECT_EQ(text.find("1,000 > 1,000"), std::string::npos) << text;
  EXPECT_NE(text.find("> 999.99 mm"), std::string::npos) << text;
}

TEST(ScheduleTest, MeasuresOfRoundingAreNotSpelledOut) {
  auto from = rectangles();
  from->passports[0].planarity = 2.1e-10;
  EXPECT_EQ(cell_text(make_schedule(from), 0, Column::Planarity), "<0.001");
}

TEST(ScheduleTest, NamesComeInNaturalOrder) {
  const Schedule schedule = make_schedule(rectangles());
  const Names up = names(schedule, {});
  EXPECT_EQ(up, (Names{"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12"}));
  const Names down = names(schedule, {.descending = true});
  EXPECT_EQ(down, Names(up.rbegin(), up.rend()));
}

TEST(ScheduleTest, OrdersByEachColumnAndTiesByName) {
  const Schedule schedule = make_schedule(rectangles({.edge_min = 250.0}));
  // The areas: 1 and 12 are the same.
  const Names by_area = names(schedule, {.sort = Column::Area});
  EXPECT_EQ(Names(by_area.begin(), by_area.begin() + 4), (Names{"1", "12", "2", "3"}));
  const Names largest_first = names(schedule, {.sort = Column::Area, .descending = true});
  EXPECT_EQ(largest_first.front(), "11");
  EXPECT_EQ(Names(largest_first.end() - 2, largest_first.end()), (Names{"1", "12"}))
      << "ties stay by name in either direction";
  // Those of one number of corners are all tied.
  EXPECT_EQ(names(schedule, {.sort = Column::Corners, .descending = true}), names(schedule, {}));
  // 1, 2 and 12 fail.
  const Names failing_last = names(schedule, {.sort = Column::Verdict});
  EXPECT_EQ(Names(failing_last.end() - 3, failing_last.end()), (Names{"1", "2", "12"}));
  EXPECT_EQ(names(schedule, {.sort = Column::Class})[1], "12");
}

TEST(ScheduleTest, RoundingMakesNoOrder) {
  auto from = rectangles();
  from->passports[11].area *= 1 - 1e-14;  // smaller than its like
  EXPECT_EQ(names(make_schedule(from), {.sort = Column::Area})[0], "1");
}

TEST(ScheduleTest, UnknownValuesComeLastInEitherDirection) {
  auto from = rectangles();
  from->passports[4].distance = 3.0;
  from->passports[7].distance = 1.0;
  const Schedule schedule = make_schedule(from);
  const Names up = names(schedule, {.sort = Column::Distance});
  EXPECT_EQ(Names(up.begin(), up.begin() + 3), (Names{"8", "5", "1"}));
  const Names down = names(schedule, {.sort = Column::Distance, .descending = true});
  EXPECT_EQ(Names(down.begin(), down.begin() + 3), (Names{"5", "8", "1"}));
}

TEST(ScheduleTest, WordsOfAFilterAllHaveToHold) {
  const Schedule schedule = make_schedule(rectangles({.edge_min = 250.0}));
  EXPECT_EQ(filtered(schedule, "1"), (Names{"1", "10", "11", "12"}));
  EXPECT_EQ(filtered(schedule, "1 fails"), (Names{"1", "12"}));
  EXPECT_EQ(filtered(schedule, "1 PASSES area>1"), (Names{"11"}));
  EXPECT_EQ(filtered(schedule, " area > 0.85 \t shortest<1000 "), (Names{"9"}));
  EXPECT_EQ(filtered(schedule, "").size(), 12u);
}

TEST(ScheduleTest, ComparesEveryMeasure) {
  auto from = rectangles({}, 2500.0);
  from->passports[2].planarity = 0.3;
  from->passports[3].distance = 7.0;
  const Schedule schedule = make_schedule(from);
  EXPECT_EQ(filtered(schedule, "edge<150"), (Names{"1", "12"}));
  EXPECT_EQ(filtered(schedule, "edge>1050"), (Names{"11"}));
  EXPECT_EQ(filtered(schedule, "edge=500"), (Names{"5"}));
  EXPECT_EQ(filtered(schedule, "edge!=1000"), Names()) << "all have an edge of 1 m";
  EXPECT_EQ(filtered(schedule, "longest>1000"), (Names{"11"}));
  EXPECT_EQ(filtered(schedule, "longest≥1,1000").size(), 12u) << "left aside, as no number";
  EXPECT_EQ(filtered(schedule, "longest≥1000").size(), 12u);
  EXPECT_EQ(filtered(schedule, "corners=4").size(), 12u);
  EXPECT_EQ(filtered(schedule, "corners!=4"), Names());
  EXPECT_EQ(filtered(schedule, "planarity>0.2"), (Names{"3"}));
  EXPECT_EQ(filtered(schedule, "distance>=7"), (Names{"4"})) << "what is not known is not more";
  EXPECT_EQ(filtered(schedule, "distance<8"), (Names{"4"})) << "nor less";
  EXPECT_EQ(filtered(schedule, "weight>=25"), (Names{"10", "11"}));
  EXPECT_EQ(filtered(schedule, "angle<89.9"), Names());
  EXPECT_EQ(filtered(schedule, "bevel<=0").size(), 12u);
  EXPECT_EQ(filtered(schedule, "height<=200 width=1000"), (Names{"1", "2", "12"}));
  EXPECT_EQ(filtered(schedule, "Edge<150mm AREA<0.11m2 area<0.11 m²"), (Names{"1", "12"}));
}

TEST(ScheduleTest, EqualIsWhatReadsTheSame) {
  auto from = rectangles();
  from->passports[4].area = 2.3149e6;
  const Schedule schedule = make_schedule(from);
  EXPECT_EQ(cell_text(schedule, 4, Column::Area), "2.31");
  EXPECT_EQ(filtered(schedule, "area=2.31"), (Names{"5"}));
  EXPECT_EQ(filtered(schedule, "area<=2.31 area>2"), (Names{"5"}));
  EXPECT_EQ(filtered(schedule, "area=2.32"), Names());
}

TEST(ScheduleTest, FindsClassesByTheFilesNumber) {
  const Schedule schedule = make_schedule(rectangles());
  EXPECT_EQ(filtered(schedule, "class:1"), (Names{"1", "12"}));
  EXPECT_EQ(filtered(schedule, "class=1"), (Names{"1", "12"}));
  EXPECT_EQ(filtered(schedule, "class:2"), (Names{"2"}));
  EXPECT_EQ(error_of(schedule, "class:Q"), "'class:Q': classes are 1 to 11");
  EXPECT_EQ(error_of(schedule, "class:0"), "'class:0': classes are 1 to 11");
}

TEST(ScheduleTest, FindsNeighboursByTheirWholeNameFirst) {
  WorkshopOptions options = in_unit(LengthUnit::Metre);
  const Schedule schedule = make_schedule(prepared(wall(2, 11), options));
  const Names all = names(schedule, {});
  ASSERT_EQ(all.size(), 22u);
  EXPECT_EQ(all.front(), "A-01");
  EXPECT_EQ(filtered(schedule, "to:A-01"), (Names{"A-02", "B-01"}));
  EXPECT_EQ(filtered(schedule, "to: a-05"), (Names{"A-04", "A-06", "B-05"}));
  EXPECT_EQ(filtered(schedule, "to:a-0 A-1"), (Names{"A-10"})) << "a part of a name, too";
  EXPECT_EQ(error_of(schedule, "to:C-17"), "'to:C-17': no panel has such a name");
}

TEST(ScheduleTest, SaysWhatItDoesNotUnderstandAndLeavesItAside) {
  const Schedule schedule = make_schedule(rectangles());
  const auto list = make_schedule_list(schedule, {.filter = "edgy<3 area>1"}, {});
  EXPECT_TRUE(list.filter_error.starts_with("'edgy<3': columns are corners, area, edge, "))
      << list.filter_error;
  EXPECT_NE(list.filter_error.find("Is edge meant?"), std::string::npos) << list.filter_error;
  EXPECT_EQ(list.size(), 1) << "the other word holds";
  EXPECT_TRUE(error_of(schedule, "<3").starts_with("'<3': columns are "));
  EXPECT_EQ(error_of(schedule, "area>"), "'area>': a number comes after >, in m²");
  EXPECT_EQ(error_of(schedule, "area>two"), "'area>two': a number comes after >, in m²");
  EXPECT_EQ(error_of(schedule, "area>nan"), "'area>nan': a number comes after >, in m²");
  EXPECT_EQ(error_of(schedule, "corners=4mm"), "'corners=4mm': a number comes after =");
  EXPECT_EQ(error_of(schedule, "area><2"), "'area><2': comparisons are <, <=, >, >=, = and !=");
  EXPECT_EQ(error_of(schedule, "weight>2"), "'weight>2': weights are known with a thickness and a density");
  EXPECT_EQ(error_of(schedule, "distance>2"), "'distance>2': distances are known when a solve has ended");
  EXPECT_EQ(error_of(schedule, "area>2 nothing"), "");
  const Schedule early = make_schedule(rectangles({}, 0.0, false));
  EXPECT_EQ(error_of(early, "class:1"), "'class:1': classes are known when a solve has ended");
  EXPECT_EQ(cell_text(early, 0, Column::Class), "–");
}

TEST(ScheduleTest, SwitchesLeaveWhatTheySay) {
  const Schedule schedule = make_schedule(rectangles({.edge_min = 250.0}));
  std::vector<bool> selected(12, false);
  selected[1] = selected[5] = true;
  EXPECT_EQ(names(schedule, {.only_failing = true}), (Names{"1", "2", "12"}));
  EXPECT_EQ(names(schedule, {.only_selected = true}, selected), (Names{"2", "6"}));
  EXPECT_EQ(names(schedule, {.only_selected = true, .only_failing = true}, selected), (Names{"2"}));
  EXPECT_EQ(names(schedule, {.only_selected = true}), Names());
}

TEST(ScheduleTest, SumsUpWhatIsListed) {
  const Schedule schedule = make_schedule(rectangles({}, 2500.0));
  const auto list = make_schedule_list(schedule, {.filter = "class:1"}, {});
  EXPECT_NEAR(list.area, 0.2, 1e-9);
  ASSERT_TRUE(list.weight.has_value());
  EXPECT_NEAR(*list.weight, 5.0, 1e-9);
  EXPECT_EQ(sum_text(schedule, list), "2 of 12 panels  ·  0.2 m²  ·  5 kg  ·  1 class");
  const Schedule weightless = make_schedule(rectangles());
  EXPECT_EQ(sum_text(weightless, make_schedule_list(weightless, {}, {})),
            "12 panels  ·  6.7 m²  ·  11 classes");
}

TEST(ScheduleTest, CopiesWhatIsListedForASpreadsheet) {
  const Schedule schedule = make_schedule(rectangles({.edge_min = 250.0}));
  const auto list = make_schedule_list(schedule, {.sort = Column::Area, .filter = "area<0.25"}, {});
  std::istringstream lines(copied_text(schedule, list));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line,
            "name\tcorners\tarea_m2\tedge_min_mm\tedge_max_mm\tinterior_min_deg\tbevel_max_deg\tplanarity_mm"
            "\tdistance_mm\twidth_mm\theight_mm\tclass\tverdict");
  std::getline(lines, line);
  EXPECT_EQ(line, "1\t4\t0.1\t100\t1000\t90\t0\t0\t\t1000\t100\t1\tedge length 100 < 250 mm, and 1 more");
  int rows = 1;
  while (std::getline(lines, line)) ++rows;
  EXPECT_EQ(rows, 3);
  const Schedule heavy = make_schedule(rectangles({}, 2500.0));
  EXPECT_NE(copied_text(heavy, make_schedule_list(heavy, {}, {})).find("\tweight_kg\t"), std::string::npos);
}

TEST(ScheduleTest, NothingIsKnownOfNothing) {
  const Schedule schedule = make_schedule(nullptr);
  EXPECT_EQ(schedule.size(), 0);
  EXPECT_EQ(make_schedule_list(schedule, {.filter = "edgy<3"}, {}).size(), 0);
}

TEST(ScheduleTest, ColumnsAreFoundByTheirNames) {
  for (int c = 0; c < kScheduleColumns; ++c) {
    const auto column = static_cast<Column>(c);
    EXPECT_EQ(find_schedule_column(info(column).name), column) << c;
    EXPECT_FALSE(info(column).tooltip.empty()) << c;
  }
  EXPECT_EQ(find_schedule_column("colour"), std::nullopt);
}

TEST(ScheduleTest, TenThousandRowsAreMadeInAMoment) {
  WorkshopOptions options = in_unit(LengthUnit::Metre);
  const auto from = prepared(wall(100, 100), options, {}, 0.0, 0.0, false);
  const auto now = [] { return std::chrono::steady_clock::now(); };
  const auto ms = [](auto span) { return std::chrono::duration<double, std::milli>(span).count(); };
  const auto begin = now();
  const Schedule first = make_schedule(from);
  const auto made = now();
  const Schedule next = make_schedule(from, &first);  // of the next step of a solve
  const auto again = now();
  const auto list = make_schedule_list(next, {.sort = Column::Planarity, .filter = "A area>0.5"}, {});
  const auto listed = now();
  RecordProperty("first_ms", std::to_string(ms(made - begin)));
  std::cout << "first " << ms(made - begin) << " ms, next " << ms(again - made) << " ms, list "
            << ms(listed - again) << " ms\n";
  EXPECT_GT(list.size(), 0);
  for (int p = 0; p < next.size(); ++p) ASSERT_EQ(next.row(p).name_rank, first.row(p).name_rank);
  EXPECT_LT(ms(again - made), 100.0);
  EXPECT_LT(ms(listed - again), 100.0);
}

}  // namespace
}  // namespace planewright::ui
