#include "core/edit/project_panels.h"

#include <gtest/gtest.h>

#include "core/edit/document.h"
#include "support/projects.h"

namespace planewright {
namespace {

TEST(ProjectPanels, AreThoseOfTheLayerWithTheirNumbersAndNames) {
  Project project = test::busy_project();
  project.design.layers[2].name = "inner";
  const auto first = solved_panels(project, "");
  ASSERT_TRUE(first) << first.error().text();
  EXPECT_EQ(first->layer, 0);
  EXPECT_EQ(first->given_names, (std::vector<std::pair<int, std::string>>{{0, "A-1"}, {7, "B-2"}}));
  const auto inner = solved_panels(project, "inner");
  ASSERT_TRUE(inner) << inner.error().text();
  EXPECT_EQ(inner->layer, 2);
  EXPECT_EQ(inner->given_names, (std::vector<std::pair<int, std::string>>{{3, "A-1"}}));
  const auto complex = build_complex(project.mesh, project.design.layers[2].settings).value();
  EXPECT_EQ(inner->panels.points, panels_of(*complex, *project.solved[2]).points);
  ASSERT_EQ(inner->numbers.size(), complex->plane_origin.size());
  Document document;
  document.open_project(project);
  for (std::size_t i = 0; i < inner->numbers.size(); ++i)
    EXPECT_EQ(inner->numbers[i], document.panel_number(2, complex->plane_origin[i]));
}

TEST(ProjectPanels, SayWhatIsMissing) {
  const Project project = test::busy_project();
  const auto unknown = solved_panels(project, "attic");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::Usage);
  EXPECT_NE(unknown.error().text().find("outer \"skin\" é, panels, panels"), std::string::npos)
      << unknown.error().text();
  const auto unsolved = solved_panels(project, "panels");
  ASSERT_FALSE(unsolved);
  EXPECT_EQ(unsolved.error().code, ErrorCode::Refused);
  EXPECT_NE(unsolved.error().text().find("layer 'panels'"), std::string::npos) << unsolved.error().text();
}

}  // namespace
}  // namespace planewright
