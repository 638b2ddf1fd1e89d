#include "core/problem/demands/demand_catalogue.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

TEST(DemandCatalogue, NamesEveryDemandOnce) {
  std::set<std::string> names;
  for (const DemandInfo& info : demand_catalogue()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(find_demand(info.name).value(), &info);
    EXPECT_FALSE(info.label.empty());
    EXPECT_FALSE(info.description.empty());
    EXPECT_TRUE(info.for_dual || info.for_planarize);
  }
  for (const char* name :
       {"vertex", "face", "edge", "offset-band", "height-band", "prism", "on-plane", "border"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Problem, RefusesUnknownDemandsAndNamesTheKnownOnes) {
  const auto problem = Problem::create(dual_of(cube().mesh()), demanding({demand("vertices")}));
  ASSERT_FALSE(problem);
  EXPECT_EQ(problem.error().code, ErrorCode::Usage);
  EXPECT_NE(problem.error().what.find("'vertices'"), std::string::npos);
  for (const DemandInfo& info : demand_catalogue())
    EXPECT_NE(problem.error().remedy.find(info.name), std::string::npos) << info.name;
}

TEST(Problem, RefusesUnknownSelectionsAndNamesTheKnownOnes) {
  const auto problem = Problem::create(
      dual_of(cube().mesh()),
      demanding({demand("vertex", {}, "rooof")}, {{"roof", {}, {}, {1}}, {"floor", {}, {}, {0}}}));
  ASSERT_FALSE(problem);
  EXPECT_EQ(problem.error().code, ErrorCode::Usage);
  for (const char* word : {"'rooof'", "'vertex'", "roof", "floor"})
    EXPECT_NE(problem.error().text().find(word), std::string::npos) << problem.error().text();
}

TEST(Problem, RefusesValuesThatAreNoneOrTooMany) {
  for (const std::vector<double>& values :
       {std::vector{0.1, 0.2, 0.3}, std::vector{std::numeric_limits<double>::quiet_NaN()}}) {
    const auto problem = Problem::create(dual_of(cube().mesh()), demanding({demand("offset-band", values)}));
    ASSERT_FALSE(problem);
    EXPECT_EQ(problem.error().code, ErrorCode::Usage);
    EXPECT_NE(problem.error().what.find("offset-band"), std::string::npos);
  }
}

TEST(Problem, LeavesOutDemandsThatAreOff) {
  Demand off = demand("vertex");
  off.on = false;
  EXPECT_TRUE(rows_of(*Problem::create(dual_of(cube().mesh()), demanding({off})).value(), "vertex").empty());
}

TEST(SelectedElements, OfADual) {
  const PolygonMesh mesh = domed_triangle_grid(4, 3).mesh();
  const SharedComplex complex = dual_of(mesh);
  int border = 0;
  while (!mesh.edge(border).border()) ++border;
  const Selection selection{"some", {0}, {border}, {5}};
  const SelectedElements found = selected_elements(*complex, &selection);
  const auto panel = complex->panels[0];
  for (int j = 0; j < complex->point_count(); ++j) {
    const PointOrigin& origin = complex->point_origin[j];
    const bool wanted = std::find(panel.begin(), panel.end(), j) != panel.end() ||
                        origin == PointOrigin{PointKind::Face, 5} ||
                        origin == PointOrigin{PointKind::BorderEdge, border};
    EXPECT_EQ(found.points[j] != 0, wanted) << j;
  }
  for (int i = 0; i < complex->plane_count(); ++i) EXPECT_EQ(found.panels[i] != 0, i == 0);
}

TEST(SelectedElements, WhenPlanarizing) {
  const PolygonMesh mesh = grid(3, 2).mesh();
  const SharedComplex complex = planarize_of(mesh);
  // An edge means both its ends; the face all of whose corners are named is in.
  const Selection edges{"edges", {}, {mesh.find_edge(0, 1), mesh.find_edge(4, 5)}, {}};
  const SelectedElements ends = selected_elements(*complex, &edges);
  for (int v = 0; v < 12; ++v) EXPECT_EQ(ends.points[v] != 0, v == 0 || v == 1 || v == 4 || v == 5);
  for (int f = 0; f < 6; ++f) EXPECT_EQ(ends.panels[f] != 0, f == 0);
  const Selection face{"face", {}, {}, {5}};
  const SelectedElements corners = selected_elements(*complex, &face);
  for (int v = 0; v < 12; ++v) EXPECT_EQ(corners.points[v] != 0, v == 6 || v == 7 || v == 10 || v == 11);
  const SelectedElements all = selected_elements(*complex, nullptr);
  EXPECT_TRUE(std::all_of(all.points.begin(), all.points.end(), [](char c) { return c != 0; }));
  EXPECT_TRUE(std::all_of(all.panels.begin(), all.panels.end(), [](char c) { return c != 0; }));
}

}  // namespace
}  // namespace planewright
