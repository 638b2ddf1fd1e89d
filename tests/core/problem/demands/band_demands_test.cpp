// Offset band and height band.
#include <gtest/gtest.h>

#include "core/problem/demands/band.h"
#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

TEST(Band, KeepsTheMarginToBothEnds) {
  const Bounds bounds = band_bounds("band", -1.0, 2.0, 0.1).value();
  EXPECT_DOUBLE_EQ(bounds.low, -0.9);
  EXPECT_DOUBLE_EQ(bounds.high, 1.9);
  const Bounds narrow = band_bounds("band", 1.0, 1.2, 0.1).value();
  EXPECT_DOUBLE_EQ(narrow.low, 1.05);
  EXPECT_DOUBLE_EQ(narrow.high, 1.15);
  const Bounds equation = band_bounds("band", 0.3, 0.3, 0.1).value();
  EXPECT_EQ(equation.low, 0.3);
  EXPECT_EQ(equation.high, 0.3);
  const Bounds above = band_bounds("band", 0.3, kUnbounded, 0.1).value();
  EXPECT_DOUBLE_EQ(above.low, 0.4);
  EXPECT_EQ(above.high, kUnbounded);
  const Bounds below = band_bounds("band", -kUnbounded, 0.3, 0.1).value();
  EXPECT_EQ(below.low, -kUnbounded);
  EXPECT_DOUBLE_EQ(below.high, 0.2);
  EXPECT_TRUE(endless(band_bounds("band", -kUnbounded, kUnbounded, 0.1).value()));
  EXPECT_FALSE(endless(above));
  EXPECT_FALSE(endless(below));
}

TEST(OffsetBand, IsOfTheOffsetsInModelUnits) {
  for (const double side : {1.0, -1.0})  // means nothing here
    for (const SharedComplex& complex :
         {dual_of(domed_triangle_grid(4, 3).mesh(), {0.2}), planarize_of(grid(3, 2).mesh(), {0.2})}) {
      const double edge = complex->mean_edge;
      const auto problem =
          Problem::create(complex, demanding({demand("offset-band", {-0.3, 0.25})}, {}, side)).value();
      const auto rows = rows_of(*problem, "offset-band");
      ASSERT_EQ(static_cast<int>(rows.size()), complex->plane_count());
      const Vector values = row_values(*problem, initial_state(*complex));
      for (size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(problem->row_element(rows[i]), (ElementRef{ElementKind::Panel, static_cast<int>(i)}));
        EXPECT_DOUBLE_EQ(values[rows[i]], 0.2 / edge);
        EXPECT_NEAR(problem->bounds(rows[i]).low, -0.3 / edge + 1e-4, 1e-14);
        EXPECT_NEAR(problem->bounds(rows[i]).high, 0.25 / edge - 1e-4, 1e-14);
      }
    }
}

// Face points and border points over their face, corners and planarized vertices over their vertex.
TEST(HeightBand, IsTheHeightOverTheMesh) {
  const PolygonMesh mesh = domed_triangle_grid(4, 3).mesh();
  for (const SharedComplex& complex : {dual_of(mesh, {0.2}), planarize_of(mesh, {0.2})}) {
    const auto problem = Problem::create(complex, demanding({demand("height-band", {0.1, 0.5})})).value();
    const auto rows = rows_of(*problem, "height-band");
    ASSERT_EQ(static_cast<int>(rows.size()), complex->point_count());
    State state = initial_state(*complex);
    const Vector values = row_values(*problem, state);
    for (size_t j = 0; j < rows.size(); ++j) {
      EXPECT_EQ(problem->row_element(rows[j]), (ElementRef{ElementKind::Point, static_cast<int>(j)}));
      // Every point is wanted 0.2 over what it stands for.
      EXPECT_NEAR(values[rows[j]] - problem->bounds(rows[j]).low, 0.1 / complex->mean_edge - 1e-4, 1e-12);
      EXPECT_NEAR(problem->bounds(rows[j]).high - values[rows[j]], 0.3 / complex->mean_edge - 1e-4, 1e-12);
    }
    state.x.col(2).array() += 0.1;
    const Vector lifted = row_values(*problem, state);
    for (int r : rows) {
      EXPECT_GT(lifted[r], values[r]);
      EXPECT_LE(lifted[r], values[r] + 0.1 / complex->mean_edge + 1e-12);
    }
  }
}

// Of a quad that is not planar: over its middle.
TEST(HeightBand, OfABentQuadCountsFromItsMiddle) {
  const Shape bent{make_points({{0, 0, 0.3}, {1, 0, -0.3}, {1, 1, 0.3}, {0, 1, -0.3}}), {{0, 1, 2, 3}}};
  const SharedComplex complex = dual_of(bent.mesh(), {0.1});
  const auto problem = Problem::create(complex, demanding({demand("height-band", {0.1, 0.1})})).value();
  const int row = rows_of(*problem, "height-band", {ElementKind::Point, 0}).at(0);
  const Vector values = row_values(*problem, initial_state(*complex));
  EXPECT_EQ(problem->bounds(row).low, problem->bounds(row).high);
  EXPECT_NEAR(values[row], problem->bounds(row).low, 1e-13);
}

TEST(HeightBand, WithOneEndHasNoOther) {
  const SharedComplex complex = dual_of(domed_triangle_grid(4, 3).mesh());
  const auto above = Problem::create(complex, demanding({demand("height-band", {0.1})})).value();
  for (int r : rows_of(*above, "height-band")) {
    EXPECT_EQ(above->bounds(r).high, kUnbounded);
    EXPECT_LT(std::abs(above->bounds(r).low), 100.0);
  }
  const auto below = Problem::create(complex, demanding({demand("height-band", {-kUnbounded, 0.1})})).value();
  for (int r : rows_of(*below, "height-band")) {
    EXPECT_EQ(below->bounds(r).low, -kUnbounded);
    EXPECT_LT(std::abs(below->bounds(r).high), 100.0);
  }
  EXPECT_TRUE(
      rows_of(*Problem::create(complex, demanding({demand("height-band")})).value(), "height-band").empty());
}

TEST(Bands, KeepToTheirSelection) {
  const SharedComplex complex = planarize_of(twisted_grid(4, 3).mesh());
  const auto problem =
      Problem::create(complex, demanding({demand("offset-band", {-1, 1}, "face"),
                                          demand("height-band", {-1, 1}, "vertices")},
                                         {{"face", {}, {}, {7}}, {"vertices", {3, 8}, {}, {}}}))
          .value();
  const auto offsets = rows_of(*problem, "offset-band"), heights = rows_of(*problem, "height-band");
  ASSERT_EQ(offsets.size(), 1u);
  EXPECT_EQ(problem->row_element(offsets[0]), (ElementRef{ElementKind::Panel, 7}));
  ASSERT_EQ(heights.size(), 2u);
  EXPECT_EQ(problem->row_element(heights[1]), (ElementRef{ElementKind::Point, 8}));
}

TEST(Bands, HaveRightDerivatives) {
  for (const auto& [what, complex] : small_complexes())
    expect_right_derivatives(
        complex, demanding({demand("offset-band", {-1.0, 1.0}), demand("height-band", {-1.0, 1.0})}), what);
}

TEST(Bands, AreMetByASolve) {
  const PolygonMesh dome = make_sample("dome", 80).value();
  const double edge = dual_of(dome)->mean_edge;
  // Planes over a dome float higher than what is wanted of its points.
  {
    SCOPED_TRACE("offset band");
    expect_demands_take_effect(dual_of(dome, {0.2 * edge}),
                               demanding({demand("offset-band", {0.0, 0.15 * edge})}), 1e-3);
  }
  {
    SCOPED_TRACE("height band");
    expect_demands_take_effect(dual_of(dome, {0.2 * edge}),
                               demanding({demand("height-band", {0.19 * edge, 0.21 * edge})}), 1e-3);
  }
  const PolygonMesh roof = make_sample("twisted-roof", 80).value();
  const SharedComplex quads = planarize_of(roof);
  {
    SCOPED_TRACE("planarized");
    const double small = 0.002 * quads->mean_edge;
    expect_demands_take_effect(quads, demanding({demand("height-band", {-small, small})}), 1e-4);
  }
}

}  // namespace
}  // namespace planewright
