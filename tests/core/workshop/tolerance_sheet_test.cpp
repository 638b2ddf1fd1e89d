#include "core/workshop/tolerance_sheet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/panel_designs.h"

namespace planewright {
namespace {

ToleranceSheet nothing() {
  ToleranceSheet sheet;
  sheet.planarity.reset();
  return sheet;
}

ToleranceVerdicts verdicts_of(const WorkshopModel& model, const ToleranceSheet& sheet,
                              const PassportOptions& options = {}) {
  return check_tolerances(model, make_passports(model, options), sheet);
}

// In mm: a rectangle of 500 x 300, turned in its plane, and one square to it over its side of 500, both well
// off 0; a third by itself is warped by exactly 0.5.
PanelDesign exact_panels(const Vector3d& shift) {
  PanelDesign design;
  design.points.resize(10, 3);
  // 500 = |(300, 400)|, 300 = |(-240, 180)|
  design.points << 0, 0, 0, 300, 400, 0, 60, 580, 0, -240, 180, 0, 300, 400, -300, 0, 0, -300,  //
      2000, 0, 0.5, 2400, 0, -0.5, 2400, 400, 0.5, 2000, 400, -0.5;
  design.points.rowwise() += shift.transpose();
  design.panels = {{0, 1, 2, 3}, {1, 0, 5, 4}, {6, 7, 8, 9}};
  return design;
}

TEST(ToleranceSheet, AMeasureOnTheLimitPassesInEveryUnit) {
  ToleranceSheet on = nothing();
  on.planarity = 0.5;
  on.edge_min = 300.0;
  on.edge_max = 500.0;
  on.area_min = 0.15;
  on.interior_min = on.interior_max = 90.0;
  on.dihedral_min = on.dihedral_max = 270.0;
  on.stock = SheetSize{300.0, 500.0};
  for (const Vector3d& shift : {Vector3d(0, 0, 0), Vector3d(123.4, -77.7, 3.1), Vector3d(1.2e7, -3.3e6, 1e5)})
    for (const LengthUnit unit : length_units()) {
      PanelDesign two = exact_panels(shift);
      two.panels = {{0, 1, 2, 3}, {1, 0, 5, 4}};
      const auto model = model_of(converted(two, unit), in_unit(unit));
      const auto where = std::string(symbol(unit)) + " at " + std::to_string(shift.norm());
      const auto pass = verdicts_of(*model, on);
      EXPECT_EQ(pass.passed, 2) << where;
      for (const auto& failure : pass.failures) ADD_FAILURE() << where << ": " << describe(failure, *model);

      // A millionth beyond, each fails.
      const double off = 1e-6;
      const auto failures = [&](auto change) {
        ToleranceSheet sheet = nothing();
        change(sheet);
        return verdicts_of(*model, sheet).failures.size();
      };
      EXPECT_EQ(failures([&](auto& s) { s.edge_min = 300.0 + off; }), 4u) << where;
      EXPECT_EQ(failures([&](auto& s) { s.edge_max = 500.0 - off; }), 4u) << where;
      EXPECT_EQ(failures([&](auto& s) { s.area_min = 0.15 + 1e-9; }), 2u) << where;
      EXPECT_EQ(failures([&](auto& s) { s.area_max = 0.15 - 1e-9; }), 2u) << where;
      EXPECT_EQ(failures([&](auto& s) { s.interior_min = 90.0 + 1e-5; }), 8u) << where;
      EXPECT_EQ(failures([&](auto& s) { s.interior_max = 90.0 - 1e-5; }), 8u) << where;
      EXPECT_EQ(failures([&](auto& s) { s.dihedral_min = 270.0 + 1e-5; }), 2u) << where;
      EXPECT_EQ(failures([&](auto& s) { s.dihedral_max = 270.0 - 1e-5; }), 2u) << where;
      EXPECT_EQ(failures([&](auto& s) { s.stock = SheetSize{500.0 - off, 300.0}; }), 2u) << where;
    }
}

TEST(ToleranceSheet, PlanarityAndDistanceOnTheLimitPassInEveryUnit) {
  for (const LengthUnit unit : length_units()) {
    PanelDesign warped = exact_panels(Vector3d(10, 20, 30));
    warped.panels = {{6, 7, 8, 9}};
    Points ground(4, 3);
    ground << -9e4, -9e4, 0, 9e4, -9e4, 0, 9e4, 9e4, 0, -9e4, 9e4, 0;
    const auto reference =
        ReferenceSurface::create(ground / millimetres_per(unit), {{0, 1, 2, 3}}, "ground").value();
    PassportOptions options;
    options.reference = reference.get();
    const auto model = model_of(converted(warped, unit), in_unit(unit));
    ToleranceSheet sheet = nothing();
    sheet.planarity = 0.5;
    sheet.distance = 30.5;
    EXPECT_EQ(verdicts_of(*model, sheet, options).passed, 1) << symbol(unit);
    sheet.planarity = 0.5 - 1e-9;
    sheet.distance = 30.5 - 1e-9;
    const auto failures = verdicts_of(*model, sheet, options).failures;
    ASSERT_EQ(failures.size(), 2u) << symbol(unit);
    EXPECT_EQ(failures[0].kind, ToleranceKind::Planarity);
    EXPECT_EQ(failures[1].kind, ToleranceKind::Distance);
    EXPECT_NEAR(failures[1].measured, 30.5, 1e-9);
  }
}

TEST(ToleranceSheet, FlatPanelsPassAPlanarityOfNothing) {
  ToleranceSheet sheet;
  sheet.planarity = 0.0;
  EXPECT_EQ(verdicts_of(*model_of(cube()), sheet).failed, 0);
}

TEST(ToleranceSheet, FailuresComeByPanelKindAndSide) {
  // A strip of 1 x 1, then 2 x 1 (m).
  PanelDesign strip = flat_panels({});
  strip.points.resize(6, 3);
  strip.points << 0, 0, 0, 1, 0, 0, 3, 0, 0, 3, 1, 0, 1, 1, 0, 0, 1, 0;
  strip.panels = {{0, 1, 4, 5}, {1, 2, 3, 4}};
  const auto model = model_of(strip);
  ToleranceSheet sheet = nothing();
  sheet.edge_min = 1500.0;
  sheet.edge_max = 1800.0;
  sheet.area_max = 1.5;
  const auto verdicts = verdicts_of(*model, sheet);
  const std::vector<std::tuple<int, ToleranceKind, int>> expected{
      {0, ToleranceKind::EdgeMin, 0}, {0, ToleranceKind::EdgeMin, 1}, {0, ToleranceKind::EdgeMin, 2},
      {0, ToleranceKind::EdgeMin, 3}, {1, ToleranceKind::EdgeMin, 1}, {1, ToleranceKind::EdgeMin, 3},
      {1, ToleranceKind::EdgeMax, 0}, {1, ToleranceKind::EdgeMax, 2}, {1, ToleranceKind::AreaMax, -1}};
  std::vector<std::tuple<int, ToleranceKind, int>> found;
  for (const auto& f : verdicts.failures) found.emplace_back(f.panel, f.kind, f.side);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(verdicts.passed, 0);
  EXPECT_EQ(verdicts.failed, 2);
  EXPECT_NEAR(verdicts.failures.back().measured, 2.0, 1e-12);
  EXPECT_EQ(verdicts.failures.back().limit, 1.5);
  EXPECT_EQ(describe(verdicts.failures[1], *model),
            "A-1, side 2 (to A-2): edge length 1000 mm is below 1500 mm");
  EXPECT_EQ(describe(verdicts.failures[6], *model),
            "A-2, side 1 (border): edge length 2000 mm is above 1800 mm");
  EXPECT_EQ(describe(verdicts.failures[8], *model), "A-2: area 2 m² is above 1.5 m²");
}

TEST(ToleranceSheet, BordersHaveNoDihedralAngle) {
  ToleranceSheet sheet = nothing();
  sheet.dihedral_min = 200.0;
  EXPECT_EQ(verdicts_of(*model_of(wall(1, 1)), sheet).failed, 0);
  EXPECT_EQ(verdicts_of(*model_of(wall(1, 2)), sheet).failures.size(), 2u);  // the joint, from both sides
}

TEST(ToleranceSheet, WordsTellMeasureAndLimitApart) {
  const auto model = model_of(wall(1, 2));
  EXPECT_EQ(describe({1, ToleranceKind::EdgeMax, 3, 500.0004, 500.0}, *model),
            "A-2, side 4 (to A-1): edge length 500.0004 mm is above 500 mm");
  EXPECT_EQ(describe({0, ToleranceKind::InteriorMin, 2, 12.3, 30.0}, *model),
            "A-1, corner 3: interior angle 12.3° is below 30°");
  EXPECT_EQ(describe({0, ToleranceKind::Planarity, -1, 0.75, 0.5}, *model),
            "A-1: planarity 0.75 mm is above 0.5 mm");
  EXPECT_EQ(describe({0, ToleranceKind::CrossesItself, -1, 1.0, 0.0}, *model),
            "A-1: its outline crosses itself");
  EXPECT_NE(describe({0, ToleranceKind::StockSize, -1, 6400.0, 6000.0}, *model)
                .find("6400 mm where the stock has 6000 mm"),
            std::string::npos);
}

TEST(ToleranceSheet, TheStockSideThatIsTooSmallIsNamed) {
  const auto model =
      model_of(flat_panels({{{0, 0}, {7, 0}, {7, 2}, {0, 2}}, {{0, 3}, {5, 3}, {5, 7}, {0, 7}}}));
  ToleranceSheet sheet = nothing();
  sheet.stock = SheetSize{3210.0, 6000.0};
  const auto failures = verdicts_of(*model, sheet).failures;
  ASSERT_EQ(failures.size(), 2u);
  EXPECT_NEAR(failures[0].measured, 7000.0, 1e-9);
  EXPECT_EQ(failures[0].limit, 6000.0);
  EXPECT_NEAR(failures[1].measured, 4000.0, 1e-9);
  EXPECT_EQ(failures[1].limit, 3210.0);
}

TEST(ToleranceSheet, NoPanelMayCrossItself) {
  const auto model =
      model_of(flat_panels({{{0, 0}, {2, 0}, {0, 1}, {2, 2}}, {{5, 0}, {6, 0}, {6, 1}, {5, 1}}}));
  const auto verdicts = verdicts_of(*model, nothing());
  ASSERT_EQ(verdicts.failures.size(), 1u);
  EXPECT_EQ(verdicts.failures[0].kind, ToleranceKind::CrossesItself);
  EXPECT_EQ(verdicts.pass, (std::vector<bool>{false, true}));
}

TEST(ToleranceFile, ASheetReadsBackAsItWas) {
  ToleranceSheet sheet;
  EXPECT_EQ(read_tolerance_sheet(to_json(sheet), "t").value(), sheet);
  EXPECT_EQ(read_tolerance_sheet(to_json(nothing()), "t").value(), nothing());
  sheet = {0.1 + 0.2, 3.0, 50.0, 2500.0, 0.01, 4.0, 30.0, 200.0, 90.5, 270.0, SheetSize{3210.0, 6000.0}};
  EXPECT_EQ(read_tolerance_sheet(to_json(sheet), "t").value(), sheet);
}

TEST(ToleranceFile, KeysSayTheirUnit) {
  const auto sheet = read_tolerance_sheet(
      R"({"format": "planewright tolerances", "version": 1, "edge_min_mm": 50, "area_max_m2": 4.5,
          "dihedral_max_deg": 270, "stock_mm": [3210, 6000]})",
      "site.json");
  ASSERT_TRUE(sheet) << sheet.error().text();
  ToleranceSheet expected = nothing();
  expected.edge_min = 50.0;
  expected.area_max = 4.5;
  expected.dihedral_max = 270.0;
  expected.stock = SheetSize{3210.0, 6000.0};
  EXPECT_EQ(*sheet, expected);
}

TEST(ToleranceFile, BadSheetsAreRefusedByKey) {
  const auto with = [](const std::string& rest) {
    return R"({"format": "planewright tolerances", "version": 1, )" + rest + "}";
  };
  const std::vector<std::pair<std::string, std::vector<std::string>>> bad{
      {"", {"no JSON"}},
      {"{\n\"format\": oops}", {"no JSON", "line 2"}},
      {"[1]", {"one JSON object"}},
      {"{}", {"'format'", "no tolerance sheet"}},
      {R"({"format": "planewright tolerances"})", {"'version'"}},
      {with(R"("edge_mim_mm": 5)"), {"'edge_mim_mm'", "nearest is 'edge_min_mm'"}},
      {with(R"("planarity": 5)"), {"'planarity'", "nearest is 'planarity_mm'"}},
      {with(R"("edge_min_mm": 5, "edge_min_mm": 6)"), {"'edge_min_mm'", "twice"}},
      {with(R"("edge_min_mm": "5")"), {"'edge_min_mm'", "no number"}},
      {with(R"("edge_min_mm": null)"), {"'edge_min_mm'", "no number", "Leave the key out"}},
      {with(R"("edge_min_mm": -5)"), {"'edge_min_mm'", "-5 is negative"}},
      {with(R"("edge_min_mm": 1e999)"), {"no JSON"}},
      {with(R"("edge_min_mm": 6, "edge_max_mm": 5)"),
       {"'edge_min_mm'", "above the maximum", "'edge_max_mm'"}},
      {with(R"("dihedral_min_deg": 6, "dihedral_max_deg": 5)"), {"'dihedral_min_deg'", "above the maximum"}},
      {with(R"("interior_max_deg": 361)"), {"'interior_max_deg'", "361", "360"}},
      {with(R"("stock_mm": 5)"), {"'stock_mm'", "two lengths"}},
      {with(R"("stock_mm": [5, 6, 7])"), {"'stock_mm'", "two lengths"}},
      {with(R"("stock_mm": [5, 0])"), {"'stock_mm'", "height"}},
  };
  for (const auto& [text, says] : bad) {
    const auto sheet = read_tolerance_sheet(text, "site.json");
    ASSERT_FALSE(sheet) << text;
    EXPECT_EQ(sheet.error().code, ErrorCode::Unreadable);
    EXPECT_EQ(sheet.error().text().find("site.json"), 0u) << sheet.error().text();
    for (const std::string& said : says)
      EXPECT_NE(sheet.error().text().find(said), std::string::npos) << text << " -> " << sheet.error().text();
  }
}

}  // namespace
}  // namespace planewright
