#include "core/solve/projection.h"

#include <gtest/gtest.h>

#include "support/problems.h"

namespace planewright {
namespace {

using namespace test;

constexpr Freedom kFreedoms[] = {Freedom::NormalsAndOffsets, Freedom::Normals};

TEST(Projection, ReachesRoundingFromSmallPerturbations) {
  for (const auto& [label, complex] : small_complexes())
    for (const Freedom freedom : kFreedoms)
      for (unsigned seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(label + ", freedom " + std::to_string(static_cast<int>(freedom)) + ", seed " +
                     std::to_string(seed));
        // A state near the incidences, knocked off them.
        State state = initial_state(*complex);
        const ProjectionReport first = project_onto_incidences(*complex, state, freedom);
        ASSERT_TRUE(first.reached) << first.before << " -> " << first.after << " " << first.factorisations
                                   << " " << first.move;
        State knocked = perturbed(*complex, state, 1e-3, seed);
        if (freedom == Freedom::Normals) knocked.h = state.h;
        const State before = knocked;
        const ProjectionReport report = project_onto_incidences(*complex, knocked, freedom);
        EXPECT_TRUE(report.reached);
        EXPECT_NEAR(report.before, off_plane(*complex, before), 1e-12);
        EXPECT_LE(off_plane(*complex, knocked), 1e-12);
        EXPECT_LE(report.after, 1e-12);
        EXPECT_LE(std::abs((knocked.n.rowwise().norm().array() - 1.0).abs().maxCoeff()), 1e-15);
        // As little as possible: no more than the knock itself, about.
        const double move = (knocked.x - before.x).rowwise().norm().maxCoeff() / complex->mean_edge;
        EXPECT_NEAR(report.move, move, 1e-12);
        EXPECT_LE(move, 0.01);
        if (freedom == Freedom::Normals) {
          EXPECT_TRUE(same_bits(knocked.h, before.h));
        }
      }
}

TEST(Projection, ReachesRoundingFromAfar) {
  for (const char* sample : {"torus", "train-station", "alpine-hut", "dome"}) {
    const SharedComplex complex = dual_of(make_sample(sample, 150).value());
    State state = perturbed(*complex, 0.1);
    const ProjectionReport report = project_onto_incidences(*complex, state, Freedom::NormalsAndOffsets);
    EXPECT_TRUE(report.reached) << sample << ": " << report.after << " after " << report.factorisations;
    EXPECT_LE(off_plane(*complex, state), 1e-12) << sample;
    EXPECT_LT(report.move, 2.0) << sample;
  }
  const SharedComplex quads = planarize_of(make_sample("twisted-roof", 150).value());
  State state = perturbed(*quads, 0.1);
  EXPECT_TRUE(project_onto_incidences(*quads, state, Freedom::NormalsAndOffsets).reached);
  EXPECT_LE(off_plane(*quads, state), 1e-12);
}

TEST(Projection, LeavesAPlanarStateAlone) {
  const SharedComplex complex = dual_of(triangle_grid(4, 4).mesh());
  State state = initial_state(*complex);
  const State before = state;
  const ProjectionReport report = project_onto_incidences(*complex, state, Freedom::NormalsAndOffsets);
  EXPECT_TRUE(report.reached);
  EXPECT_EQ(report.factorisations, 0);
  EXPECT_EQ(report.move, 0.0);
  EXPECT_TRUE(same_bits(state.x, before.x));
  EXPECT_TRUE(same_bits(state.n, before.n));
  EXPECT_TRUE(same_bits(state.h, before.h));
}

// The nearest: for one plane of one free triangle's corner points nothing has to move but the fourth corner's
// way is shared. Here by comparison: no nearby planar state is closer.
TEST(Projection, MovesOneLiftedCornerOfAQuadToTheMinimum) {
  const SharedComplex complex = planarize_of(grid(1, 1).mesh());
  State state = initial_state(*complex);
  const double d = 1e-3;
  // Corner pattern (+, -, +, -): the only direction a quad cannot follow by moving its plane.
  for (int j = 0; j < 4; ++j) state.x(j, 2) += (j == 0 || j == 3) ? d : -d;
  State knocked = state;
  ASSERT_TRUE(project_onto_incidences(*complex, knocked, Freedom::NormalsAndOffsets).reached);
  // All four points go back to z = 0; the plane stays.
  EXPECT_NEAR(knocked.x.col(2).cwiseAbs().maxCoeff(), 0.0, 1e-12);
  EXPECT_NEAR((knocked.x.leftCols(2) - state.x.leftCols(2)).norm(), 0.0, 1e-12);
  // An even lift, though, is shared by points and offset by least squares: 4 dx^2 + dh^2.
  state = initial_state(*complex);
  state.x.col(2).array() += d;
  ASSERT_TRUE(project_onto_incidences(*complex, state, Freedom::NormalsAndOffsets).reached);
  EXPECT_NEAR(state.x(0, 2), 0.8 * d, 1e-6);
  EXPECT_NEAR(state.h[0], 0.8 * d, 1e-6);
}

TEST(Projection, FixedMovesPointsToTheNearestPlaceOnTheirPlanes) {
  const SharedComplex complex = dual_of(fan(5).mesh());
  const State start = perturbed(*complex, 0.05);
  State state = start;
  state.n = complex->normals;
  state.h = complex->offsets;
  const ProjectionReport report = project_onto_incidences(*complex, state, Freedom::Fixed);
  EXPECT_TRUE(report.reached);
  EXPECT_LE(off_plane(*complex, state), 1e-12);
  EXPECT_TRUE(same_bits(state.n, complex->normals));
  EXPECT_TRUE(same_bits(state.h, complex->offsets));
  for (int j = 0; j < complex->point_count(); ++j) {
    if (complex->planes_of_point.valence(j) != 1) continue;
    const int i = complex->planes_of_point[j][0];
    const Vector3d n = complex->normals.row(i);
    const Vector3d x = start.x.row(j), v = complex->anchors.row(i);
    const Vector3d foot = x - n * (n.dot(x - v) - complex->offsets[i]);
    EXPECT_NEAR((state.x.row(j).transpose() - foot).norm(), 0.0, 1e-12);
  }
}

TEST(Projection, WorksInTheModelsUnits) {
  Shape shape = twisted_grid(3, 3);
  State unit_state;
  for (const double scale : {1.0, 1e-4, 1e5}) {
    Shape scaled = shape;
    scaled.positions *= scale;
    const SharedComplex complex = planarize_of(scaled.mesh());
    State state = initial_state(*complex);
    ASSERT_TRUE(project_onto_incidences(*complex, state, Freedom::NormalsAndOffsets).reached);
    if (scale == 1.0) unit_state = state;
    EXPECT_NEAR((state.x / scale - unit_state.x).norm(), 0.0, 1e-10);
    EXPECT_NEAR((state.h / scale - unit_state.h).norm(), 0.0, 1e-10);
  }
}

// Whatever it starts from, even nonsense: what comes out is finite and no worse.
TEST(Projection, IsNeverWorse) {
  for (const auto& [label, complex] : small_complexes())
    for (const Freedom freedom : {Freedom::NormalsAndOffsets, Freedom::Normals, Freedom::Fixed})
      for (const double size : {0.5, 20.0, 1e6})
        for (const int factorisations : {1, 60}) {
          State state = perturbed(*complex, size, 7);
          const double before = off_plane(*complex, state);
          const ProjectionReport report =
              project_onto_incidences(*complex, state, freedom, 1e-13, factorisations);
          EXPECT_LE(off_plane(*complex, state), before * (1 + 1e-12)) << label << " " << size;
          EXPECT_LE(report.factorisations, factorisations);
          EXPECT_TRUE(state.x.allFinite() && state.n.allFinite() && state.h.allFinite()) << label;
        }
}

TEST(Projection, CoincidentPointsAreNoObstacle) {
  const SharedComplex complex = planarize_of(twisted_grid(2, 2).mesh());
  State state = initial_state(*complex);
  state.x.rowwise() = Eigen::RowVector3d(state.x.row(4));
  const ProjectionReport report = project_onto_incidences(*complex, state, Freedom::NormalsAndOffsets);
  EXPECT_TRUE(report.reached);
  EXPECT_LE(off_plane(*complex, state), 1e-12);
}

TEST(Projection, StopsWhenAsked) {
  const SharedComplex complex = planarize_of(twisted_grid(3, 3).mesh());
  std::stop_source stop;
  stop.request_stop();
  State state = perturbed(*complex, 0.1);
  const State before = state;
  const ProjectionReport report =
      project_onto_incidences(*complex, state, Freedom::NormalsAndOffsets, 1e-13, 60, stop.get_token());
  EXPECT_EQ(report.factorisations, 0);
  EXPECT_FALSE(report.reached);
  EXPECT_TRUE(same_bits(state.x, before.x));
}

TEST(Projection, IsDeterministic) {
  const SharedComplex complex = dual_of(make_sample("train-station", 150).value());
  State first = perturbed(*complex, 0.1), second = first;
  project_onto_incidences(*complex, first, Freedom::NormalsAndOffsets);
  project_onto_incidences(*complex, second, Freedom::NormalsAndOffsets);
  EXPECT_TRUE(same_bits(first.x, second.x));
  EXPECT_TRUE(same_bits(first.n, second.n));
  EXPECT_TRUE(same_bits(first.h, second.h));
}

}  // namespace
}  // namespace planewright
