#include "core/advise/improve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "core/advise/candidates.h"
#include "core/diagnose/planarity.h"
#include "core/edit/element_names.h"
#include "support/advised.h"
#include "support/complexes.h"

namespace planewright {
namespace {

using test::planarizing;
using test::same_bits;
using test::solved;

// Keeps what it is told; `on_rating` and `after_round` may ask for more.
class Watcher final : public ImproveObserver {
 public:
  void on_rated(int, int rated, int of) override {
    EXPECT_LT(rated, of);
    if (on_rating) on_rating();
  }
  void on_round(int round, const ImproveReport::Round& result, const DesignMeasure& now) override {
    rounds.push_back(result);
    measures.push_back(now);
    EXPECT_EQ(round, static_cast<int>(rounds.size()));
    if (after_round) after_round();
  }
  std::function<void()> on_rating, after_round;
  std::vector<ImproveReport::Round> rounds;
  std::vector<DesignMeasure> measures;  // after each
};

ImproveReport improved(const Advised& design, const ImproveOptions& options, Watcher* watcher = nullptr,
                       std::stop_token stop = {}) {
  const auto solver = make_solver(SolverKind::Tangent);
  return improve(*solver, design, options, watcher, std::move(stop)).value();
}
ImproveReport improved(const Advised& design, Watcher* watcher = nullptr, std::stop_token stop = {}) {
  const ImproveOptions options;
  return improved(design, options, watcher, std::move(stop));
}

DesignMeasure measured(const Advised& design) {
  return measure_design(design, diagnose(*design.complex, design.state)).value();
}

double planarity(const Advised& design) {
  const Panels panels = panels_of(*design.complex, design.state);
  return measure_planarity(panels.points, panels.polygons).max_relative_to_bbox;
}

int count(const ImproveReport& report, const std::string& verb) {
  return static_cast<int>(
      std::count_if(report.applied.begin(), report.applied.end(),
                    [&](const ImproveReport::Applied& edit) { return edit.what.starts_with(verb); }));
}

// What a report promises, whatever the design.
void expect_honest(const Advised& design, const ImproveReport& report) {
  EXPECT_EQ(report.before.score, measured(design).score);
  EXPECT_EQ(report.before.findings, measured(design).findings);
  EXPECT_EQ(report.after.score, measured(report.design).score);
  EXPECT_EQ(report.after.findings, measured(report.design).findings);
  EXPECT_LE(total(report.after.score), total(report.before.score));
  EXPECT_LE(report.after.unbuildable(), report.before.unbuildable());
  EXPECT_LE(planarity(report.design), 1e-9);
  EXPECT_EQ(report.design.complex->mean_edge, design.complex->mean_edge);
  EXPECT_EQ(report.after.panels, report.design.complex->plane_count());
  int edits = 0;
  double predicted = 0.0, gained = 0.0;
  for (const ImproveReport::Round& round : report.rounds) {
    edits += round.edits;
    predicted += round.predicted;
    gained += round.gained;
  }
  EXPECT_EQ(edits, static_cast<int>(report.applied.size()));
  EXPECT_NEAR(gained, total(report.before.score) - total(report.after.score), 1e-9);
  for (const ImproveReport::Applied& edit : report.applied) predicted -= edit.predicted;
  EXPECT_NEAR(predicted, 0.0, 1e-9);
}

// `map` is that of the edits: what lives on has kept its place, and its ends.
void expect_map_leads(const Advised& design, const ImproveReport& report) {
  const PolygonMesh &before = *design.mesh, &after = *report.design.mesh;
  const ElementMap& map = report.map;
  ASSERT_EQ(static_cast<int>(map.vertices.to_new.size()), before.vertex_count());
  ASSERT_EQ(static_cast<int>(map.vertices.to_old.size()), after.vertex_count());
  ASSERT_EQ(static_cast<int>(map.edges.to_old.size()), after.edge_count());
  ASSERT_EQ(static_cast<int>(map.faces.to_old.size()), after.face_count());
  int moved = 0, turned = 0;
  for (int v = 0; v < before.vertex_count(); ++v)
    if (const int now = map.vertices.to_new[static_cast<size_t>(v)]; now >= 0)
      moved += before.positions().row(v) != after.positions().row(now);
  for (int e = 0; e < after.edge_count(); ++e) {
    const MeshEdge here = after.edge(e);
    const int old = map.edges.to_old[static_cast<size_t>(e)];
    ASSERT_GE(old, 0);  // flips, joins and collapses make no edge
    const MeshEdge there = before.edge(old);
    const auto was = [&](int v) { return map.vertices.to_old[static_cast<size_t>(v)]; };
    turned += std::minmax(was(here.a), was(here.b)) != std::minmax(there.a, there.b);
  }
  const int collapses = count(report, "Collapse");
  EXPECT_LE(moved, collapses);  // the survivors, each to the middle of its edge
  if (collapses == 0) {
    EXPECT_EQ(turned, count(report, "Flip"));
  }
}

// The mesh that the named edits make of the one before, by nothing but their names.
PolygonMesh by_names(const PolygonMesh& mesh, const ImproveReport& report) {
  ElementNumbering numbering(mesh);
  ElementIds ids = numbering.opened();
  PolygonMesh now = mesh;
  for (const ImproveReport::Applied& applied : report.applied) {
    const int number = std::stoi(applied.what.substr(applied.what.rfind(' ') + 1));
    const auto edge =
        static_cast<int>(std::find(ids.edges.begin(), ids.edges.end(), number) - ids.edges.begin());
    const MeshEdit edit = applied.what.starts_with("Flip")   ? MeshEdit::flip(edge)
                          : applied.what.starts_with("Join") ? MeshEdit::join(edge)
                                                             : MeshEdit::collapse(edge);
    EditedMesh next = apply(now, edit).value();
    ids = numbering.edited(ids, next.map);
    now = std::move(next.mesh);
  }
  return now;
}

TEST(Improve, LeavesNothingOfABadSaddleThatCannotBeBuilt) {
  const Advised design = solved(make_sample("bad-saddle", 300).value());
  Watcher watcher;
  const ImproveReport report = improved(design, &watcher);
  expect_honest(design, report);
  expect_map_leads(design, report);
  EXPECT_GT(report.before.unbuildable(), 0);
  EXPECT_EQ(report.after.unbuildable(), 0);
  EXPECT_TRUE(report.left.empty());
  EXPECT_FALSE(report.stopped);
  EXPECT_TRUE(report.solve.status == SolveStatus::Converged || report.solve.status == SolveStatus::Planar);
  // B falls in every round that is kept, and by what is told.
  ASSERT_EQ(watcher.rounds.size(), report.rounds.size());
  double score = total(report.before.score);
  int unbuildable = report.before.unbuildable();
  for (size_t k = 0; k < watcher.rounds.size(); ++k) {
    const double now = total(watcher.measures[k].score);
    EXPECT_NEAR(score - now, watcher.rounds[k].gained, 1e-12);
    if (watcher.rounds[k].edits > 0) {
      EXPECT_GT(score - now, 1e-3);
    } else {
      EXPECT_EQ(score, now);
    }
    EXPECT_LE(watcher.measures[k].unbuildable(), unbuildable);
    score = now;
    unbuildable = watcher.measures[k].unbuildable();
  }
}

TEST(Improve, CollapsesTheQuadsAtTheTurnsOfAStrip) {
  const Advised design = solved(make_sample("turning-strip", 300).value(), planarizing());
  const ImproveReport report = improved(design);
  expect_honest(design, report);
  expect_map_leads(design, report);
  const auto quads = static_cast<size_t>(FindingKind::CollapsedQuad);
  EXPECT_GT(report.before.findings[quads], 0);
  EXPECT_EQ(report.after.findings[quads], 0);
  EXPECT_GT(count(report, "Collapse"), 0);
}

// A saddle one of whose edges runs the wrong way.
PolygonMesh saddle_with_wrong(int edge) {
  PolygonMesh mesh = make_sample("saddle", 200).value();
  EXPECT_TRUE(mesh.flip(edge));
  return mesh;
}

TEST(Improve, FlipsAnEdgeBackThatRunsTheWrongWay) {
  constexpr int kWrong = 120;
  const Advised design = solved(saddle_with_wrong(kWrong));
  const ImproveReport report = improved(design);
  expect_honest(design, report);
  expect_map_leads(design, report);
  EXPECT_GT(report.before.unbuildable(), 0);
  EXPECT_EQ(report.after.unbuildable(), 0);
  ASSERT_EQ(report.applied.size(), 1u);
  EXPECT_EQ(report.applied.front().what, "Flip edge " + std::to_string(kWrong));
  EXPECT_EQ(report.applied.front().round, 1);
  EXPECT_NEAR(total(report.after.score), total(measured(solved(make_sample("saddle", 200).value())).score),
              0.05);
}

TEST(Improve, SplitsAsALastResort) {
  const Advised design = solved(saddle_with_wrong(247));
  const ImproveReport report = improved(design);
  expect_honest(design, report);
  EXPECT_GT(report.before.unbuildable(), 0);
  EXPECT_EQ(report.after.unbuildable(), 0);
  ASSERT_EQ(report.applied.size(), 1u);
  EXPECT_EQ(report.applied.front().what.substr(0, 10), "Split edge");
  EXPECT_EQ(report.after.panels, report.before.panels + 1);
  const std::vector<int>& from = report.map.vertices.to_old;
  EXPECT_EQ(std::count(from.begin(), from.end(), -1), 1);
}

TEST(Improve, EditsNothingOfACleanDesign) {
  for (const auto& [name, settings] :
       std::map<std::string, LayerSettings>{{"saddle", {}}, {"straight-strip", planarizing()}}) {
    SCOPED_TRACE(name);
    const Advised design = solved(make_sample(name, 300).value(), settings);
    const ImproveReport report = improved(design);
    EXPECT_EQ(report.before.unbuildable(), 0);
    EXPECT_TRUE(report.applied.empty());
    EXPECT_TRUE(report.left.empty());
    EXPECT_EQ(report.map, identity_map(*design.mesh));
    EXPECT_TRUE(same_bits(report.design.state.x, design.state.x));
  }
}

TEST(Improve, HoldsItsHandsOffAFlatPatchThatNoEditBetters) {
  const Advised design = solved(make_sample("flat-patch-dome", 200).value());
  ASSERT_GT(measured(design).findings[static_cast<size_t>(FindingKind::IllDetermined)], 0);
  const ImproveReport report = improved(design);
  expect_honest(design, report);
  EXPECT_EQ(report.after.unbuildable(), 0);
}

TEST(Improve, NamesElementsByTheirNumbersInTheMeshAsItCame) {
  // Joins and collapses renumber edges between the rounds, and within a batch.
  const std::vector<Advised> designs{solved(make_sample("bad-saddle", 300).value()),
                                     solved(make_sample("turning-strip", 300).value(), planarizing())};
  for (const Advised& design : designs) {
    const ImproveReport report = improved(design);
    ASSERT_GT(report.applied.back().round, report.applied.front().round);
    const PolygonMesh replayed = by_names(*design.mesh, report);
    EXPECT_EQ(replayed.faces(), report.design.mesh->faces());
    EXPECT_EQ(replayed.positions(), report.design.mesh->positions());
  }
}

TEST(Improve, GivesTheSameBitsTwice) {
  const Advised design = solved(make_sample("bad-saddle", 300).value());
  ImproveOptions options;
  options.max_edits = 2;
  const ImproveReport first = improved(design, options), second = improved(design, options);
  ASSERT_EQ(first.applied.size(), second.applied.size());
  for (size_t k = 0; k < first.applied.size(); ++k) {
    EXPECT_EQ(first.applied[k].what, second.applied[k].what);
    EXPECT_EQ(first.applied[k].predicted, second.applied[k].predicted);
  }
  EXPECT_EQ(first.after.score, second.after.score);
  EXPECT_EQ(first.map, second.map);
  EXPECT_TRUE(same_bits(first.design.state.x, second.design.state.x));
  EXPECT_TRUE(same_bits(first.design.state.n, second.design.state.n));
}

TEST(Improve, DoesNoMoreEditsThanAsked) {
  const Advised design = solved(make_sample("turning-strip", 300).value(), planarizing());
  double score = total(measured(design).score);
  for (const int most : {1, 4}) {
    ImproveOptions options;
    options.max_edits = most;
    const ImproveReport report = improved(design, options);
    expect_honest(design, report);
    EXPECT_EQ(static_cast<int>(report.applied.size()), most);
    EXPECT_LT(total(report.after.score), score);
    score = total(report.after.score);
  }
}

TEST(Improve, ListsWhatIsLeftWithAllThatWasTried) {
  const Advised design = solved(make_sample("bad-saddle", 300).value());
  ImproveOptions options;
  options.max_edits = 0;
  const ImproveReport report = improved(design, options);
  expect_honest(design, report);
  EXPECT_TRUE(report.applied.empty());
  EXPECT_TRUE(report.rounds.empty());
  EXPECT_EQ(report.map, identity_map(*design.mesh));
  ASSERT_EQ(static_cast<int>(report.left.size()), report.before.unbuildable());
  ASSERT_FALSE(report.left.empty());
  for (const ImproveReport::Left& left : report.left) {
    EXPECT_TRUE(is_unbuildable(left.finding.kind));
    EXPECT_LT(left.angle_defect, 0.0);  // of a saddle
    EXPECT_GT(left.angle_defect, -90.0);
    // Every flip, join, split and collapse at the edges and at those beside them, each once.
    std::set<int> edges;
    for (const int e : left.finding.mesh_edges) {
      const MeshEdge edge = design.mesh->edge(e);
      for (const int face : {edge.left, edge.right}) {
        if (face < 0) continue;
        const std::vector<int> corners = design.mesh->corners(face);
        for (size_t k = 0; k < corners.size(); ++k)
          edges.insert(design.mesh->find_edge(corners[k], corners[(k + 1) % corners.size()]));
      }
    }
    std::set<std::string> expected, tried;
    for (const int e : edges)
      for (const MeshEdit& edit :
           {MeshEdit::flip(e), MeshEdit::join(e), MeshEdit::split_edge(e), MeshEdit::collapse(e)})
        expected.insert(describe(edit));
    for (const ImproveReport::Tried& each : left.tried) {
      EXPECT_TRUE(tried.insert(each.what).second) << each.what << " twice";
      EXPECT_NE(each.gain.has_value(), !each.refused.empty()) << each.what;
    }
    EXPECT_EQ(tried, expected);
  }
}

TEST(Improve, AStopBeforeItBeginsGivesTheDesignAsItIs) {
  const Advised design = solved(make_sample("bad-saddle", 300).value());
  std::stop_source stop;
  stop.request_stop();
  const ImproveReport report = improved(design, nullptr, stop.get_token());
  EXPECT_TRUE(report.stopped);
  expect_honest(design, report);
  EXPECT_TRUE(report.applied.empty());
  EXPECT_TRUE(report.left.empty());
  EXPECT_TRUE(same_bits(report.design.state.x, design.state.x));
}

TEST(Improve, AStopOnTheWayKeepsWhatWasReached) {
  const Advised design = solved(make_sample("turning-strip", 300).value(), planarizing());
  {
    std::stop_source stop;
    Watcher watcher;
    watcher.after_round = [&] { stop.request_stop(); };
    const ImproveReport report = improved(design, &watcher, stop.get_token());
    EXPECT_TRUE(report.stopped);
    EXPECT_EQ(report.rounds.size(), 1u);
    EXPECT_GT(report.applied.size(), 0u);
    expect_honest(design, report);
    expect_map_leads(design, report);
  }
  {
    std::stop_source stop;
    Watcher watcher;
    watcher.on_rating = [&] { stop.request_stop(); };
    const ImproveReport report = improved(design, &watcher, stop.get_token());
    EXPECT_TRUE(report.stopped);
    EXPECT_TRUE(report.applied.empty());
    expect_honest(design, report);
  }
}

TEST(Improve, SelectionsFollowAndWhatIsGoneIsNamed) {
  const PolygonMesh mesh = make_sample("turning-strip", 300).value();
  const ImproveReport plain = improved(solved(mesh, planarizing()));
  const std::vector<int>& now = plain.map.vertices.to_new;
  const auto gone = static_cast<int>(std::find(now.begin(), now.end(), -1) - now.begin());
  ASSERT_LT(gone, mesh.vertex_count());
  const int stays = mesh.vertex_count() - 1;
  const Selection lost{"lost", {gone}, {}, {}}, kept{"kept", {gone, stays}, {}, {7}};
  const ImproveReport report = improved(solved(mesh, planarizing(), {lost, kept}));
  ASSERT_EQ(report.map, plain.map);
  ASSERT_EQ(report.design.selections.size(), 1u);
  EXPECT_NE(now[static_cast<size_t>(stays)], stays);
  const Selection expected{"kept", {now[static_cast<size_t>(stays)]}, {}, {plain.map.faces.to_new[7]}};
  EXPECT_EQ(report.design.selections.front(), expected);
  const auto told = [&](const std::string& words) {
    return std::any_of(report.dropped.begin(), report.dropped.end(),
                       [&](const std::string& line) { return line.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(told("lost"));
  EXPECT_TRUE(told("kept"));
}

TEST(Improve, PinsFollowAndHold) {
  const PolygonMesh mesh = make_sample("turning-strip", 300).value();
  const int pinned = mesh.vertex_count() - 1;
  LayerSettings settings = planarizing();
  const Vector3d at = mesh.positions().row(pinned).transpose() + Vector3d(0.0, 0.0, 0.02);
  settings.demands.pins = {{{PointKind::Vertex, pinned}, {at.x(), at.y(), at.z()}}};
  const Advised design = solved(mesh, settings);
  const ImproveReport report = improved(design);
  expect_honest(design, report);
  ASSERT_GT(report.applied.size(), 0u);
  ASSERT_EQ(report.design.settings.demands.pins.size(), 1u);
  const PointOrigin now = report.design.settings.demands.pins.front().point;
  EXPECT_EQ(now.element, report.map.vertices.to_new[static_cast<size_t>(pinned)]);
  EXPECT_NE(now.element, pinned);  // vertices before it are gone
  const TangentComplex& complex = *report.design.complex;
  for (int j = 0; j < complex.point_count(); ++j)
    if (complex.point_origin[static_cast<size_t>(j)] == now) {
      EXPECT_LT((report.design.state.x.row(j).transpose() + complex.origin - at).norm(), 1e-9);
    }
}

TEST(Improve, FailsWhereThereIsNoProblemToSolve) {
  Advised design = solved(make_sample("dome", 100).value());
  design.settings.demands.list = {{"vertex", true, "nowhere", {}}};
  const auto solver = make_solver(SolverKind::Tangent);
  EXPECT_FALSE(improve(*solver, design, ImproveOptions()));
}

}  // namespace
}  // namespace planewright
