#include "core/diagnose/ill_determined.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

TEST(Determinacy, IsOneForPerpendicularPlanesAndZeroForAFlatPlace) {
  const SharedComplex cube_faces = planarize_of(cube().mesh());
  EXPECT_NEAR((determinacy(*cube_faces, initial_state(*cube_faces)).array() - 1.0).abs().maxCoeff(), 0.0,
              1e-7);
  const SharedComplex flat = dual_of(triangle_grid(3, 3).mesh());
  EXPECT_NEAR(determinacy(*flat, initial_state(*flat)).cwiseAbs().maxCoeff(), 0.0, 1e-7);
}

TEST(Determinacy, IsTheThirdSingularValueOfTheNormals) {
  for (const auto& [label, complex] : small_complexes()) {
    const State state = perturbed(*complex, 0.2);
    const Vector measure = determinacy(*complex, state);
    ASSERT_EQ(measure.size(), complex->point_count());
    for (int j = 0; j < complex->point_count(); ++j) {
      const auto planes = complex->planes_of_point[j];
      Eigen::MatrixXd normals(std::max<Eigen::Index>(3, static_cast<Eigen::Index>(planes.size())), 3);
      normals.setZero();
      for (size_t r = 0; r < planes.size(); ++r)
        normals.row(static_cast<Eigen::Index>(r)) = state.n.row(planes[r]);
      EXPECT_NEAR(measure[j], Eigen::JacobiSVD<Eigen::MatrixXd>(normals).singularValues()[2], 2e-7) << label;
    }
  }
}

TEST(Determinacy, IsMeasuredAtTheState) {
  const SharedComplex complex = dual_of(octahedron().mesh());
  State state = initial_state(*complex);
  state.n.rowwise() = Eigen::RowVector3d(0, 0, 1);
  EXPECT_NEAR(determinacy(*complex, state).maxCoeff(), 0.0, 1e-7);
}

TEST(FindIllDetermined, ListsThoseBelowTheThresholdWorstFirst) {
  const SharedComplex complex = dual_of(domed_triangle_grid(5, 5).mesh());
  const State state = initial_state(*complex);
  const Vector measure = determinacy(*complex, state);
  const double threshold = 0.07;
  const auto found = find_ill_determined(*complex, state, threshold);
  int expected = 0;
  for (int j = 0; j < complex->point_count(); ++j)
    expected += complex->planes_of_point.valence(j) >= 3 && measure[j] < threshold;
  ASSERT_EQ(static_cast<int>(found.size()), expected);
  ASSERT_GT(expected, 2);
  ASSERT_LT(expected, complex->point_count());
  for (size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].singular_value, measure[found[k].point]);
    if (k > 0) {
      EXPECT_TRUE(
          found[k - 1].singular_value < found[k].singular_value ||
          (found[k - 1].singular_value == found[k].singular_value && found[k - 1].point < found[k].point));
    }
  }
}

// Points of the outline are undetermined on purpose.
TEST(FindIllDetermined, LeavesOutPointsOnFewerThanThreePlanes) {
  const SharedComplex complex = dual_of(fan(6).mesh());
  for (const IllDetermined& point : find_ill_determined(*complex, initial_state(*complex), 10.0))
    EXPECT_GE(complex->planes_of_point.valence(point.point), 3);
  EXPECT_EQ(find_ill_determined(*complex, initial_state(*complex), 10.0).size(), 6u);
}

// One place of an otherwise well bent design is made flat: only its points stand out.
TEST(FindIllDetermined, MarksWhatStandsOut) {
  const SharedComplex complex = dual_of(icosahedron().mesh());
  State state = initial_state(*complex);
  EXPECT_TRUE(find_ill_determined(*complex, state).empty());
  const auto planes = complex->planes_of_point[7];
  for (const int i : planes) state.n.row(i) = state.n.row(planes[0]);
  const auto found = find_ill_determined(*complex, state);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().point, 7);
  EXPECT_NEAR(found.front().singular_value, 0.0, 1e-7);
  EXPECT_LT(found.size(), 20u);
}

// A fine mesh of a smooth surface has nearly parallel neighbours everywhere: nothing stands out.
TEST(FindIllDetermined, AFineMeshIsNotIllEverywhere) {
  const SharedComplex complex = dual_of(make_sample("dome", 2000).value());
  EXPECT_LT(determinacy(*complex, initial_state(*complex)).mean(), 0.05);
  EXPECT_LT(find_ill_determined(*complex, initial_state(*complex)).size(),
            static_cast<size_t>(complex->point_count()) / 50);
}

TEST(NotableThreshold, StaysWithinItsLimits) {
  const SharedComplex sharp = planarize_of(cube().mesh());
  EXPECT_DOUBLE_EQ(notable_threshold(*sharp, initial_state(*sharp)), 0.05);
  const SharedComplex flat = dual_of(triangle_grid(3, 3).mesh());
  EXPECT_DOUBLE_EQ(notable_threshold(*flat, initial_state(*flat)), 1e-3);
  // Everything flat is worth a mark.
  EXPECT_EQ(find_ill_determined(*flat, initial_state(*flat)).size(), 18u);
}

}  // namespace
}  // namespace planewright
