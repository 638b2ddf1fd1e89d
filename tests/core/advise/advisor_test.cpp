#include "core/advise/advisor.h"

#include <gtest/gtest.h>

#include "core/diagnose/diagnosis.h"
#include "core/mesh/sample_shapes.h"
#include "core/problem/demands/demand_catalogue.h"
#include "support/advised.h"

namespace planewright {
namespace {

using test::BadDome;
using test::solved;

TEST(Advisor, RatesUnderEveryKindOfDemand) {
  const PolygonMesh mesh = make_sample("dome", 100).value();
  for (const DemandInfo& info : demand_catalogue()) {
    if (!info.for_dual || info.name == "coplanar-beams") continue;
    LayerSettings settings;
    settings.demands.list.push_back({info.name, true, {}, {}});
    const Advised advised = solved(mesh, settings);
    const auto solver = PatchSolver::create(advised);
    ASSERT_TRUE(solver.has_value()) << info.name;
    for (int e = 0; e < mesh.edge_count(); e += 7)
      for (const Candidate& candidate : candidates_at(advised, e, true)) {
        const auto ground = solver->prepare(candidate.centre, 2);
        ASSERT_TRUE(ground.has_value()) << info.name << ", edge " << e << ": " << ground.error().text();
        EXPECT_TRUE(solver->attempt(*ground, candidate.edit).has_value()) << info.name << ", edge " << e;
      }
  }
}

TEST(Advisor, GainsWhereEdgesWereFlippedTheWrongWay) {
  const PolygonMesh mesh = make_sample("bad-saddle").value();
  const Advised advised = solved(mesh);
  const auto solver = PatchSolver::create(advised).value();
  std::vector<Candidate> candidates;
  const auto places = planted_places("bad-saddle").value();
  for (const PlantedPlace& place : places)
    for (const int edge : place.edges)
      for (Candidate& candidate : candidates_at(advised, edge, false))
        candidates.push_back(std::move(candidate));
  ASSERT_GE(candidates.size(), places.size());
  int told = 0;
  const auto suggestions = rate(solver, candidates, {}, [&](const Suggestion&) { ++told; });
  EXPECT_GT(2 * suggestions.size(), places.size());  // some cost next to nothing
  ASSERT_FALSE(suggestions.empty());
  EXPECT_GT(suggestions.front().gain(), 0.3);
  EXPECT_EQ(told, static_cast<int>(suggestions.size()));
  for (size_t k = 1; k < suggestions.size(); ++k) EXPECT_GE(suggestions[k - 1].gain(), suggestions[k].gain());
}

TEST(Advisor, AFlipAndItsReturnGainTheSameWithOppositeSigns) {
  const BadDome dome;
  ASSERT_GE(dome.edge, 0);
  PolygonMesh clean = dome.mesh;
  clean.flip(dome.edge);
  double gains[2];
  for (int way = 0; way < 2; ++way) {
    const Advised advised = solved(way == 0 ? dome.mesh : clean);
    const auto rated = rate(PatchSolver::create(advised).value(), candidates_at(advised, dome.edge, false),
                            {.radius = 3, .least_gain = -1e9});
    ASSERT_EQ(rated.size(), 1u);
    gains[way] = rated.front().gain() + rated.front().candidate.deviation;
  }
  EXPECT_GT(gains[0], 0.0);
  EXPECT_NEAR(gains[0], -gains[1], 0.3 * gains[0]);
}

TEST(Advisor, GivesEqualListsForEqualInput) {
  const BadDome dome;
  const Advised advised = solved(dome.mesh);
  const auto candidates = find_candidates(advised, diagnose(*advised.complex, advised.state).findings);
  const auto first = rate(PatchSolver::create(advised).value(), candidates, {.least_gain = -1e9});
  const auto second = rate(PatchSolver::create(advised).value(), candidates, {.least_gain = -1e9});
  ASSERT_EQ(first.size(), second.size());
  for (size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(first[k].candidate.edit, second[k].candidate.edit);
    EXPECT_EQ(first[k].before, second[k].before);
    EXPECT_EQ(first[k].after, second[k].after);
  }
}

TEST(Advisor, StopsWhereItIsAsked) {
  const BadDome dome;
  const Advised advised = solved(dome.mesh);
  const auto solver = PatchSolver::create(advised).value();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(rate(solver, candidates_at(advised, dome.edge, true), {}, {}, stop.get_token()).empty());
}

TEST(Advisor, WeightsRankAnewWithoutASolve) {
  Suggestion small{{MeshEdit::flip(1), 1, {}}, {1.0, 0.0, 0.0, 0.0, 0.0}, {0.5, 0.0, 0.0, 0.0, 0.0}};
  Suggestion joined{{MeshEdit::join(2), 2, {}, 0.0, 1.0}, {0.0, 0.0, 2.0, 0.0, 0.0}, {}};
  EXPECT_DOUBLE_EQ(small.gain(), 0.5);
  EXPECT_DOUBLE_EQ(joined.gain(), 1.0 - 0.5);  // half of two short edges, less a join's cost
  std::vector<Suggestion> list{small, joined};
  rank(list, {.energy = 1.0, .short_edges = 5.0});
  EXPECT_EQ(list.front().candidate.mesh_edge, 2);
  rank(list, {.energy = 10.0, .short_edges = 0.5});
  EXPECT_EQ(list.front().candidate.mesh_edge, 1);
}

}  // namespace
}  // namespace planewright
