#include "core/layers/beams.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/layers/parallel_offset.h"
#include "support/solves.h"

namespace planewright {
namespace {

using namespace test;

Beams beams_between(const SharedComplex& complex, const State& first, const State& second) {
  return make_beams(*complex, first, *complex, second).value();
}

TEST(Beams, OfACubeAndItsOffsetRunAlongItsEdges) {
  const SharedComplex complex = planarize_of(cube().mesh());
  const State state = initial_state(*complex);
  const State outer = parallel_offset(*complex, state, 0.25).state;
  const Beams beams = beams_between(complex, state, outer);
  ASSERT_EQ(beams.quads.size(), 12);
  ASSERT_EQ(beams.points.rows(), 16);
  for (int k = 0; k < 12; ++k) {
    const PanelEdge& edge = complex->panel_edges[beams.edge[k]];
    const auto quad = beams.quads[k];
    EXPECT_EQ(beams.edge[k], k);
    EXPECT_EQ((std::vector<int>(quad.begin(), quad.end())),
              (std::vector<int>{edge.a, edge.b, 8 + edge.b, 8 + edge.a}));
    EXPECT_EQ(beams.points.row(quad[0]), state.x.row(edge.a));
    EXPECT_EQ(beams.points.row(quad[2]), outer.x.row(edge.b));
    EXPECT_NEAR(beams.planarity[k], 0.0, 1e-15);
    EXPECT_NEAR(beams.twist[k], 0.0, 1e-15);
  }
}

// Every beam of a solved design, those of its open border included.
TEST(Beams, BetweenSolvedPanelsAndTheirParallelOffsetArePlanar) {
  for (const char* sample : {"dome", "train-station"}) {
    const SharedComplex complex = dual_of(make_sample(sample, 80).value(), {0.1, BorderPolicy::Closed});
    const State state = solve(*problem_of(complex, {{"position", 1.0}, {"fairing", 0.1}})).state;
    for (const double share : {0.05, -0.05}) {
      const ParallelOffset offset = parallel_offset(*complex, state, share * complex->mean_edge);
      const Beams beams = beams_between(complex, state, offset.state);
      EXPECT_EQ(beams.quads.size(), static_cast<int>(complex->panel_edges.size()));
      EXPECT_TRUE(offset.blunted.empty()) << sample;
      for (size_t e = 0; e < complex->panel_edges.size(); ++e)
        EXPECT_LE(beams.planarity[e], 1e-9 * bounding_diagonal(state.x))
            << sample << " edge " << e << (complex->panel_edges[e].border() ? " border" : "");
      EXPECT_LE(summarise(beams).planarity_relative, 1e-9);
    }
  }
}

// A square turned over another: each edge is twisted against its own by the angle.
TEST(Beams, TwistIsTheAngleBetweenTheEdges) {
  const SharedComplex complex = planarize_of(grid(1, 1).mesh());
  const State state = initial_state(*complex);
  for (const double angle : {0.0, 0.3, -0.3, 2.5}) {
    State upper = state;
    upper.x *= Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix().transpose();
    upper.x.col(2).array() += 1.0;
    for (const double twist : beams_between(complex, state, upper).twist)
      EXPECT_NEAR(twist, std::abs(angle), 1e-14);
  }
}

// Edge a b along x, edge a' b' above it tilted by d to both sides: the corners of a square twisted by a
// height of d lie d / 2 off the middle plane, up to the tilt of that plane.
TEST(Beams, PlanarityIsTheDistanceFromTheQuadsOwnPlane) {
  const SharedComplex complex = planarize_of(grid(1, 1).mesh());
  const State state = initial_state(*complex);
  State upper = state;
  upper.x.col(2).array() += 1.0;
  const double d = 1e-4;
  int edge = -1;
  for (size_t e = 0; e < complex->panel_edges.size(); ++e)
    if (complex->panel_edges[e].a == 0 && complex->panel_edges[e].b == 1) edge = static_cast<int>(e);
  ASSERT_GE(edge, 0);
  upper.x(0, 1) += d;
  upper.x(1, 1) -= d;
  const Beams beams = beams_between(complex, state, upper);
  EXPECT_NEAR(beams.planarity[edge], 0.5 * d, 1e-7 * d);
  EXPECT_NEAR(beams.twist[edge], std::atan(2 * d), 1e-14);
  const BeamSummary summary = summarise(beams);
  EXPECT_EQ(summary.beams, 4);
  EXPECT_EQ(summary.max_planarity, beams.planarity[edge]);
  EXPECT_EQ(summary.least_planar_edge, edge);
  EXPECT_EQ(summary.max_twist, beams.twist[edge]);
  EXPECT_EQ(summary.most_twisted_edge, edge);
  EXPECT_DOUBLE_EQ(summary.planarity_relative, summary.max_planarity / bounding_diagonal(beams.points));
}

TEST(Beams, EdgesWithoutLengthHaveNoTwist) {
  const SharedComplex complex = planarize_of(grid(1, 1).mesh());
  State lower = initial_state(*complex), upper = lower;
  upper.x.col(2).array() += 1.0;
  upper.x.row(1) = upper.x.row(0);
  const Beams beams = beams_between(complex, lower, upper);
  for (size_t k = 0; k < beams.edge.size(); ++k) {
    const PanelEdge& edge = complex->panel_edges[k];
    if (edge.a == 0 && edge.b == 1) {
      EXPECT_EQ(beams.twist[k], 0.0);
      EXPECT_NEAR(beams.planarity[k], 0.0, 1e-15);
    }
    EXPECT_TRUE(std::isfinite(beams.planarity[k]));
  }
  lower.x.setZero();
  const Beams nothing = beams_between(complex, lower, lower);
  for (size_t k = 0; k < nothing.edge.size(); ++k) {
    EXPECT_EQ(nothing.twist[k], 0.0);
    EXPECT_EQ(nothing.planarity[k], 0.0);
  }
  EXPECT_EQ(summarise(nothing).planarity_relative, 0.0);
  EXPECT_EQ(summarise({}).least_planar_edge, -1);
}

// Layers keep their points relative to origins of their own.
TEST(Beams, AreRelativeToTheFirstLayersOrigin) {
  Shape shape = twisted_grid(2, 2);
  const SharedComplex first = planarize_of(shape.mesh());
  shape.positions.rowwise() += Eigen::RowVector3d(10, 20, 30);
  const SharedComplex second = planarize_of(shape.mesh());
  const State state = initial_state(*second);
  const Beams beams = make_beams(*first, initial_state(*first), *second, state).value();
  const int count = first->point_count();
  for (int j = 0; j < count; ++j)
    EXPECT_NEAR((beams.points.row(count + j) - beams.points.row(j) - Eigen::RowVector3d(10, 20, 30)).norm(),
                0.0, 1e-12);
}

TEST(Beams, AreRefusedBetweenLayersOfOtherPanels) {
  const SharedComplex grid_panels = planarize_of(twisted_grid(3, 2).mesh());
  const auto refusal = [&](const SharedComplex& other) {
    const auto beams = make_beams(*grid_panels, initial_state(*grid_panels), *other, initial_state(*other));
    EXPECT_FALSE(beams.has_value());
    if (beams) return std::string();
    EXPECT_EQ(beams.error().code, ErrorCode::Refused);
    EXPECT_FALSE(beams.error().remedy.empty());
    return beams.error().text();
  };
  EXPECT_NE(refusal(dual_of(twisted_grid(3, 2).mesh())).find("dual"), std::string::npos);
  EXPECT_NE(refusal(planarize_of(twisted_grid(2, 2).mesh())).find("12 corners and the other 9"),
            std::string::npos);
  // As many points, other panels.
  Shape cut = twisted_grid(3, 2);
  const Points points = cut.positions;
  Polygons faces;
  for (int f = 0; f < cut.faces.size(); ++f) {
    const auto q = cut.faces[f];
    faces.push_back(std::array{q[0], q[1], q[2]});
    faces.push_back(std::array{q[0], q[2], q[3]});
  }
  EXPECT_NE(refusal(planarize_of(PolygonMesh::from_polygons(points, faces).value())).find("other corners"),
            std::string::npos);
  State short_state = initial_state(*grid_panels);
  short_state.x.conservativeResize(5, 3);
  EXPECT_FALSE(make_beams(*grid_panels, short_state, *grid_panels, initial_state(*grid_panels)).has_value());
}

}  // namespace
}  // namespace planewright
