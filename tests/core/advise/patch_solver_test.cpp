#include "core/advise/patch_solver.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/advise/candidates.h"
#include "core/complex/cluster.h"
#include "core/diagnose/diagnosis.h"
#include "support/advised.h"
#include "support/clusters.h"
#include "support/complexes.h"

namespace planewright {
namespace {

using test::BadDome;
using test::planarizing;
using test::same_bits;
using test::solved;

TEST(PatchSolver, HoldsWhatIsOutsideBitForBit) {
  const BadDome dome;
  const Advised advised = solved(dome.mesh);
  const auto solver = PatchSolver::create(advised).value();
  const auto candidate = candidates_at(advised, dome.edge, false).at(0);
  const auto ground = solver.prepare(candidate.centre, 2).value();
  const Trial trial = solver.attempt(ground, candidate.edit).value();
  EXPECT_TRUE(trial.met);
  int held = 0;
  for (int i = 0; i < trial.complex->plane_count(); ++i) {
    const int v = trial.complex->plane_origin[static_cast<size_t>(i)];
    if (ground.patch.rings[static_cast<size_t>(v)] < 2) continue;  // a flip keeps the patch's vertices
    ++held;
    EXPECT_EQ(trial.state.n.row(i), ground.state.n.row(i));
  }
  EXPECT_GT(held, 5);
  // Points at the rim of the patch lie on fewer planes than in the whole, and are nobody's.
  const Vector off = incidence_residuals(*trial.complex, trial.state);
  for (int j = 0, row = 0; j < trial.complex->point_count(); ++j) {
    const auto planes = trial.complex->planes_of_point[j];
    const bool free = std::any_of(planes.begin(), planes.end(), [&](int i) {
      return ground.patch.rings[static_cast<size_t>(trial.complex->plane_origin[static_cast<size_t>(i)])] < 2;
    });
    for (size_t k = 0; k < planes.size(); ++k, ++row)
      if (free) {
        EXPECT_LE(std::abs(off[row]), 1e-9 * trial.complex->mean_edge);
      }
  }
}

// Planes and points that were held are the ground's to the last bit; those that were free meet.
void expect_held_and_planar(const PatchSolver::Ground& ground, const Trial& trial) {
  const TangentComplex& complex = *trial.complex;
  int held = 0, freed = 0;
  const Vector off = incidence_residuals(complex, trial.state);
  for (int i = 0; i < complex.plane_count(); ++i) {
    if (trial.free_planes[static_cast<size_t>(i)]) {
      ++freed;
      continue;
    }
    ++held;
    const Trial& before = ground.as_it_is;
    const int origin = complex.plane_origin[static_cast<size_t>(i)];
    const IndexMap& whole =
        complex.kind == ComplexKind::Dual ? trial.from_whole.vertices : trial.from_whole.faces;
    const IndexMap& patch =
        complex.kind == ComplexKind::Dual ? before.from_whole.vertices : before.from_whole.faces;
    const int there = patch.to_new[static_cast<size_t>(whole.to_old[static_cast<size_t>(origin)])];
    const auto& origins = ground.complex->plane_origin;
    const auto k = std::find(origins.begin(), origins.end(), there) - origins.begin();
    EXPECT_EQ(trial.state.n.row(i), ground.state.n.row(k)) << "panel of " << origin;
    EXPECT_EQ(trial.state.n.row(i), before.state.n.row(k)) << "panel of " << origin;
  }
  EXPECT_GT(held, 3);
  EXPECT_GT(freed, 3);
  for (int j = 0, row = 0; j < complex.point_count(); ++j)
    for (size_t k = 0; k < complex.planes_of_point[j].size(); ++k, ++row)
      if (trial.free_points[static_cast<size_t>(j)]) {
        EXPECT_LE(std::abs(off[row]), 1e-9 * complex.mean_edge) << "point " << j;
      }
}

TEST(PatchSolver, TriesEveryKindOfEditOfADual) {
  const BadDome dome;
  const Advised advised = solved(dome.mesh);
  const auto solver = PatchSolver::create(advised).value();
  const MeshEdge edge = dome.mesh.edge(dome.edge);
  std::vector<int> centre{edge.a, edge.b};
  for (const int face : {edge.left, edge.right})
    for (const int v : dome.mesh.corners(face))
      if (v != edge.a && v != edge.b) centre.push_back(v);
  const auto ground = solver.prepare(centre, 2).value();
  EXPECT_TRUE(ground.as_it_is.met);
  for (const MeshEdit& edit : {MeshEdit::flip(dome.edge), MeshEdit::join(dome.edge),
                               MeshEdit::split_edge(dome.edge), MeshEdit::collapse(dome.edge)}) {
    SCOPED_TRACE(describe(edit));
    const Trial trial = solver.attempt(ground, edit).value();
    EXPECT_TRUE(trial.met);
    expect_held_and_planar(ground, trial);
  }
}

TEST(PatchSolver, TriesEditsOfPlanarizedQuads) {
  const PolygonMesh mesh = make_sample("turning-strip", 300).value();
  const Advised advised = solved(mesh, planarizing());
  const auto solver = PatchSolver::create(advised).value();
  const auto candidates = find_candidates(advised, diagnose(*advised.complex, advised.state).findings);
  ASSERT_FALSE(candidates.empty());
  double best = 0.0;
  for (const Candidate& candidate : candidates) {
    SCOPED_TRACE(describe(candidate.edit));
    const auto ground = solver.prepare(candidate.centre, 2).value();
    const Trial trial = solver.attempt(ground, candidate.edit).value();
    EXPECT_TRUE(trial.met);
    expect_held_and_planar(ground, trial);
    best = std::max(best, total(ground.as_it_is.score) - total(trial.score));
  }
  EXPECT_GT(best, 0.5);
}

TEST(PatchSolver, MovesAVertexOfPlanarizedQuads) {
  // A vertex pushed out of the middle of its neighbours, and back again.
  test::Shape shape = test::twisted_grid(7, 7, 0.02);
  const int v = 3 * 8 + 3;
  const Vector3d middle = shape.positions.row(v);
  shape.positions.row(v) += Vector3d(0.45, 0.3, 0.0).transpose();
  const Advised advised = solved(shape.mesh(), planarizing());
  const auto solver = PatchSolver::create(advised).value();
  const auto ground = solver.prepare({v}, 2).value();
  const Trial trial = solver.attempt(ground, MeshEdit::move_vertex(v, middle)).value();
  EXPECT_TRUE(trial.met);
  expect_held_and_planar(ground, trial);
  // Panels and points are wanted where the moved vertex has them.
  const auto from = ground.patch.from_whole.vertices.to_new[static_cast<size_t>(v)];
  for (int j = 0; j < trial.complex->point_count(); ++j)
    if (trial.complex->point_origin[static_cast<size_t>(j)].element == from) {
      EXPECT_LT((trial.complex->preferred.row(j).transpose() + trial.complex->origin - middle).norm(), 1e-12);
    }
}

TEST(PatchSolver, TriesEditsUnderDemands) {
  // What is held outside is no demand that another could contradict.
  for (const char* name : {"uncrossed", "convex"}) {
    SCOPED_TRACE(name);
    LayerSettings settings = planarizing();
    settings.demands.list = {{name}};
    const Advised advised = solved(make_sample("turning-strip", 300).value(), settings);
    const auto solver = PatchSolver::create(advised).value();
    const auto candidates = find_candidates(advised, diagnose(*advised.complex, advised.state).findings);
    ASSERT_FALSE(candidates.empty());
    for (const Candidate& candidate : candidates) {
      SCOPED_TRACE(describe(candidate.edit));
      const auto ground = solver.prepare(candidate.centre, 2);
      ASSERT_TRUE(ground) << ground.error().text();
      EXPECT_TRUE(ground->as_it_is.met);
      expect_held_and_planar(*ground, solver.attempt(*ground, candidate.edit).value());
    }
  }
}

TEST(PatchSolver, TriesEditsOfADualInFrontOfItsMesh) {
  LayerSettings settings;
  settings.demands.list = {{"vertex"}, {"face"}};
  const BadDome dome;
  const Advised advised = solved(dome.mesh, settings);
  const auto solver = PatchSolver::create(advised).value();
  const auto candidate = candidates_at(advised, dome.edge, false).at(0);
  const auto ground = solver.prepare(candidate.centre, 2);
  ASSERT_TRUE(ground) << ground.error().text();
  expect_held_and_planar(*ground, solver.attempt(*ground, candidate.edit).value());
}

TEST(PatchSolver, GivesTheSameBitsForTheSameEdit) {
  const BadDome dome;
  const Advised advised = solved(dome.mesh);
  const auto candidate = candidates_at(advised, dome.edge, false).at(0);
  std::vector<Trial> trials;
  for (int run = 0; run < 2; ++run) {
    const auto solver = PatchSolver::create(advised).value();
    trials.push_back(solver.attempt(solver.prepare(candidate.centre, 2).value(), candidate.edit).value());
  }
  EXPECT_TRUE(same_bits(trials[0].state.n, trials[1].state.n));
  EXPECT_TRUE(same_bits(trials[0].state.x, trials[1].state.x));
  EXPECT_EQ(trials[0].score, trials[1].score);
}

TEST(PatchSolver, AnEditThatTheMeshRefusesFails) {
  const BadDome dome;
  const Advised advised = solved(dome.mesh);
  const auto solver = PatchSolver::create(advised).value();
  int border = 0;
  while (!dome.mesh.edge(border).border()) ++border;
  const auto ground = solver.prepare({dome.mesh.edge(border).a, dome.mesh.edge(border).b}, 2).value();
  const auto trial = solver.attempt(ground, MeshEdit::flip(border));
  ASSERT_FALSE(trial);
  EXPECT_EQ(trial.error().code, ErrorCode::Refused);
}

TEST(PatchSolver, RefusesPanelsOfClusters) {
  const PolygonMesh mesh = test::sphere(6).mesh();
  const FaceGraph graph = test::graph_of(mesh);
  ClusterOptions options;
  options.panels = 12;
  const Regions regions = make_regions(graph, cluster(graph, options).value()).value();
  Advised advised;
  advised.mesh = std::make_shared<const PolygonMesh>(mesh);
  advised.complex = std::make_shared<const TangentComplex>(build_cluster(mesh, regions).value());
  advised.state = initial_state(*advised.complex);
  advised.settings.mode = ComplexKind::Cluster;
  const auto solver = PatchSolver::create(advised);
  ASSERT_FALSE(solver);
  EXPECT_EQ(solver.error().code, ErrorCode::Refused);
  EXPECT_NE(solver.error().text().find("clusters"), std::string::npos);
}

}  // namespace
}  // namespace planewright
