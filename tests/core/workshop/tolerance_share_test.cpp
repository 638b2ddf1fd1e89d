// Shares of limits: 1 is the limit, and the verdict decides on which side of it a panel shows.
#include "core/workshop/tolerance_share.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/workshop_models.h"

namespace planewright {
namespace {

using namespace test;

// A cube of 100 mm: edges of 100 mm, faces of 0.01 m², corners of 90°, ridges of 270°.
struct Cube {
  WorkshopModel model = workshop_model(cube(), 100.0);
  std::vector<PanelPassport> passports = make_passports(model);
  Vector shares(const ToleranceSheet& sheet, std::optional<ToleranceKind> kind = {}) const {
    return tolerance_shares(passports, check_tolerances(model, passports, sheet), sheet, kind);
  }
};

ToleranceSheet nothing() {
  ToleranceSheet sheet;
  sheet.planarity.reset();
  return sheet;
}

TEST(ToleranceShare, IsThePartOfTheLimitThatIsUsedUp) {
  const Cube cube;
  const double edge =
      (cube.model.points.row(cube.model.edges[0].a) - cube.model.points.row(cube.model.edges[0].b)).norm();
  ToleranceSheet sheet = nothing();
  sheet.edge_max = 4.0 * edge;
  EXPECT_NEAR(cube.shares(sheet)[0], 0.25, 1e-9);
  sheet = nothing();
  sheet.edge_min = 0.5 * edge;
  EXPECT_NEAR(cube.shares(sheet)[0], 0.5, 1e-9);
  sheet.edge_min = 3.0 * edge;
  EXPECT_NEAR(cube.shares(sheet)[0], 3.0, 1e-9);
  sheet = nothing();
  sheet.area_max = 1e-6 * edge * edge / 1.5;
  EXPECT_NEAR(cube.shares(sheet)[0], 1.5, 1e-9);
  sheet = nothing();
  sheet.interior_max = 180.0;
  EXPECT_NEAR(cube.shares(sheet)[0], 0.5, 1e-9);
  sheet = nothing();
  sheet.dihedral_max = 360.0;
  EXPECT_NEAR(cube.shares(sheet)[0], 0.75, 1e-9);
  sheet = nothing();
  sheet.stock = SheetSize{2.0 * edge, 1.25 * edge};
  EXPECT_NEAR(cube.shares(sheet)[0], 0.8, 1e-9);
}

TEST(ToleranceShare, OfSeveralLimitsIsTheWorst) {
  const Cube cube;
  ToleranceSheet sheet = nothing();
  sheet.interior_max = 180.0;
  sheet.dihedral_max = 300.0;
  EXPECT_NEAR(cube.shares(sheet)[0], 0.9, 1e-9);
  EXPECT_NEAR(cube.shares(sheet, ToleranceKind::InteriorMax)[0], 0.5, 1e-9);
}

TEST(ToleranceShare, WithoutALimitThereIsNone) {
  const Cube cube;
  EXPECT_TRUE(std::isnan(cube.shares(nothing(), ToleranceKind::EdgeMax)[0]));
  EXPECT_FALSE(std::isnan(cube.shares(nothing())[0])) << "crossing itself is always looked at";
}

TEST(ToleranceShare, BreaksAtTheVerdictAlsoInSinglePrecision) {
  const Cube cube;
  const double edge =
      (cube.model.points.row(cube.model.edges[0].a) - cube.model.points.row(cube.model.edges[0].b)).norm();
  ToleranceSheet sheet = nothing();
  sheet.edge_max = edge;  // on the limit: passes
  EXPECT_LT(static_cast<float>(cube.shares(sheet)[0]), 1.0f);
  sheet.edge_max = edge * (1 - 1e-9);  // a share that rounds to 1
  EXPECT_GT(static_cast<float>(cube.shares(sheet)[0]), 1.0f);
}

TEST(ToleranceShare, KindsAreThoseOfTheSheet) {
  ToleranceSheet sheet;
  sheet.area_min = 1.0;
  EXPECT_EQ(limited_kinds(sheet),
            (std::vector{ToleranceKind::Planarity, ToleranceKind::AreaMin, ToleranceKind::CrossesItself}));
}

}  // namespace
}  // namespace planewright
