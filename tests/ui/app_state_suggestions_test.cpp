// Suggestions in the window's state: rated in the background, best first, and applied as steps of undo.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "ui/app_state.h"
#include "ui/suggestion_text.h"

namespace planewright::ui {
namespace {

using namespace std::chrono_literals;

// Runs frames until `over`; false after a minute.
template <class Over>
bool frames_until(AppState& state, Over over) {
  const auto limit = Clock::now() + 60s;
  while (!over()) {
    if (Clock::now() > limit) return false;
    state.update(Clock::now());
    std::this_thread::sleep_for(1ms);
  }
  return true;
}
bool settle(AppState& state) {
  return frames_until(state, [&] { return !state.document().empty() && state.settled(); });
}
bool all_rated(AppState& state) {
  return settle(state) && frames_until(state, [&] { return state.advice_fits() && !state.rating(); });
}

std::vector<MeshEdit> edits_of(const Advice& advice) {
  std::vector<MeshEdit> edits;
  for (const Suggestion& suggestion : advice.ranked) edits.push_back(suggestion.candidate.edit);
  return edits;
}

TEST(AppStateSuggestions, ComeBestFirstWhileTheRestIsRated) {
  AppState state;
  EXPECT_FALSE(why_no_suggestions(state).empty());
  state.open_sample("bad-saddle");
  ASSERT_TRUE(settle(state));
  bool streamed = false;
  std::size_t most = 0;
  int tried = 0;
  ASSERT_TRUE(frames_until(state, [&] {
    if (!state.advice_fits()) return false;
    const Advice& advice = *state.advice();
    EXPECT_GE(advice.ranked.size(), most);
    EXPECT_GE(advice.tried, tried);
    for (std::size_t k = 1; k < advice.ranked.size(); ++k)
      EXPECT_GE(advice.ranked[k - 1].gain(), advice.ranked[k].gain());
    most = advice.ranked.size();
    tried = advice.tried;
    streamed = streamed || (state.rating() && tried > 0 && tried < advice.candidates);
    return advice.done;
  }));
  EXPECT_TRUE(streamed);
  EXPECT_GT(most, 2u);
  EXPECT_EQ(tried, state.advice()->candidates);
  EXPECT_TRUE(why_no_suggestions(state).empty());

  // The same as without a window.
  const auto& iterate = *state.shown()->iterate;
  const auto solver = PatchSolver::create({state.document().mesh(), iterate.complex, iterate.state,
                                           state.document().settings()})
                          .value();
  const auto ranked = rate(solver, find_candidates(solver.advised(), state.findings()->diagnosis.findings));
  ASSERT_EQ(ranked.size(), most);
  for (std::size_t k = 0; k < most; ++k) {
    EXPECT_EQ(ranked[k].candidate.edit, state.advice()->ranked[k].candidate.edit);
    EXPECT_EQ(ranked[k].gain(), state.advice()->ranked[k].gain());
  }
}

TEST(AppStateSuggestions, NameEachEditOnce) {
  AppState state;
  state.open_sample("turning-strip");
  ASSERT_TRUE(all_rated(state));
  const auto edits = edits_of(*state.advice());
  ASSERT_FALSE(edits.empty());
  for (std::size_t i = 0; i < edits.size(); ++i)
    EXPECT_EQ(std::count(edits.begin(), edits.end(), edits[i]), 1) << describe(edits[i]);
  EXPECT_EQ(edits.front().kind, EditKind::Collapse) << "of a quad that has become a triangle";
}

TEST(AppStateSuggestions, SayWhyThereAreNone) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(all_rated(state));
  EXPECT_EQ(state.suggestion_list().size(), 0);
  EXPECT_NE(why_no_suggestions(state).find("Nothing to suggest"), std::string::npos);
  state.set_auto_solve(false);
  ASSERT_TRUE(state.edit_mesh(MeshEdit::move_vertex(0, {0, 0, 1})));
  EXPECT_NE(why_no_suggestions(state).find("changed"), std::string::npos);
}

TEST(AppStateSuggestions, EndWithEveryChange) {
  AppState state;
  state.open_sample("bad-saddle");
  const auto rates = [&] { return state.rating() && state.advice()->tried > 0; };
  ASSERT_TRUE(frames_until(state, rates));
  LayerSettings settings = state.document().settings();
  settings.weights["fairing"] = 0.05;
  state.change_settings(std::move(settings), "Weight of fairing");
  EXPECT_FALSE(state.rating());
  EXPECT_FALSE(state.advice_fits());
  ASSERT_NE(state.advice(), nullptr) << "the mesh is still the same";
  ASSERT_TRUE(frames_until(state, rates));
  const int edge = state.finding_list().flagged.front().edge;
  ASSERT_TRUE(state.edit_mesh(MeshEdit::flip(edge)));
  EXPECT_FALSE(state.rating());
  EXPECT_EQ(state.advice(), nullptr);
  ASSERT_TRUE(frames_until(state, rates));
  state.undo();
  EXPECT_FALSE(state.rating());
  EXPECT_TRUE(all_rated(state));
}

TEST(AppStateSuggestions, ApplyingOneIsAStepAndUndoBringsAllBack) {
  AppState state;
  state.open_sample("bad-saddle");
  ASSERT_TRUE(all_rated(state));
  const auto mesh = state.document().mesh();
  const auto iterate = state.shown()->iterate;
  const auto before = edits_of(*state.advice());
  const Suggestion best = state.suggestion_list().at(0);
  const std::string name = state.edit_name(best.candidate.edit);
  state.walk_suggestions(1);
  EXPECT_EQ(state.current_suggestion(), 0);
  EXPECT_TRUE(state.take_look_at().has_value());
  ASSERT_NE(state.suggestion_at_hand(), nullptr);
  ASSERT_TRUE(state.apply_suggestion(*state.suggestion_at_hand()));
  EXPECT_TRUE(state.solving());
  EXPECT_EQ(state.document().history(), std::vector<std::string>{name});
  ASSERT_TRUE(all_rated(state));
  EXPECT_NE(edits_of(*state.advice()), before);
  state.undo();
  EXPECT_EQ(state.document().mesh(), mesh) << "the very mesh, bit for bit";
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown()->iterate, iterate);
  ASSERT_TRUE(frames_until(state, [&] { return state.advice_fits(); }));
  EXPECT_FALSE(state.rating()) << "what was found out is kept";
  EXPECT_EQ(edits_of(*state.advice()), before);
}

TEST(AppStateSuggestions, ApplyingAllIsOneStep) {
  AppState state;
  state.open_sample("bad-saddle");
  ASSERT_TRUE(all_rated(state));
  const auto mesh = state.document().mesh();
  const std::size_t together = state.suggestion_list().together.size();
  const auto found = state.findings()->diagnosis.findings.size();
  ASSERT_GT(together, 1u);
  ASSERT_TRUE(state.apply_all_suggestions());
  EXPECT_EQ(state.document().history(),
            std::vector<std::string>{"Apply " + std::to_string(together) + " suggestions"});
  ASSERT_TRUE(settle(state));
  EXPECT_LT(state.findings()->diagnosis.findings.size(), found);
  state.undo();
  EXPECT_EQ(state.document().mesh(), mesh);
  state.redo();
  EXPECT_NE(state.document().mesh(), mesh);
}

TEST(AppStateSuggestions, CanBeAppliedWhileASolveRuns) {
  AppState state;
  state.open_sample("bad-saddle");
  ASSERT_TRUE(all_rated(state));
  const Suggestion best = state.suggestion_list().at(0);
  LayerSettings settings = state.document().settings();
  settings.weights["fairing"] = 0.05;
  state.change_settings(std::move(settings), "Weight of fairing");
  const auto ticket = state.ticket();
  ASSERT_TRUE(frames_until(state, [&] { return state.ticket() > ticket; }));
  ASSERT_TRUE(state.solving());
  ASSERT_TRUE(state.apply_suggestion(best));
  ASSERT_TRUE(all_rated(state));
  EXPECT_EQ(state.document().history().size(), 2u);
  EXPECT_TRUE(state.findings()->diagnosis.solved);
  EXPECT_TRUE(state.up_to_date());
}

TEST(AppStateSuggestions, HiddenKindsAreNotAppliedTogether) {
  AppState state;
  state.open_sample("bad-saddle");
  ASSERT_TRUE(all_rated(state));
  state.view_options.hidden_edits.set(static_cast<std::size_t>(EditKind::Flip));
  const SuggestionList& list = state.suggestion_list();
  EXPECT_LT(list.size(), static_cast<int>(list.from->ranked.size()));
  for (const int i : list.together)
    EXPECT_NE(list.from->ranked[static_cast<std::size_t>(i)].candidate.edit.kind, EditKind::Flip);
  state.view_options.hidden_edits.set();
  EXPECT_FALSE(state.apply_all_suggestions());
}

TEST(AppStateSuggestions, PreviewsShowThePanelsAfterAnEdit) {
  AppState state;
  state.open_sample("bad-saddle");
  ASSERT_TRUE(all_rated(state));
  const Suggestion best = state.suggestion_list().at(0);
  std::shared_ptr<const EditPreview> preview;
  ASSERT_TRUE(frames_until(state, [&] {
    preview = state.preview(best.candidate.edit);
    return preview != nullptr;
  }));
  ASSERT_TRUE(preview->rated.has_value());
  EXPECT_EQ(preview->rated->gain(), best.gain()) << "of the list";
  EXPECT_GE(preview->panels.size(), 4u) << "those that change neighbours";
  // Of an edge that no finding flags, too.
  const PolygonMesh& mesh = *state.document().mesh();
  int quiet = 0;
  while (!state.document().may_edit(MeshEdit::flip(quiet)) || mesh.is_border_vertex(mesh.edge(quiet).a) ||
         state.finding_list().find_flagged(quiet) != nullptr) {
    ++quiet;
  }
  ASSERT_TRUE(frames_until(state, [&] { return state.preview(MeshEdit::flip(quiet)) != nullptr; }));
}

TEST(AppStateSuggestions, FollowTheThresholdsOfFindings) {
  AppState state;
  state.open_sample("bad-saddle");
  ASSERT_TRUE(all_rated(state));
  const int few = state.findings()->diagnosis.count(FindingKind::ClosePoints);
  const int candidates = state.advice()->candidates;
  FindingSettings settings = state.finding_settings();
  settings[FindingKind::ClosePoints].threshold = 0.8;
  state.set_finding_settings(settings);
  EXPECT_FALSE(state.advice_fits());
  ASSERT_TRUE(all_rated(state));
  EXPECT_GT(state.findings()->diagnosis.count(FindingKind::ClosePoints), few);
  EXPECT_GT(state.advice()->candidates, candidates);
  EXPECT_FALSE(state.document().can_undo()) << "a setting of the window, no step";
  state.set_finding_settings({});
  ASSERT_TRUE(frames_until(state, [&] { return state.advice_fits(); }));
  EXPECT_FALSE(state.rating()) << "rated before";
  EXPECT_EQ(state.advice()->candidates, candidates);
}

TEST(SuggestionText, PartsAddUpToTheGain) {
  Suggestion suggestion;
  suggestion.candidate.edit = MeshEdit::join(3);
  suggestion.candidate.deviation = 0.05;
  suggestion.before = {4.0, 1.0, 0.8, 0.0, 0.0};
  suggestion.after = {4.2, 0.0, 0.0, 0.0, 0.0};
  double sum = 0.0;
  for (const GainPart& part : gain_parts(suggestion)) sum += part.gain;
  EXPECT_NEAR(sum, suggestion.gain(), 1e-12);
  EXPECT_EQ(gain_text(1.234), "1.23");
  EXPECT_EQ(gain_text(-0.5), "−0.50");
}

TEST(EditSketch, ShowsWhatComesAndWhatGoes) {
  AppState state;
  state.open_sample("bad-saddle");
  ASSERT_TRUE(settle(state));
  const PolygonMesh& mesh = *state.document().mesh();
  int edge = 0;
  while (!mesh.can_flip(edge)) ++edge;
  const EditSketch flip = sketch(mesh, MeshEdit::flip(edge));
  ASSERT_EQ(flip.made.size(), 1u);
  ASSERT_EQ(flip.gone.size(), 1u);
  PolygonMesh flipped = mesh;
  flipped.flip(edge);
  const MeshEdge now = flipped.edge(edge);
  const Vector3d a = mesh.positions().row(now.a), b = mesh.positions().row(now.b);
  const auto& [from, to] = flip.made.front();
  EXPECT_TRUE((from == a && to == b) || (from == b && to == a));
  EXPECT_TRUE(sketch(mesh, MeshEdit::join(edge)).made.empty());
  const EditSketch moved = sketch(mesh, MeshEdit::move_vertex(0, {1, 2, 3}));
  EXPECT_EQ(moved.place, Vector3d(1, 2, 3));
  EXPECT_EQ(moved.made.size(), mesh.edges_around(0).size());
}

}  // namespace
}  // namespace planewright::ui
