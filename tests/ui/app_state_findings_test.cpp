// Findings in the window's state: they belong to what is shown, and what was pointed at stays through an
// edit.
#include <gtest/gtest.h>

#include <thread>

#include "core/diagnose/diagnosis.h"
#include "ui/app_state.h"
#include "ui/edit_choices.h"
#include "ui/finding_text.h"

namespace planewright::ui {
namespace {

using namespace std::chrono_literals;

// Runs frames until all is solved and looked at, and tells `watch` of each; false after a minute.
template <class Watch>
bool settle(AppState& state, Watch watch) {
  const auto limit = Clock::now() + 60s;
  while (state.document().empty() || !state.settled()) {
    if (Clock::now() > limit) return false;
    state.update(Clock::now());
    watch();
    std::this_thread::sleep_for(1ms);
  }
  return true;
}
bool settle(AppState& state) {
  return settle(state, [] {});
}

TEST(AppStateFindings, AreThoseOfWhatIsShown) {
  AppState state;
  state.open_sample("bad-saddle");
  EXPECT_EQ(state.findings(), nullptr);
  ASSERT_TRUE(settle(state));
  const auto expect_own = [&] {
    if (const auto findings = state.findings()) {
      EXPECT_EQ(findings->number, state.shown()->number);
    }
  };
  ASSERT_NE(state.findings(), nullptr);
  const auto& iterate = *state.shown()->iterate;
  EXPECT_EQ(state.findings()->diagnosis.findings.size(),
            diagnose(*iterate.complex, iterate.state).findings.size());
  const FindingList& list = state.finding_list();
  ASSERT_FALSE(list.flagged.empty());
  ASSERT_TRUE(state.edit_mesh(MeshEdit::flip(list.flagged.front().edge)));
  ASSERT_TRUE(settle(state, expect_own));
  ASSERT_NE(state.findings(), nullptr);
  expect_own();
}

TEST(AppStateFindings, WalkRoundAndGoOnWhereOneIsGone) {
  AppState state;
  state.open_sample("bad-saddle");
  ASSERT_TRUE(settle(state));
  const int count = state.finding_list().size();
  ASSERT_GT(count, 2);
  for (int row = 0; row < count; ++row) {
    state.walk_findings(1);
    EXPECT_EQ(state.current_finding(), row);
    EXPECT_TRUE(state.take_look_at().has_value());
  }
  state.walk_findings(1);
  EXPECT_EQ(state.current_finding(), 0);
  state.walk_findings(-1);
  EXPECT_EQ(state.current_finding(), count - 1);
  const Finding last = state.finding_list().finding(count - 1);
  state.view_options.hidden_findings.set(static_cast<std::size_t>(last.kind));
  EXPECT_EQ(state.current_finding(), std::nullopt);
  EXPECT_LT(state.finding_list().size(), count);
}

TEST(AppStateFindings, PanelsKeepNameAndSelectionThroughAnEdit) {
  AppState state;
  state.open_sample("dome", 200);
  ASSERT_TRUE(settle(state));
  const PolygonMesh& mesh = *state.document().mesh();
  int collapsed = 0;
  while (!state.document().may_edit(MeshEdit::collapse(collapsed)) ||
         mesh.is_border_vertex(mesh.edge(collapsed).a) || mesh.is_border_vertex(mesh.edge(collapsed).b)) {
    ++collapsed;
  }
  const int last = state.shown()->complex().plane_count() - 1;
  state.select_panel(last, Combine::Replace);
  const int number = panel_number(state.document(), 0, *state.shown(), last);
  EXPECT_EQ(number, last) << "an unedited mesh has the names of every report";
  ASSERT_TRUE(state.edit_mesh(MeshEdit::collapse(collapsed)));
  ASSERT_TRUE(settle(state));
  ASSERT_TRUE(state.selected_panel.has_value());
  EXPECT_EQ(*state.selected_panel, last - 1);
  EXPECT_EQ(panel_number(state.document(), 0, *state.shown(), *state.selected_panel), number);
}

TEST(EditChoices, OffersEachEditOrSaysWhyNot) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  const Document& document = state.document();
  for (const EditChoice& choice : edit_choices(document, {})) {
    EXPECT_FALSE(choice.edit.has_value()) << choice.name;
    EXPECT_FALSE(choice.refused.empty()) << choice.name;
  }
  int inner = 0;
  while (!document.mesh()->can_flip(inner)) ++inner;
  for (const EditChoice& choice : edit_choices(document, {inner, 0, 0})) {
    EXPECT_NE(choice.edit.has_value(), !choice.refused.empty()) << choice.name;
    EXPECT_EQ(choice.edit.has_value(), choice.name != "split face") << "a triangle has no diagonal";
  }
}

}  // namespace
}  // namespace planewright::ui
