#include "core/workshop/workshop_model.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/panel_designs.h"

namespace planewright {
namespace {

TEST(WorkshopModel, MetresAndInchesBecomeMillimetresRoundTheMiddle) {
  const auto metres = model_of(cube(), in_unit(LengthUnit::Metre));
  EXPECT_EQ(Vector3d(metres->origin), Vector3d(500, 500, 500));
  EXPECT_EQ(Vector3d(metres->points.row(0)), Vector3d(-500, -500, -500));
  EXPECT_EQ(Vector3d(metres->points.row(6)), Vector3d(-500, 500, 500));
  const auto inches = model_of(cube(), in_unit(LengthUnit::Inch));
  EXPECT_NEAR((inches->points.row(1) - inches->points.row(0)).norm(), 25.4, 1e-14);
  EXPECT_EQ(inches->model_unit, LengthUnit::Inch);
}

TEST(WorkshopModel, FarFromZeroNoDigitIsLost) {
  PanelDesign far = cube();
  const Vector3d shift(4096000.0, -2048000.0, 1024.0);  // added without rounding
  far.points.rowwise() += shift.transpose();
  const auto here = model_of(cube()), there = model_of(far);
  for (int v = 0; v < 8; ++v)
    EXPECT_EQ(Vector3d(there->points.row(v).transpose() + there->origin - 1000.0 * shift),
              Vector3d(here->points.row(v).transpose() + here->origin));
  EXPECT_LT(there->points.cwiseAbs().maxCoeff(), 1000.0);
}

TEST(WorkshopModel, NormalsPointToNewellsSide) {
  const Points outward = model_of(cube())->normals, inward = model_of(cube(false))->normals;
  const Vector3d expected[6] = {-Vector3d::UnitZ(), Vector3d::UnitZ(),  -Vector3d::UnitY(),
                                Vector3d::UnitY(),  -Vector3d::UnitX(), Vector3d::UnitX()};
  for (int p = 0; p < 6; ++p) {
    EXPECT_LT((outward.row(p).transpose() - expected[p]).norm(), 1e-14) << p;
    EXPECT_LT((inward.row(p).transpose() + expected[p]).norm(), 1e-14) << p;
  }
  const auto model = model_of(cube());
  for (int p = 0; p < 6; ++p) EXPECT_NEAR(model->plane_offsets[p], 500.0, 1e-10) << p;
}

TEST(WorkshopModel, PlanesOfWarpedPanelsAreLeastSquares) {
  PanelDesign saddle = flat_panels({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  for (int v = 0; v < 4; ++v) saddle.points(v, 2) = v % 2 == 0 ? 7.1 : 6.9;
  const auto model = model_of(saddle, in_unit(LengthUnit::Millimetre));
  EXPECT_LT((model->normals.row(0) - Eigen::RowVector3d(0, 0, 1)).norm(), 1e-14);
  EXPECT_NEAR(model->plane_offsets[0] + model->origin.z(), 7.0, 1e-14);
}

TEST(WorkshopModel, APanelWithoutAreaTakesItsNeighboursNormal) {
  // A needle on the line between two squares of one plane: corners 1, 2 and one on their line.
  PanelDesign design;
  design.points.resize(5, 3);
  design.points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 2, 0;
  design.panels.push_back(std::array{0, 1, 2, 3});
  design.panels.push_back(std::array{2, 1, 4});
  const auto model = model_of(design);
  EXPECT_EQ(Vector3d(model->normals.row(1)), Vector3d(model->normals.row(0)));
}

TEST(WorkshopModel, SidesKnowTheirNeighbours) {
  const auto model = model_of(cube());
  EXPECT_EQ(model->edges.size(), 12u);
  EXPECT_TRUE(model->warnings.empty());
  // Below, 0 2 3 1: left, back, right, front.
  EXPECT_EQ(model->neighbour(0, 0), 4);
  EXPECT_EQ(model->neighbour(0, 1), 3);
  EXPECT_EQ(model->neighbour(0, 2), 5);
  EXPECT_EQ(model->neighbour(0, 3), 2);
  for (const WorkshopEdge& edge : model->edges) {
    ASSERT_FALSE(edge.border());
    const auto left = model->panels[edge.left], right = model->panels[edge.right];
    EXPECT_EQ(left[static_cast<size_t>(edge.left_side)], edge.a);
    EXPECT_EQ(left[static_cast<size_t>(edge.left_side + 1) % 4], edge.b);
    EXPECT_EQ(right[static_cast<size_t>(edge.right_side)], edge.b);
    EXPECT_EQ(right[static_cast<size_t>(edge.right_side + 1) % 4], edge.a);
    EXPECT_EQ(&model->edges[static_cast<size_t>(
                  model->edges_of_panel[edge.right][static_cast<size_t>(edge.right_side)])],
              &edge);
  }
}

TEST(WorkshopModel, BordersHaveNoNeighbour) {
  const auto model = model_of(wall(1, 2));
  EXPECT_EQ(model->edges.size(), 7u);
  EXPECT_EQ(model->neighbour(0, 0), -1);
  EXPECT_EQ(model->neighbour(0, 1), 1);
  EXPECT_EQ(model->neighbour(1, 3), 0);
  EXPECT_EQ(model->neighbour(1, 1), -1);
}

TEST(WorkshopModel, AnEdgeOfThreePanelsIsBorderOfEachWithAWarning) {
  PanelDesign design;
  design.points.resize(5, 3);
  design.points << 0, 0, 0, 0, 0, 1, 1, 0, 0, -1, 1, 0, -1, -1, 0;
  design.panels.push_back(std::array{0, 1, 2});
  design.panels.push_back(std::array{1, 0, 3});
  design.panels.push_back(std::array{0, 1, 4});
  const auto model = model_of(design);
  EXPECT_EQ(model->edges.size(), 9u);
  for (int p = 0; p < 3; ++p) EXPECT_EQ(model->neighbour(p, 0), -1);
  ASSERT_EQ(model->warnings.size(), 1u);
  EXPECT_NE(model->warnings[0].find("more than two panels"), std::string::npos);
  for (const std::string& name : model->names)
    EXPECT_NE(model->warnings[0].find(name + " (side 1)"), std::string::npos) << model->warnings[0];
}

TEST(WorkshopModel, PanelsThatRunTheSameWayAreNoNeighbours) {
  PanelDesign design = wall(1, 2);
  design.panels = {{0, 1, 4, 3}, {1, 4, 5, 2}};  // the second from inside
  const auto model = model_of(design);
  EXPECT_EQ(model->neighbour(0, 1), -1);
  EXPECT_EQ(model->neighbour(1, 0), -1);
  ASSERT_EQ(model->warnings.size(), 1u);
  EXPECT_NE(model->warnings[0].find("different sides"), std::string::npos);
}

TEST(WorkshopModel, UpIsMadeUnit) {
  WorkshopOptions options;
  options.up = Vector3d(0, 5, 0);
  EXPECT_EQ(model_of(cube(), options)->up, Vector3d(Vector3d::UnitY()));
}

struct Refusal {
  const char* what;
  std::function<void(PanelDesign&, WorkshopOptions&)> spoil;
  std::vector<std::string> says;
};

TEST(WorkshopModel, BadInputIsRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Refusal> refusals{
      {"none", [](auto& d, auto&) { d.panels = {}; }, {"there are no panels"}},
      {"two corners",
       [](auto& d, auto&) {
         d.panels.push_back(std::array{0, 1});
       },
       {"panel 6", "three corners", "has 2"}},
      {"twice", [](auto& d, auto&) { d.panels[4][2] = 0; }, {"panel 4", "corner 0 twice"}},
      {"missing corner", [](auto& d, auto&) { d.panels[3][0] = 8; }, {"panel 3", "corner 8 does not exist"}},
      {"negative corner",
       [](auto& d, auto&) { d.panels[3][0] = -1; },
       {"panel 3", "corner -1 does not exist"}},
      {"nan", [nan](auto& d, auto&) { d.points(7, 1) = nan; }, {"panel 1", "corner 7", "not a finite"}},
      {"huge", [](auto& d, auto&) { d.points(7, 1) = 1e98; }, {"panel 1", "corner 7", "1e100 mm"}},
      {"up", [](auto&, auto& o) { o.up.setZero(); }, {"up"}},
      {"count",
       [](auto&, auto& o) {
         o.numbers = {1, 2};
       },
       {"2 panel numbers for 6 panels"}},
      {"number twice", [](auto&, auto& o) { o.numbers = {1, 2, 3, 4, 5, 2}; }, {"panel 2", "same number"}},
      {"numbers",
       [](auto& d, auto& o) {
         o.numbers = {10, 11, 12, 13, 14, 15};
         d.panels[4][2] = 0;
       },
       {"panel 14"}},
      {"clash",
       [](auto&, auto& o) {
         o.kept_names = {{1, "N-1"}, {4, "N-1"}};
       },
       {"panel 4", "panel 1", "'N-1'"}},
      {"clash of case",
       [](auto&, auto& o) {
         o.kept_names = {{1, "N-1"}, {4, "n-1"}};
       },
       {"panel 4", "panel 1"}},
      {"letters",
       [](auto&, auto& o) {
         o.kept_names = {{3, "A 1"}};
       },
       {"panel 3", "'A 1'"}},
      {"umlaut",
       [](auto&, auto& o) {
         o.kept_names = {{3, "Ä-1"}};
       },
       {"panel 3", "'Ä-1'"}},
      {"empty",
       [](auto&, auto& o) {
         o.kept_names = {{3, ""}};
       },
       {"panel 3", "empty"}},
      {"two names",
       [](auto&, auto& o) {
         o.kept_names = {{3, "A"}, {3, "B"}};
       },
       {"panel 3", "'A' and 'B'"}},
  };
  for (const Refusal& refusal : refusals) {
    PanelDesign design = cube();
    WorkshopOptions options;
    refusal.spoil(design, options);
    const auto model = make_workshop_model(design.points, design.panels, options);
    ASSERT_FALSE(model) << refusal.what;
    EXPECT_EQ(model.error().code, ErrorCode::Refused) << refusal.what;
    for (const std::string& said : refusal.says)
      EXPECT_NE(model.error().text().find(said), std::string::npos)
          << refusal.what << ": " << model.error().text();
  }
}

}  // namespace
}  // namespace planewright
