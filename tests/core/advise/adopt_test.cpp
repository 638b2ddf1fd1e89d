#include "core/advise/adopt.h"

#include <gtest/gtest.h>

#include "core/advise/advisor.h"
#include "core/advise/edit_plan.h"
#include "support/advised.h"

namespace planewright {
namespace {

using test::BadDome;
using test::solved;

double off_plane(const TangentComplex& complex, const State& state) {
  return incidence_residuals(complex, state).lpNorm<Eigen::Infinity>() / complex.mean_edge;
}

TEST(Adopt, ATrialIsAPlanarStartForTheWhole) {
  const BadDome dome;
  const Advised advised = solved(dome.mesh);
  const auto solver = PatchSolver::create(advised).value();
  const auto candidate = candidates_at(advised, dome.edge, false).at(0);
  const Trial trial = solver.attempt(solver.prepare(candidate.centre, 2).value(), candidate.edit).value();
  const EditedMesh edited = apply(*advised.mesh, candidate.edit).value();
  const auto complex = build_complex(edited.mesh, advised.settings).value();
  const State state = adopt(advised, {trial}, *complex, edited.map);
  EXPECT_LE(off_plane(*complex, state), 1e-9);
}

TEST(Adopt, TakesOverSeveralTrialsAtOnce) {
  const PolygonMesh mesh = make_sample("dome", 600).value();
  const Advised advised = solved(mesh);
  const auto solver = PatchSolver::create(advised).value();
  // Joins and flips in turn, as many as lie apart: faces are renumbered on the way.
  std::vector<Suggestion> possible;
  for (int e = 0; e < mesh.edge_count(); ++e)
    for (const Candidate& candidate : candidates_at(advised, e, true))
      if ((candidate.edit.kind == EditKind::Join) == (e % 2 == 0)) possible.push_back({candidate, {}, {}});
  std::vector<Trial> trials;
  EditedMesh edited{mesh, identity_map(mesh)};
  int joins = 0;
  for (const int k : choose_apart(mesh, possible)) {
    const Candidate& candidate = possible[static_cast<size_t>(k)].candidate;
    joins += candidate.edit.kind == EditKind::Join;
    trials.push_back(solver.attempt(solver.prepare(candidate.centre, 2).value(), candidate.edit).value());
    ASSERT_TRUE(trials.back().met);
    const EditedMesh next = apply(edited.mesh, renumbered(candidate.edit, edited.map)).value();
    edited = {next.mesh, composed(edited.map, next.map)};
  }
  ASSERT_GE(trials.size(), 4u);
  EXPECT_GE(joins, 1);
  EXPECT_LT(joins, static_cast<int>(trials.size()));
  const auto complex = build_complex(edited.mesh, advised.settings).value();
  const State state = adopt(advised, trials, *complex, edited.map);
  EXPECT_LE(off_plane(*complex, state), 1e-9);
  // One trial less, and its points are off.
  trials.pop_back();
  EXPECT_GT(off_plane(*complex, adopt(advised, trials, *complex, edited.map)), 1e-6);
}

TEST(Adopt, OfNoTrialIsTheStateBefore) {
  const Advised advised = solved(BadDome().mesh);
  const State state = adopt(advised, {}, *advised.complex, identity_map(*advised.mesh));
  EXPECT_EQ(state.x, advised.state.x);
  EXPECT_EQ(state.n, advised.state.n);
  EXPECT_EQ(state.h, advised.state.h);
}

}  // namespace
}  // namespace planewright
