// The list of findings without a window: what is listed, which edges are flagged, and what is said of it.
#include "ui/finding_list.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ui/finding_text.h"

namespace planewright::ui {
namespace {

std::shared_ptr<PreparedFindings> three_findings() {
  auto findings = std::make_shared<PreparedFindings>();
  findings->diagnosis.solved = true;
  auto& list = findings->diagnosis.findings;
  list.push_back(make_finding(FindingKind::ClosePoints, {ElementKind::PanelEdge, 3}, 0.05, 0.15, 0.5));
  list.push_back(make_finding(FindingKind::IllDetermined, {ElementKind::Panel, 0}, 40, 10, 0.2));
  list.push_back(make_finding(FindingKind::IllDetermined, {ElementKind::Panel, 1}, 20, 10, 0.1));
  list[0].mesh_edges = {2};
  list[1].mesh_edges = {1, 2};
  list[2].mesh_edges = {4};
  list[2].place = {5, 0, 0};
  return findings;
}

TEST(FindingListTest, FlagsNoEdgeWhereNoEditHelps) {
  auto findings = three_findings();
  for (const auto kind : {FindingKind::NotConvex, FindingKind::TwistedBeam}) {
    for (Finding& finding : findings->diagnosis.findings) finding.kind = kind;
    const FindingList list = make_finding_list(findings, nullptr, nullptr, {});
    EXPECT_EQ(list.size(), 3);
    EXPECT_TRUE(list.flagged.empty());
  }
}

TEST(FindingListTest, FlagsEdgesWithTheWorstFirst) {
  const FindingList list = make_finding_list(three_findings(), nullptr, nullptr, {});
  EXPECT_EQ(list.size(), 3);
  ASSERT_EQ(list.flagged.size(), 3u);
  const FlaggedEdge* both = list.find_flagged(2);
  ASSERT_NE(both, nullptr);
  EXPECT_EQ(both->findings, (std::vector<int>{0, 1}));
  EXPECT_EQ(both->severity, list.finding(0).severity);
  EXPECT_EQ(list.find_flagged(3), nullptr);
}

TEST(FindingListTest, HiddenKindsAreCountedButNeitherListedNorFlagged) {
  HiddenFindings hidden;
  hidden.set(static_cast<std::size_t>(FindingKind::IllDetermined));
  const FindingList list = make_finding_list(three_findings(), nullptr, nullptr, hidden);
  EXPECT_EQ(list.size(), 1);
  EXPECT_EQ(list.count[static_cast<std::size_t>(FindingKind::IllDetermined)], 2);
  EXPECT_EQ(list.find_flagged(4), nullptr);
  EXPECT_EQ(list.row_of(0), 0);
  EXPECT_EQ(list.row_of(2), std::nullopt);
}

TEST(FindingListTest, FollowsEdgesThroughAnEdit) {
  const auto before = std::make_shared<const ElementIds>(ElementIds{{}, {0, 1, 2, 3, 4}, {}});
  const auto after = std::make_shared<const ElementIds>(ElementIds{{}, {4, 0, 2}, {}});
  const FindingList list = make_finding_list(three_findings(), before, after, {});
  ASSERT_EQ(list.flagged.size(), 2u);
  EXPECT_EQ(list.flagged[0].edge, 0) << "that had the index 4";
  EXPECT_EQ(list.flagged[1].edge, 2);
}

TEST(FindingListTest, KnowsAPlaceAgain) {
  const auto findings = three_findings();
  const FindingList list = make_finding_list(findings, nullptr, nullptr, {});
  Finding earlier = findings->diagnosis.findings[2];
  earlier.place.x() += 0.1;
  EXPECT_EQ(same_place(list, earlier, 0.5), 2);
  EXPECT_EQ(same_place(list, earlier, 0.05), std::nullopt);
  earlier.kind = FindingKind::FarPoint;
  EXPECT_EQ(same_place(list, earlier, 0.5), std::nullopt);
}

TEST(FindingListTest, PanelsHaveTheWorstThatTouchesThem) {
  TangentComplex complex;
  complex.anchors = Points::Zero(3, 3);
  const auto findings = three_findings()->diagnosis.findings;
  const std::vector<Finding> of_panels(findings.begin() + 1, findings.end());
  const Vector severity = panel_severity(complex, of_panels);
  EXPECT_EQ(severity[0], of_panels[0].severity);
  EXPECT_EQ(severity[1], of_panels[1].severity);
  EXPECT_TRUE(std::isnan(severity[2]));
  HiddenFindings hidden;
  hidden.set(static_cast<std::size_t>(FindingKind::IllDetermined));
  EXPECT_TRUE(std::isnan(panel_severity(complex, of_panels, hidden)[0]));
}

TEST(FindingTextTest, MeasuresAreInModelUnits) {
  EXPECT_EQ(measure_text(0.5, "edges", 3.0, "m"), "1.5 m");
  EXPECT_EQ(measure_text(2.0, "edges per degree", 0.5, "mm"), "1 mm/°");
  EXPECT_EQ(measure_text(2e6, "edges per degree", 0.5, "mm"), "not held");
  EXPECT_EQ(measure_text(12.0, "degrees", 3.0, "m"), "12°");
  EXPECT_EQ(measure_text(0.08, "of a full corner", 3.0, "m"), "8 %");
  EXPECT_EQ(limit_text(three_findings()->diagnosis.findings[0]), "0.05 edges, the limit is 0.15 edges");
}

TEST(FindingTextTest, SaysWhyThereIsNoList) {
  FindingsStanding standing;
  EXPECT_NE(why_no_findings(standing, "m").find("Not solved yet"), std::string::npos);
  standing.panels = true;
  EXPECT_NE(why_no_findings(standing, "m").find("Looking"), std::string::npos);
  Diagnosis diagnosis;
  diagnosis.off_planes = 0.1;
  standing.diagnosis = &diagnosis;
  standing.mean_edge = 2.0;
  standing.solving = true;
  EXPECT_EQ(why_no_findings(standing, "m"), "Not solved yet: corners lie up to 0.2 m off their planes.");
  standing.solving = false;
  standing.finished = true;
  EXPECT_NE(why_no_findings(standing, "m").find("Stopped before planar"), std::string::npos);
  diagnosis.solved = true;
  EXPECT_EQ(why_no_findings(standing, "m"), "");
}

}  // namespace
}  // namespace planewright::ui
