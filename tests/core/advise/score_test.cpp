#include "core/advise/score.h"

#include <gtest/gtest.h>

#include "support/complexes.h"
#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;

TEST(Score, OfACleanGridIsNothing) {
  const Scene scene = Scene::flat_grid(4, 4);
  EXPECT_EQ(defects_of(*scene.complex, scene.state, whole_region(*scene.complex)), Score{});
}

TEST(Score, CountsEachDefectInItsOwnPart) {
  // One inner corner of a grid of unit squares moved along x: by 0.9 its edge to the right is 0.1 long.
  Scene scene = Scene::flat_grid(4, 4);
  const Region region = whole_region(*scene.complex);
  scene.put(12, 2.9, 2.0);
  const Score close = defects_of(*scene.complex, scene.state, region);
  EXPECT_NEAR(close.short_edges, 1.0 - 0.1 / 0.15, 1e-9);
  EXPECT_EQ(close.reversed, 0.0);
  EXPECT_EQ(close.far_points, 0.0);
  // By 1.4 it has passed its neighbour, 0.4 further, and is 1.4 from where it was wanted.
  scene.put(12, 3.4, 2.0);
  const Score past = defects_of(*scene.complex, scene.state, region);
  EXPECT_NEAR(past.reversed, 0.4, 1e-9);
  EXPECT_NEAR(past.far_points, 0.4, 1e-9);
  EXPECT_EQ(past.short_edges, 0.0);
}

TEST(Score, LooksAtItsRegionAlone) {
  Scene scene = Scene::flat_grid(4, 4);
  scene.put(12, 3.4, 2.0);
  Region elsewhere = whole_region(*scene.complex);
  elsewhere.points = {0};
  elsewhere.panels = {0};
  elsewhere.panel_edges.clear();
  EXPECT_EQ(defects_of(*scene.complex, scene.state, elsewhere), Score{});
}

TEST(Score, TotalIsTheWeightedSum) {
  const Score score{1.0, 2.0, 3.0, 4.0, 5.0};
  EXPECT_DOUBLE_EQ(total(score), 1.0 + 4.0 + 1.5 + 2.0 + 5.0);
  EXPECT_DOUBLE_EQ(total(score, {0.0, 0.0, 0.0, 1.0, 0.0}), 4.0);
}

}  // namespace
}  // namespace planewright
