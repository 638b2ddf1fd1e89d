#include "core/design/design.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

TEST(SuggestedMode, FollowsTheMostlyUsedValence) {
  EXPECT_EQ(suggested_mode(octahedron().mesh()), ComplexKind::Dual);
  EXPECT_EQ(suggested_mode(cube().mesh()), ComplexKind::Planarize);
  EXPECT_EQ(suggested_mode(honeycomb(2, 2).mesh()), ComplexKind::Planarize);
  // Two triangles and two quads: no majority of triangles.
  const Shape mixed{
      make_points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}}),
      {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 6}, {3, 7, 6}}};
  EXPECT_EQ(suggested_mode(mixed.mesh()), ComplexKind::Planarize);
}

TEST(BuildComplex, BuildsWhatTheSettingsName) {
  LayerSettings settings;
  settings.offset = 0.25;
  const PolygonMesh mesh = domed_triangle_grid(4, 4).mesh();
  const auto dual = build_complex(mesh, settings).value();
  EXPECT_EQ(dual->kind, ComplexKind::Dual);
  EXPECT_EQ(dual->plane_count(), mesh.vertex_count());
  EXPECT_EQ(dual->offsets[0], 0.25);
  settings.border = BorderPolicy::Interior;
  EXPECT_EQ(build_complex(mesh, settings).value()->plane_count(), 9);
  settings.mode = ComplexKind::Planarize;
  const auto planarize = build_complex(mesh, settings).value();
  EXPECT_EQ(planarize->kind, ComplexKind::Planarize);
  EXPECT_EQ(planarize->plane_count(), mesh.face_count());
  EXPECT_EQ(planarize->offsets[0], 0.25);
}

TEST(BuildComplex, HandsOnRefusals) {
  LayerSettings settings;
  settings.offset = std::numeric_limits<double>::infinity();
  for (const ComplexKind mode : {ComplexKind::Dual, ComplexKind::Planarize}) {
    settings.mode = mode;
    const auto complex = build_complex(cube().mesh(), settings);
    ASSERT_FALSE(complex);
    EXPECT_EQ(complex.error().code, ErrorCode::Usage);
  }
}

TEST(SameComplex, WeightsAndLimitsDoNotMatter) {
  const LayerSettings a;
  LayerSettings b = a;
  b.weights["fairing"] = 5.0;
  b.max_iterations = 3;
  b.tolerance = 1.0;
  b.freedom = Freedom::Normals;
  EXPECT_TRUE(same_complex(a, b));
  b = a;
  b.mode = ComplexKind::Planarize;
  EXPECT_FALSE(same_complex(a, b));
  b = a;
  b.offset = 1e-9;
  EXPECT_FALSE(same_complex(a, b));
  b = a;
  b.border = BorderPolicy::Interior;
  EXPECT_FALSE(same_complex(a, b));
}

TEST(BuildProblem, TakesWeightsAndFreedom) {
  LayerSettings settings;
  settings.freedom = Freedom::Normals;
  settings.weights = {{"position", 2.0}, {"fairing", 0.5}};
  const auto problem = build_problem(planarize_of(twisted_grid(2, 2).mesh()), settings).value();
  EXPECT_EQ(problem->layout().freedom, Freedom::Normals);
  const Vector z = problem->from_state(initial_state(problem->complex()));
  ASSERT_EQ(problem->energy_shares(z.data()).size(), 2u);
  EXPECT_EQ(problem->energy_shares(z.data())[0].weight, 2.0);
  settings.weights = {{"charm", 1.0}};
  EXPECT_FALSE(build_problem(planarize_of(twisted_grid(2, 2).mesh()), settings));
}

TEST(StartState, IsTheBuildersWithoutAWarmOne) {
  const SharedComplex complex = dual_of(fan(5).mesh(), {0.5});
  const State state = start_state(*complex, {});
  EXPECT_TRUE(same_bits(state.x, complex->preferred));
  EXPECT_TRUE(same_bits(state.h, complex->offsets));
}

TEST(StartState, KeepsWhatTheSettingsHoldFixed) {
  const SharedComplex complex = dual_of(fan(5).mesh(), {0.5});
  const State warm = perturbed(*complex, 0.1);
  LayerSettings settings;
  State state = start_state(*complex, settings, complex.get(), &warm);
  EXPECT_TRUE(same_bits(state.x, warm.x));
  EXPECT_TRUE(same_bits(state.n, warm.n));
  EXPECT_TRUE(same_bits(state.h, warm.h));
  settings.freedom = Freedom::Normals;
  state = start_state(*complex, settings, complex.get(), &warm);
  EXPECT_TRUE(same_bits(state.n, warm.n));
  EXPECT_TRUE(same_bits(state.h, complex->offsets));
  settings.freedom = Freedom::Fixed;
  state = start_state(*complex, settings, complex.get(), &warm);
  EXPECT_TRUE(same_bits(state.x, warm.x));
  EXPECT_TRUE(same_bits(state.n, complex->normals));
  EXPECT_TRUE(same_bits(state.h, complex->offsets));
}

TEST(StartState, TransfersFromAnotherComplexOfTheMesh) {
  const PolygonMesh mesh = domed_triangle_grid(4, 4).mesh();
  const SharedComplex closed = dual_of(mesh), interior = dual_of(mesh, {0.0, BorderPolicy::Interior});
  const State warm = perturbed(*closed, 0.1);
  const State state = start_state(*interior, {}, closed.get(), &warm);
  for (int i = 0; i < interior->plane_count(); ++i)
    EXPECT_EQ(state.n.row(i), warm.n.row(interior->plane_origin[i]));
}

TEST(SolveOptionsOfSettings, CarryLimitAndTolerance) {
  LayerSettings settings;
  settings.max_iterations = 17;
  settings.tolerance = 1e-3;
  EXPECT_EQ(solve_options(settings).max_iterations, 17);
  EXPECT_EQ(solve_options(settings).tolerance, 1e-3);
}

}  // namespace
}  // namespace planewright
