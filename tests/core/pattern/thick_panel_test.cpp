#include "core/pattern/thick_panel.h"

#include <gtest/gtest.h>

#include <ctime>
#include <set>

#include "core/mesh/triangulate.h"
#include "support/workshop_models.h"

namespace planewright {
namespace {

using namespace test;

ThickPanels thick(const WorkshopModel& model, double thickness, double gap = 0.0) {
  return thicken(model, {thickness, gap}).value();
}

double volume(const ThickPanel& solid) {
  double six = 0.0;
  const Vector3d from = solid.points.row(0);
  for (int f = 0; f < solid.faces.size(); ++f)
    for (const auto& [a, b, c] : triangulate(solid.points, solid.faces[f]))
      six += (solid.points.row(a).transpose() - from)
                 .dot((solid.points.row(b).transpose() - from)
                          .cross(Vector3d(solid.points.row(c).transpose() - from)));
  return six / 6;
}

double area(const WorkshopModel& model, int panel) {
  return newell_vector(model.points, model.panels[panel]).norm() / 2;
}

// Each directed edge once and its reverse once, every point used, faces planar, volume positive.
void expect_closed(const ThickPanel& solid, const std::string& name) {
  ASSERT_FALSE(solid.empty()) << name;
  ASSERT_EQ(static_cast<int>(solid.side_of_face.size()), solid.faces.size()) << name;
  std::set<std::pair<int, int>> directed;
  std::set<int> used;
  const double size = bounding_diagonal(solid.points);
  for (int f = 0; f < solid.faces.size(); ++f) {
    const auto face = solid.faces[f];
    ASSERT_GE(face.size(), 3u) << name;
    const Vector3d normal = newell_vector(solid.points, face).normalized();
    for (size_t k = 0; k < face.size(); ++k) {
      EXPECT_TRUE(directed.insert({face[k], face[(k + 1) % face.size()]}).second) << name << " face " << f;
      used.insert(face[k]);
      const Vector3d from_first = (solid.points.row(face[k]) - solid.points.row(face[0])).transpose();
      EXPECT_NEAR(normal.dot(from_first), 0.0, 1e-9 * size) << name << " face " << f;
    }
  }
  for (const auto& [a, b] : directed) EXPECT_TRUE(directed.contains({b, a})) << name;
  EXPECT_EQ(static_cast<Eigen::Index>(used.size()), solid.points.rows()) << name;
  EXPECT_GT(volume(solid), 0.0) << name;
}

void expect_all_closed(const WorkshopModel& model, const ThickPanels& solids) {
  ASSERT_EQ(static_cast<int>(solids.panels.size()), model.panel_count());
  for (int i = 0; i < model.panel_count(); ++i) {
    EXPECT_EQ(solids.panels[i].panel, i);
    expect_closed(solids.panels[i], model.names[i]);
  }
}

int count(const ThickPanels& solids, ThicknessTrouble trouble) {
  int n = 0;
  for (const ThicknessFinding& finding : solids.findings) n += finding.trouble == trouble;
  return n;
}

TEST(ThickPanel, OfACubeIsAFrustumAndAllFillTheShell) {
  const WorkshopModel model = workshop_model(cube(), 1000.0);
  const ThickPanels solids = thick(model, 100.0);
  EXPECT_TRUE(solids.findings.empty());
  expect_all_closed(model, solids);
  for (const ThickPanel& solid : solids.panels) {
    EXPECT_EQ(solid.outer, 4);
    ASSERT_EQ(solid.faces.size(), 6);
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(solid.points.row(k), model.points.row(model.panels[solid.panel][k])) << "bit for bit";
      // The inner corner of a cube lies on its diagonal.
      const Vector3d corner = solid.points.row(k), inner = solid.points.row(4 + k);
      const Vector3d middle = Vector3d::Constant(500.0);
      EXPECT_NEAR((corner + (middle - corner) * 0.2 - inner).norm(), 0.0, 1e-10);
    }
    EXPECT_NEAR(volume(solid), (1e9 - 8e8 * 0.64) / 6, 1e-3);
  }
  EXPECT_EQ(solids.panels[1].side_of_face, (std::vector<int>{-1, -1, 0, 1, 2, 3}));
  EXPECT_TRUE(penetrating_solids(solids).empty());
}

// The side face k contains the panel's side k.
TEST(ThickPanel, SideFacesBelongToTheirSides) {
  const WorkshopModel model = workshop_model(dodecahedron(), 500.0);
  const ThickPanels solids = thick(model, 20.0);
  for (const ThickPanel& solid : solids.panels)
    for (int f = 2; f < solid.faces.size(); ++f) {
      const int side = solid.side_of_face[f];
      const std::set<int> corners(solid.faces[f].begin(), solid.faces[f].end());
      EXPECT_TRUE(corners.contains(side)) << f;
      EXPECT_TRUE(corners.contains((side + 1) % 5)) << f;
    }
}

TEST(ThickPanel, BordersAreSquare) {
  const WorkshopModel model = workshop_model(grid(1, 1), 1000.0);
  const ThickPanels solids = thick(model, 30.0, 8.0);
  expect_all_closed(model, solids);
  EXPECT_NEAR(volume(solids.panels[0]), 3e7, 1e-4);
  for (int k = 0; k < 4; ++k) {
    const Vector3d down = (solids.panels[0].points.row(4 + k) - solids.panels[0].points.row(k)).transpose();
    EXPECT_NEAR((down - Vector3d(0, 0, -30)).norm(), 0.0, 1e-10);
  }
}

TEST(ThickPanel, TheGapPartsFlatNeighboursByItsWidth) {
  const WorkshopModel model = workshop_model(grid(2, 1), 1000.0);
  const ThickPanels solids = thick(model, 30.0, 8.0);
  expect_all_closed(model, solids);
  EXPECT_NEAR(solids.panels[0].points.col(0).maxCoeff(), 996.0, 1e-10);
  EXPECT_NEAR(solids.panels[0].points.col(0).minCoeff(), 0.0, 1e-10);
  EXPECT_NEAR(solids.panels[1].points.col(0).minCoeff(), 1004.0, 1e-10);
  EXPECT_NEAR(volume(solids.panels[0]), 996.0 * 1000.0 * 30.0, 1e-4);
}

// Square to the mitre plane, whatever the fold: side faces of neighbours are `gap` apart.
TEST(ThickPanel, TheGapIsSquareToTheMitre) {
  const WorkshopModel model = workshop_model(dodecahedron(), 500.0);
  const ThickPanels solids = thick(model, 20.0, 6.0);
  expect_all_closed(model, solids);
  for (const WorkshopEdge& edge : model.edges) {
    const ThickPanel &left = solids.panels[edge.left], &right = solids.panels[edge.right];
    const auto face = left.faces[2 + edge.left_side], other = right.faces[2 + edge.right_side];
    ASSERT_EQ(left.side_of_face[2 + edge.left_side], edge.left_side);
    const Vector3d normal = newell_vector(left.points, face).normalized();
    for (const int p : other)
      EXPECT_NEAR(normal.dot((right.points.row(p) - left.points.row(face[0])).transpose()), 6.0, 1e-9);
  }
  EXPECT_TRUE(penetrating_solids(solids).empty());
}

// Inner corners of the three panels at a corner are one point.
TEST(ThickPanel, OfAValence3DualMeetAndDoNotPenetrate) {
  const Shape ball = ball_of_tangent_planes(200, 10000.0);
  for (const auto& [from, to] : {std::pair(0, 0), std::pair(120, 200)}) {
    const WorkshopModel model = workshop_model(without_faces(ball, from, to), 1.0);
    const ThickPanels solids = thick(model, 40.0);
    expect_all_closed(model, solids);
    EXPECT_TRUE(penetrating_solids(solids).empty());
    std::map<int, std::vector<Vector3d>> inner;
    std::set<int> on_border, odd;
    for (const WorkshopEdge& edge : model.edges)
      if (edge.border()) on_border.insert({edge.a, edge.b});
    for (const ThicknessFinding& finding : solids.findings) odd.insert(finding.panel);
    for (const ThickPanel& solid : solids.panels) {
      if (odd.contains(solid.panel)) continue;
      for (int k = 0; k < solid.outer; ++k)
        inner[model.panels[solid.panel][k]].push_back(solid.points.row(solid.outer + k).transpose());
    }
    int met = 0;
    for (const auto& [corner, points] : inner) {
      if (on_border.contains(corner) || points.size() < 3) continue;
      ++met;
      EXPECT_NEAR((points[0] - points[1]).norm(), 0.0, 1e-8);
      EXPECT_NEAR((points[0] - points[2]).norm(), 0.0, 1e-8);
    }
    EXPECT_GT(met, 100);
  }
}

TEST(ThickPanel, OfAClosedBodyFillItsShell) {
  const WorkshopModel model = workshop_model(ball_of_tangent_planes(60, 10000.0), 1.0);
  const ThickPanels solids = thick(model, 50.0);
  ASSERT_TRUE(solids.findings.empty());
  double all = 0.0, outer = 0.0;
  for (const ThickPanel& solid : solids.panels) {
    all += volume(solid);
    outer += area(model, solid.panel) * 10000.0 / 3;  // a pyramid to the middle
  }
  const double inner = outer * std::pow(9950.0 / 10000.0, 3);
  EXPECT_NEAR(all / (outer - inner), 1.0, 1e-10);
}

TEST(ThickPanel, OfASaddleOfValence4DoNotPenetrate) {
  for (const double bend : {0.15, -0.15}) {
    const WorkshopModel model = workshop_model(saddle(6, bend), 1000.0);
    const ThickPanels solids = thick(model, 40.0);
    expect_all_closed(model, solids);
    EXPECT_TRUE(penetrating_solids(solids).empty());
  }
}

TEST(ThickPanel, OfATetrahedronKeepsAllPlanesTheThicknessIn) {
  const WorkshopModel model = workshop_model(tetrahedron(), 1000.0);
  const double t = 15.0;
  const ThickPanels solids = thick(model, t);
  expect_all_closed(model, solids);
  EXPECT_TRUE(penetrating_solids(solids).empty());
  double all = 0.0;
  for (const ThickPanel& solid : solids.panels) all += volume(solid);
  // The inner tetrahedron is the outer one scaled about its incentre; of inradius r = 3 V / A.
  const double v = 1e9 / 6, r = 3 * v / (1.5e6 + std::sqrt(3.0) / 2 * 1e6);
  EXPECT_NEAR(all, v * (1 - std::pow(1 - t / r, 3)), 1e-3);
}

// A roof of two triangles and a slim one, seen from outside: a corner of three degrees, whose mitres leave
// the outside by far: the inner corner lies in the panel's far end and stays, as it is inside.
Shape valley(double fold) {
  // Two panels along the x axis that meet at their acute corners with a third one: a folded fan.
  const double c = std::cos(fold), s = std::sin(fold);
  return {make_points({{0, 0, 0}, {1000, 0, 0}, {1000, 150 * c, 150 * s}, {1000, -150 * c, 150 * s}}),
          {{0, 1, 2}, {0, 3, 1}}};
}

TEST(ThickPanel, ASpikeIsCutAndNamed) {
  // In a valley the inner sides lie outside the panel's own: at the acute corner they meet far out.
  const WorkshopModel model = workshop_model(valley(1.0), 1.0);
  const ThickPanels solids = thick(model, 20.0);
  expect_all_closed(model, solids);
  ASSERT_EQ(count(solids, ThicknessTrouble::Spike), 2);
  for (const ThicknessFinding& finding : solids.findings) {
    ASSERT_EQ(finding.trouble, ThicknessTrouble::Spike);
    EXPECT_EQ(model.panels[finding.panel][finding.corner], 0);
    EXPECT_TRUE(finding.cut);
    // The mitre moves the shared side out by t tan(1 rad); the border side stays, so they meet
    // t tan(1) / sin(corner) along it from the corner.
    const double out = 20 * std::tan(1.0) / std::sin(std::atan(0.15));
    EXPECT_NEAR(finding.wanted, std::hypot(out, 20.0), 1e-8);
    EXPECT_EQ(describe(finding, model), model.names[finding.panel] + ": the inner corner " +
                                            std::to_string(finding.corner + 1) +
                                            " would lie 210.9 mm away (thickness 20 mm) and is cut off");
    const ThickPanel& solid = solids.panels[finding.panel];
    EXPECT_EQ(solid.points.rows(), 7);
    // One face that belongs to no side: a triangle from the outer corner.
    int cuts = 0;
    for (int f = 2; f < solid.faces.size(); ++f)
      if (solid.side_of_face[f] < 0) {
        ++cuts;
        ASSERT_EQ(solid.faces[f].size(), 3u);
        int outer = 0;
        for (const int p : solid.faces[f]) {
          outer += p < solid.outer;
          EXPECT_LT((solid.points.row(p) - model.points.row(0)).norm(), kBluntAt * 20.0);
        }
        EXPECT_EQ(outer, 1);
      }
    EXPECT_EQ(cuts, 1);
  }
  EXPECT_TRUE(penetrating_solids(solids).empty());
}

TEST(ThickPanel, AFarCornerInsideThePanelStaysAndIsNamed) {
  const WorkshopModel model = workshop_model(valley(-1.0), 1.0);
  const ThickPanels solids = thick(model, 20.0);
  expect_all_closed(model, solids);
  ASSERT_EQ(count(solids, ThicknessTrouble::Spike), 2);
  EXPECT_FALSE(solids.findings[0].cut);
  EXPECT_NE(describe(solids.findings[0], model).find("inside the panel"), std::string::npos);
  EXPECT_EQ(solids.panels[0].points.rows(), 6);
  EXPECT_TRUE(penetrating_solids(solids).empty());
}

// A panel with a reflex corner at the border, where its border side goes on nearly straight into the side
// that it shares with a panel bent down by 15 degrees.
WorkshopModel reflex_at_the_border(double aside) {
  const double bent = std::numbers::pi / 12;
  const Points points = make_points({{0, 0, 0},
                                     {0, 400, 0},
                                     {-800, 400, 0},
                                     {-800, -1000, 0},
                                     {aside, -1000, 0},
                                     {186 * std::cos(bent), 400, -186 * std::sin(bent)}});
  return workshop_model(points, {{0, 1, 2, 3, 4}, {0, 5, 1}});
}

TEST(ThickPanel, AReflexCornerAtTheBorderStaysBehindItsMitrePlane) {
  const WorkshopModel far = reflex_at_the_border(18);
  const ThickPanels solids = thick(far, 20.0);
  expect_all_closed(far, solids);
  ASSERT_EQ(count(solids, ThicknessTrouble::Spike), 1);
  EXPECT_TRUE(solids.findings[0].cut);
  EXPECT_EQ(solids.findings[0].panel, 0);
  EXPECT_TRUE(penetrating_solids(solids).empty());

  const WorkshopModel near = reflex_at_the_border(180);
  const ThickPanels others = thick(near, 20.0);
  expect_all_closed(near, others);
  EXPECT_TRUE(others.findings.empty());
  EXPECT_TRUE(penetrating_solids(others).empty());
}

TEST(ThickPanel, JustBelowTheLimitNothingIsCut) {
  const WorkshopModel model = workshop_model(valley(0.2), 1.0);
  // tan(0.2) / sin(atan(0.15)) = 1.37 < sqrt(8)
  EXPECT_TRUE(thick(model, 20.0).findings.empty());
  const WorkshopModel more = workshop_model(valley(std::atan(2.83 * std::sin(std::atan(0.15)))), 1.0);
  EXPECT_EQ(count(thick(more, 20.0), ThicknessTrouble::Spike), 2);
}

// A cube with one edge cut off by a narrow facet. Where the panels are thick the facet has no inner face, and
// its ends are lost sides of the top and the bottom.
Shape facetted(double depth) {
  Points normals(7, 3);
  normals << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, std::sqrt(0.5), std::sqrt(0.5), 0;
  Vector offsets = Vector::Constant(7, 500.0);
  offsets[6] = 1000.0 * std::sqrt(0.5) - depth;
  return body_of_planes(normals, offsets);
}

TEST(ThickPanel, ShortSidesAreLostAndNamed) {
  const WorkshopModel model = workshop_model(facetted(5.0), 1.0);
  // The facet is 10 mm wide and loses 2 t tan(22.5 deg): gone at t = 12.07; the top keeps 4 of its 5 sides.
  {
    const ThickPanels solids = thick(model, 12.0);
    EXPECT_TRUE(solids.findings.empty());
    expect_all_closed(model, solids);
  }
  const ThickPanels solids = thick(model, 30.0);
  ASSERT_EQ(count(solids, ThicknessTrouble::Collapsed), 1);
  ASSERT_EQ(count(solids, ThicknessTrouble::LostSide), 2);
  for (const ThicknessFinding& finding : solids.findings) {
    const ThickPanel& solid = solids.panels[finding.panel];
    if (finding.trouble == ThicknessTrouble::Collapsed) {
      EXPECT_EQ(finding.panel, 6);
      EXPECT_TRUE(solid.empty());
      continue;
    }
    expect_closed(solid, model.names[finding.panel]);
    EXPECT_EQ(solid.outer, 5);
    EXPECT_EQ(solid.points.rows(), 9);
    const auto panel = model.panels[finding.panel];
    const double length =
        (model.points.row(panel[finding.corner]) - model.points.row(panel[(finding.corner + 1) % 5])).norm();
    EXPECT_NEAR(length, 10.0, 1e-9);
    for (int f = 2; f < solid.faces.size(); ++f)
      EXPECT_EQ(solid.faces[f].size(), solid.side_of_face[f] == finding.corner ? 3u : 4u);
    // The inner sides beside it meet in the corner of the cube 30 mm in.
    bool meets = false;
    for (int k = 5; k < 9; ++k)
      meets = meets || (solid.points.row(k).head<2>().array() - 470.0).abs().maxCoeff() < 1e-9;
    EXPECT_TRUE(meets);
  }
  // Below the facet its neighbours to both sides, which no mitre parts, meet.
  EXPECT_EQ(penetrating_solids(solids), (std::vector<std::pair<int, int>>{{0, 2}}));
}

TEST(ThickPanel, AGapWiderThanAPanelLeavesNothing) {
  const WorkshopModel model = workshop_model(grid(3, 3), 100.0);
  const ThickPanels solids = thick(model, 10.0, 101.0);
  for (int i = 0; i < 9; ++i)  // those in the corners lose on one side only
    EXPECT_EQ(solids.panels[i].empty(), i % 2 == 1 || i == 4) << i;
  EXPECT_EQ(count(solids, ThicknessTrouble::Collapsed), 5);
}

TEST(ThickPanel, ThickerThanThePanelIsWideLeavesNothing) {
  const ThickPanels solids = thick(workshop_model(cube(), 100.0), 50.5);
  EXPECT_EQ(count(solids, ThicknessTrouble::Collapsed), 6);
  EXPECT_TRUE(thick(workshop_model(cube(), 100.0), 49.5).findings.empty());
}

TEST(ThickPanel, PanelsFoldedOntoEachOtherAreNamed) {
  for (const double up : {0.0, 1e-7}) {
    const WorkshopModel model = workshop_model(
        make_points({{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, up}}), {{0, 1, 2}, {1, 0, 3}});
    const Points points = make_points({{0, 0, 0}, {100, 0, 0}, {50, 100, 0}, {50, 100, up}});
    const WorkshopModel folded = workshop_model(points, {{0, 1, 2}, {1, 0, 3}});
    EXPECT_EQ(count(thick(folded, 5.0), ThicknessTrouble::Collapsed), 2) << up;
  }
}

TEST(ThickPanel, ReflexCornersKeepTheirShape) {
  // An L and the square that fills it, one plane; and the same bent down at the notch's sides.
  const Points points = make_points(
      {{0, 0, 0}, {200, 0, 0}, {200, 100, 0}, {100, 100, 0}, {100, 200, 0}, {0, 200, 0}, {200, 200, 0}});
  const WorkshopModel model = workshop_model(points, {{0, 1, 2, 3, 4, 5}, {3, 2, 6, 4}});
  const ThickPanels solids = thick(model, 10.0, 4.0);
  expect_all_closed(model, solids);
  EXPECT_TRUE(solids.findings.empty());
  EXPECT_NEAR(volume(solids.panels[0]), 10.0 * (200 * 98 + 98 * 102), 1e-6);
  EXPECT_NEAR(volume(solids.panels[1]), 10.0 * 98 * 98, 1e-6);
  EXPECT_TRUE(penetrating_solids(solids).empty());
}

TEST(ThickPanel, CornersInTheMiddleOfASideAreFine) {
  // Two bricks on one: corner 4 lies straight in the long brick's side.
  const Points points = make_points({{0, 0, 0},
                                     {200, 0, 0},
                                     {200, 100, 0},
                                     {90, 100, 0},
                                     {0, 100, 0},
                                     {200, 180, 60},
                                     {90, 180, 60},
                                     {0, 180, 60}});
  const WorkshopModel model = workshop_model(points, {{0, 1, 2, 3, 4}, {3, 2, 5, 6}, {4, 3, 6, 7}});
  const ThickPanels solids = thick(model, 10.0, 2.0);
  expect_all_closed(model, solids);
  EXPECT_TRUE(solids.findings.empty());
  EXPECT_EQ(solids.panels[0].points.rows(), 10);
  EXPECT_TRUE(penetrating_solids(solids).empty());
}

TEST(ThickPanel, DifferentBevelsAlongOneLineAreFine) {
  // As before, but one of the bricks is bent and the other is not: the mitres part at the straight corner.
  const Points points = make_points({{0, 0, 0},
                                     {200, 0, 0},
                                     {200, 100, 0},
                                     {90, 100, 0},
                                     {0, 100, 0},
                                     {200, 180, 60},
                                     {90, 180, 60},
                                     {90, 180, 0},
                                     {0, 180, 0}});
  const WorkshopModel model = workshop_model(points, {{0, 1, 2, 3, 4}, {3, 2, 5, 6}, {4, 3, 7, 8}});
  const ThickPanels solids = thick(model, 10.0);
  expect_all_closed(model, solids);
  EXPECT_EQ(count(solids, ThicknessTrouble::LostSide), 1);
  EXPECT_TRUE(penetrating_solids(solids).empty());
}

TEST(ThickPanel, OutlinesThatCrossThemselvesAreRefused) {
  const WorkshopModel model = workshop_model(
      make_points({{0, 0, 0}, {100, 0, 0}, {20, 120, 0}, {100, 100, 0}, {0, 100, 0}}), {{0, 1, 2, 3, 4}});
  const ThickPanels solids = thick(model, 5.0);
  ASSERT_EQ(solids.findings.size(), 1u);
  EXPECT_EQ(solids.findings[0].trouble, ThicknessTrouble::Crosses);
  EXPECT_TRUE(solids.panels[0].empty());
  EXPECT_EQ(describe(solids.findings[0], model), "P1: the outline crosses itself; it has no solid");
}

TEST(ThickPanel, BadSettingsAreRefused) {
  const WorkshopModel model = workshop_model(cube(), 100.0);
  for (const ThicknessSettings& bad :
       {ThicknessSettings{0.0, 0.0}, {-1.0, 0.0}, {std::nan(""), 0.0}, {5.0, -0.1}, {5.0, INFINITY}}) {
    const auto result = thicken(model, bad);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
    EXPECT_FALSE(result.error().remedy.empty());
  }
}

// --- penetrating_solids --------------------------------------------------------------------------

ThickPanels two(const ThickPanel& first, const Vector3d& shift) {
  ThickPanels both{{first, first}, {}};
  both.panels[0].panel = 0;
  both.panels[1].panel = 1;
  both.panels[1].points.rowwise() += shift.transpose();
  return both;
}

TEST(PenetratingSolids, AreFoundFromTheToleranceOn) {
  const ThickPanel box = thick(workshop_model(grid(1, 1), 100.0), 10.0).panels[0];
  const std::vector<std::pair<int, int>> pair{{0, 1}};
  EXPECT_TRUE(penetrating_solids(two(box, {100, 0, 0})).empty()) << "touching";
  EXPECT_TRUE(penetrating_solids(two(box, {100, 100, 10})).empty()) << "touching";
  EXPECT_TRUE(penetrating_solids(two(box, {101, 0, 0})).empty());
  EXPECT_EQ(penetrating_solids(two(box, {99.999, 30, 3})), pair);
  EXPECT_TRUE(penetrating_solids(two(box, {99.999, 30, 3}), 0.01).empty());
  EXPECT_EQ(penetrating_solids(two(box, {0, 0, 0})), pair) << "one in place of the other";
  EXPECT_EQ(penetrating_solids(two(box, {20, 0, 0})), pair) << "all faces in common planes";
  EXPECT_EQ(penetrating_solids(two(box, {60, 60, -3})), pair);
}

TEST(PenetratingSolids, OneInsideAnotherIsFound) {
  const ThickPanel box = thick(workshop_model(grid(1, 1), 100.0), 10.0).panels[0];
  ThickPanels both = two(box, {0, 0, 0});
  both.panels[0].points *= 0.5;
  both.panels[0].points.rowwise() += Eigen::RowVector3d(20, 20, -2);
  EXPECT_EQ(penetrating_solids(both).size(), 1u);
}

TEST(PenetratingSolids, NotchesMayHoldOthers) {
  const Points l =
      make_points({{0, 0, 0}, {200, 0, 0}, {200, 100, 0}, {100, 100, 0}, {100, 200, 0}, {0, 200, 0}});
  ThickPanels both{{thick(workshop_model(l, {{0, 1, 2, 3, 4, 5}}), 10.0).panels[0],
                    thick(workshop_model(grid(1, 1), 50.0), 10.0).panels[0]},
                   {}};
  both.panels[1].panel = 1;
  both.panels[1].points.rowwise() += Eigen::RowVector3d(100, 100, 0);
  EXPECT_TRUE(penetrating_solids(both).empty());
  both.panels[1].points.rowwise() -= Eigen::RowVector3d(0.5, 0, 0.5);
  EXPECT_EQ(penetrating_solids(both).size(), 1u);
}

TEST(PenetratingSolids, APlantedPairAmongManyIsNamed) {
  ThickPanels solids = thick(workshop_model(ball_of_tangent_planes(100, 5000.0), 1.0), 30.0);
  ASSERT_TRUE(penetrating_solids(solids).empty());
  solids.panels[40].points.rowwise() +=
      5.0 * Eigen::RowVector3d(solids.panels[40].points.colwise().mean()) / 5000;
  EXPECT_TRUE(penetrating_solids(solids).empty()) << "moved outwards";
  solids.panels[40].points.rowwise() -=
      10.0 * Eigen::RowVector3d(solids.panels[40].points.colwise().mean()) / 5000;
  const auto pairs = penetrating_solids(solids);
  EXPECT_GE(pairs.size(), 3u);
  for (const auto& [a, b] : pairs) EXPECT_TRUE((a == 40) != (b == 40));
}

// As many as the largest sample design has panels.
TEST(PenetratingSolids, AreQuickEnough) {
  const WorkshopModel model = workshop_model(ball_of_tangent_planes(400, 30000.0), 1.0);
  const std::clock_t begin = std::clock();
  const ThickPanels solids = thick(model, 40.0);
  EXPECT_TRUE(penetrating_solids(solids).empty());
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  RecordProperty("seconds", std::to_string(seconds));
  EXPECT_LT(seconds * 1753 / 400, 20.0);
}

}  // namespace
}  // namespace planewright
