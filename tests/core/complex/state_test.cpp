#include "core/complex/state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/complex/mapped_origin.h"
#include "core/mesh/mesh_edits.h"
#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

TEST(State, StartsAtTheWantedPoints) {
  const TangentComplex complex = build_dual(fan(5).mesh(), {0.5}).value();
  const State state = initial_state(complex);
  EXPECT_TRUE(same_bits(state.x, complex.preferred));
  EXPECT_TRUE(same_bits(state.n, complex.normals));
  EXPECT_TRUE(same_bits(state.h, complex.offsets));
}

TEST(IncidenceResiduals, AreSignedDistancesAlongTheNormalBeyondTheOffset) {
  const TangentComplex complex = build_planarize(grid(2, 1).mesh()).value();
  State state = initial_state(complex);
  state.x(1, 2) = 0.5;  // the lower middle, on both planes
  state.h[1] = 0.125;   // lifts the right plane
  const Vector residuals = incidence_residuals(complex, state);
  ASSERT_EQ(residuals.size(), 8);
  // Points in order: 0 {0}, 1 {0, 1}, 2 {1}, 3 {0}, 4 {0, 1}, 5 {1}.
  const Vector expected{{0.0, 0.5, 0.375, -0.125, 0.0, 0.0, -0.125, -0.125}};
  EXPECT_NEAR((residuals - expected).norm(), 0.0, 1e-15);
}

TEST(PanelsOf, AreInModelCoordinates) {
  Shape shape = cube();
  shape.positions.rowwise() += Eigen::RowVector3d(100, 200, 300);
  const TangentComplex complex = build_planarize(shape.mesh()).value();
  const Panels panels = panels_of(complex, initial_state(complex));
  EXPECT_EQ(panels.polygons, shape.faces);
  EXPECT_NEAR((panels.points - shape.positions).norm(), 0.0, 1e-13);
}

TEST(Transfer, ToTheSameComplexKeepsEverything) {
  const TangentComplex complex = build_dual(domed_triangle_grid(4, 3).mesh()).value();
  const State state = perturbed(complex, 0.1);
  const State moved = transfer(complex, state, complex);
  EXPECT_TRUE(same_bits(moved.x, state.x));
  EXPECT_TRUE(same_bits(moved.n, state.n));
  EXPECT_TRUE(same_bits(moved.h, state.h));
}

TEST(Transfer, AfterAFlipKeepsAllButTheTwoChangedPoints) {
  PolygonMesh mesh = domed_triangle_grid(4, 4).mesh();
  const TangentComplex before = build_dual(mesh).value();
  const State state = perturbed(before, 0.1);
  int flipped = -1;
  for (int e = 0; e < mesh.edge_count() && flipped < 0; ++e)
    if (!mesh.is_border_vertex(mesh.edge(e).a) && !mesh.is_border_vertex(mesh.edge(e).b) && mesh.can_flip(e))
      flipped = e;
  ASSERT_GE(flipped, 0);
  const int left = mesh.edge(flipped).left, right = mesh.edge(flipped).right;
  ASSERT_TRUE(mesh.flip(flipped));
  const TangentComplex after = build_dual(mesh).value();
  const State moved = transfer(before, state, after);

  EXPECT_TRUE(same_bits(moved.n, state.n));
  EXPECT_TRUE(same_bits(moved.h, state.h));
  int changed = 0;
  ASSERT_EQ(after.point_count(), before.point_count());
  for (int j = 0; j < after.point_count(); ++j) {
    const PointOrigin origin = after.point_origin[j];
    ASSERT_EQ(origin, before.point_origin[j]);
    const bool of_the_flip =
        origin.kind == PointKind::Face && (origin.element == left || origin.element == right);
    if (of_the_flip) {
      ++changed;
      EXPECT_EQ(moved.x.row(j), after.preferred.row(j));
    } else {
      EXPECT_EQ(moved.x.row(j), state.x.row(j));
    }
  }
  EXPECT_EQ(changed, 2);
}

// From panels with the outline to panels without it: what both have stays.
TEST(Transfer, BetweenBorderPolicies) {
  const PolygonMesh mesh = domed_triangle_grid(4, 4).mesh();
  const TangentComplex closed = build_dual(mesh).value();
  const TangentComplex interior = build_dual(mesh, {0.0, BorderPolicy::Interior}).value();
  const State state = perturbed(closed, 0.1);
  const State moved = transfer(closed, state, interior);
  for (int i = 0; i < interior.plane_count(); ++i) {
    const int v = interior.plane_origin[i];  // closed has a plane for every vertex
    EXPECT_EQ(moved.n.row(i), state.n.row(v));
    EXPECT_EQ(moved.h[i], state.h[v]);
  }
  int kept = 0;
  for (int j = 0; j < interior.point_count(); ++j) {
    const int f = interior.point_origin[j].element;
    const bool same_planes = interior.planes_of_point.valence(j) == 3;
    EXPECT_EQ(moved.x.row(j), same_planes ? state.x.row(f) : interior.preferred.row(j));
    kept += same_planes;
  }
  EXPECT_GT(kept, 0);
  EXPECT_LT(kept, interior.point_count());
}

// The mesh moved and one vertex was dragged: planes and points stay where they were in space.
TEST(Transfer, KeepsPlanesInSpaceWhenAnchorsMove) {
  Shape shape = twisted_grid(3, 3);
  const TangentComplex before = build_planarize(shape.mesh()).value();
  const State state = perturbed(before, 0.1);
  shape.positions.row(15) += Eigen::RowVector3d(3, 2, 1);  // also moves the origin
  const TangentComplex after = build_planarize(shape.mesh()).value();
  ASSERT_NE(before.origin, after.origin);
  const State moved = transfer(before, state, after);
  EXPECT_NEAR((panels_of(after, moved).points - panels_of(before, state).points).norm(), 0.0, 1e-13);
  const Vector a = incidence_residuals(before, state), b = incidence_residuals(after, moved);
  EXPECT_NEAR((a - b).norm(), 0.0, 1e-13);
}

// Vertex and face indices shift; what no edit touched is where it was.
TEST(Transfer, AfterEditsKeepsAllButWhatTheyTouched) {
  for (const bool triangles : {true, false}) {
    const PolygonMesh mesh = (triangles ? domed_triangle_grid(5, 5) : twisted_grid(5, 5)).mesh();
    const auto build = [&](const PolygonMesh& m) {
      return triangles ? build_dual(m).value() : build_planarize(m).value();
    };
    const TangentComplex before = build(mesh);
    const State state = perturbed(before, 0.1);
    const EditedMesh first = apply(mesh, MeshEdit::delete_face(0)).value();
    const EditedMesh second = apply(first.mesh, MeshEdit::collapse(first.mesh.find_edge(12, 13))).value();
    const EditedMesh third = apply(second.mesh, MeshEdit::split_edge(second.mesh.find_edge(20, 26))).value();
    const ElementMap edited = composed(composed(first.map, second.map), third.map);
    const TangentComplex after = build(third.mesh);
    const State moved = transfer(before, state, after, &edited);

    int kept_points = 0, kept_planes = 0, fresh_points = 0;
    const IndexMap& planes = plane_origins(edited, after.kind);
    std::map<int, int> plane_before;
    for (int k = 0; k < before.plane_count(); ++k) plane_before[before.plane_origin[k]] = k;
    for (int i = 0; i < after.plane_count(); ++i) {
      const int old = planes.to_old[static_cast<size_t>(after.plane_origin[i])];
      EXPECT_EQ(moved.n.row(i), old < 0 ? after.normals.row(i) : state.n.row(plane_before.at(old)));
      kept_planes += old >= 0;
    }
    for (int j = 0; j < after.point_count(); ++j) {
      const auto [kind, element] = after.point_origin[j];
      const int old = point_origins(edited, kind).to_old[static_cast<size_t>(element)];
      const auto at =
          std::find(before.point_origin.begin(), before.point_origin.end(), PointOrigin{kind, old});
      const bool fresh = moved.x.row(j) == after.preferred.row(j);
      if (!fresh) {
        ASSERT_NE(at, before.point_origin.end());
        const auto k = at - before.point_origin.begin();
        const Eigen::RowVector3d there = state.x.row(k) + (before.origin - after.origin).transpose();
        EXPECT_NEAR((moved.x.row(j) - there).norm(), 0.0, 1e-13);
      }
      (fresh ? fresh_points : kept_points) += 1;
    }
    EXPECT_GE(kept_planes, before.plane_count() - 3);
    EXPECT_GT(fresh_points, 0);
    EXPECT_LE(fresh_points, 16);
    EXPECT_GT(kept_points, after.point_count() / 2);
  }
}

TEST(Transfer, BetweenKindsStartsAfresh) {
  const PolygonMesh mesh = cube().mesh();
  const TangentComplex dual = build_dual(mesh).value(), planarize = build_planarize(mesh).value();
  const State moved = transfer(dual, perturbed(dual, 0.1), planarize);
  EXPECT_TRUE(same_bits(moved.x, planarize.preferred));
  EXPECT_TRUE(same_bits(moved.n, planarize.normals));
  EXPECT_TRUE(same_bits(moved.h, planarize.offsets));
}

}  // namespace
}  // namespace planewright
