// The window's state without a window: what is shown, what is stale, and what a mistake must not lose.
#include "ui/app_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "core/mesh/mesh_io.h"
#include "support/app_state_runs.h"

namespace planewright::ui {
namespace {

using namespace std::chrono_literals;
using namespace test;

std::filesystem::path temporary(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("app_state_test_" + name);
}

TEST(AppState, OpensASampleAndSolvesIt) {
  AppState state;
  state.open_sample("dome", 100);
  EXPECT_TRUE(state.loading());
  ASSERT_TRUE(settle(state));
  ASSERT_NE(state.report(), nullptr);
  EXPECT_EQ(state.report()->status, SolveStatus::Converged);
  ASSERT_NE(state.shown(), nullptr);
  EXPECT_TRUE(state.shown()->final);
  EXPECT_LE(state.shown()->planarity.max_relative_to_bbox, 1e-9);
  EXPECT_FALSE(state.history().empty());
  EXPECT_TRUE(state.up_to_date());
  EXPECT_TRUE(state.messages().empty());
  EXPECT_EQ(state.document().settings().mode, ComplexKind::Dual);
}

TEST(AppState, QuadsArePlanarized) {
  AppState state;
  state.open_sample("twisted-roof", 60);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.document().settings().mode, ComplexKind::Planarize);
}

TEST(AppState, AChangeSolvesAgainFromTheShownState) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  const auto ticket = state.ticket();
  const auto before = state.shown();
  state.change_settings(with_fairing(state, 5.0), "Weight of fairing");
  EXPECT_FALSE(state.settled());
  EXPECT_EQ(state.shown(), before) << "the last good state stays until the next arrives";
  ASSERT_TRUE(settle(state));
  EXPECT_GT(state.ticket(), ticket);
  EXPECT_NE(state.shown()->fingerprint, before->fingerprint);

  state.undo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.document().settings().weights.at("fairing"), 0.0);
}

TEST(AppState, ADragShowsOnlyTheNewestValueInTheEnd) {
  AppState state;
  state.open_sample("dome", 300);
  ASSERT_TRUE(settle(state));
  const auto ticket = state.ticket();
  for (int i = 1; i <= 20; ++i) {
    state.change_settings(with_fairing(state, 0.1 * i), "Weight of fairing", "weight fairing");
    state.update(Clock::now());
    std::this_thread::sleep_for(4ms);
  }
  EXPECT_LT(state.ticket() - ticket, 20u) << "a drag must not restart the solver with every pixel";
  state.end_merge();
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.up_to_date());
  EXPECT_EQ(state.shown()->ticket(), state.ticket());
  EXPECT_EQ(state.document().undo_name(), "Weight of fairing");
  state.undo();
  EXPECT_FALSE(state.document().can_undo()) << "a drag is one step";
}

// Every solve of a drag is superseded, so what they deliver has to be shown all the same.
TEST(AppState, ADragThatNeverRestsShowsPanelsOnItsWay) {
  AppState state;
  state.open_sample("torus", 400);
  ASSERT_TRUE(settle(state));
  std::set<std::uint64_t> shown;
  int value = 0;
  ASSERT_TRUE(run_until(state, [&] {
    if (state.shown()->ticket() != state.ticket()) shown.insert(state.shown()->fingerprint);
    state.change_settings(with_fairing(state, 0.001 * ++value), "Weight of fairing", "weight fairing");
    return shown.size() >= 6;
  }));
  state.end_merge();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown()->ticket(), state.ticket());
  EXPECT_TRUE(state.shown()->final);
}

TEST(AppState, FlipsSolveAgainAndRefusalsAreMessages) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  const PolygonMesh& mesh = *state.document().mesh();
  int inner = 0, border = 0;
  while (!mesh.can_flip(inner)) ++inner;
  while (!mesh.edge(border).border()) ++border;

  EXPECT_FALSE(state.edit_mesh(MeshEdit::flip(border)));
  ASSERT_EQ(state.messages().size(), 1u);
  EXPECT_EQ(state.messages().front().kind, Message::Kind::Error);
  EXPECT_TRUE(state.settled());

  const auto view = state.mesh_view();
  EXPECT_TRUE(state.edit_mesh(MeshEdit::flip(inner)));
  EXPECT_NE(state.mesh_view(), view);
  ASSERT_TRUE(settle(state));
  EXPECT_LE(state.shown()->planarity.max_relative_to_bbox, 1e-9);
}

TEST(AppState, EnergiesAreKnownFromTheFirstStepOn) {
  AppState state;
  state.open_sample("torus", 2000);
  EXPECT_TRUE(state.energies().empty());
  ASSERT_TRUE(run_until(state, [&] { return state.history().size() >= 2; }));
  ASSERT_FALSE(state.energies().empty());
  const auto objective = [&] {
    double sum = 0;
    for (const SolveReport::Energy& energy : state.energies()) sum += energy.value;
    return sum;
  };
  if (state.solving() && !state.history().back().restoration) {
    EXPECT_NEAR(objective(), state.history().back().objective, 1e-6 * (1 + objective()));
  }
  ASSERT_TRUE(settle(state));
  ASSERT_EQ(state.energies().size(), state.report()->energies.size());
  for (std::size_t i = 0; i < state.energies().size(); ++i) {
    EXPECT_EQ(state.energies()[i].value, state.report()->energies[i].value);
  }
}

TEST(AppState, TheGhostAndThePanelsComeReadyToDraw) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  ASSERT_TRUE(state.ghost());
  EXPECT_EQ(state.ghost()->mesh, state.mesh_view());
  EXPECT_EQ(state.ghost()->arrays.lines.indices.size(), 6 * state.mesh_view()->edges.size());
  const auto panels = state.shown()->panels.geometry;
  EXPECT_EQ(panels->polygons, state.shown()->complex().panels);

  state.change_settings(with_fairing(state, 2.0), "Weight of fairing");
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown()->panels.geometry->polygons, panels->polygons);
  const auto ghost = state.ghost();

  int edge = 0;
  while (!state.document().may_edit(MeshEdit::flip(edge))) ++edge;
  ASSERT_TRUE(state.edit_mesh(MeshEdit::flip(edge)));
  EXPECT_FALSE(state.settled());
  ASSERT_TRUE(settle(state));
  EXPECT_NE(state.ghost(), ghost);
  EXPECT_EQ(state.ghost()->mesh, state.mesh_view());
  EXPECT_NE(state.shown()->panels.geometry, panels);
  EXPECT_EQ(state.shown()->panels.geometry->polygons, state.shown()->complex().panels);
}

TEST(AppState, ABadFileLosesNothing) {
  const auto path = temporary("bad.obj");
  std::ofstream(path) << "v 0 0 0\nv one 0 0\n";
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  const auto shown = state.shown();
  for (const auto& bad : {path, std::filesystem::path("/nowhere/at/all.obj")}) {
    const auto posted = state.messages_posted();
    state.open_file(bad);
    ASSERT_TRUE(run_until(state, [&] { return !state.loading(); }));
    ASSERT_EQ(state.messages_posted(), posted + 1);
    EXPECT_EQ(state.messages().back().kind, Message::Kind::Error);
    EXPECT_FALSE(state.messages().back().what.empty());
    EXPECT_EQ(state.document().name(), "dome");
    EXPECT_EQ(state.shown(), shown);
  }
  std::filesystem::remove(path);
}

TEST(AppState, OpeningAnotherDesignDropsWhatTheOldOneStillDelivers) {
  AppState state;
  state.open_sample("torus", 1500);
  ASSERT_TRUE(run_until(state, [&] { return state.shown() != nullptr; }));
  state.open_sample("dome", 100);
  ASSERT_TRUE(run_until(state, [&] { return state.document().name() == "dome"; }));
  const auto limit = Clock::now() + 60s;
  while (!state.settled() && Clock::now() < limit) {
    state.update(Clock::now());
    if (state.shown()) {
      ASSERT_LT(state.shown()->complex().plane_count(), 500) << "an iterate of the design before";
    }
  }
  EXPECT_TRUE(state.settled());
}

TEST(AppState, OpeningWhileOpeningEndsWithTheLast) {
  AppState state;
  state.open_sample("torus", 400);
  state.open_sample("vault", 100);
  state.open_sample("dome", 100);
  ASSERT_TRUE(run_until(state, [&] { return state.settled() && state.document().name() == "dome"; }));
}

TEST(AppState, StopKeepsTheBestState) {
  AppState state;
  state.open_sample("torus", 3000);
  ASSERT_TRUE(run_until(state, [&] { return state.iterates_before_end() >= 1; }));
  state.stop();
  ASSERT_TRUE(settle(state));
  ASSERT_NE(state.report(), nullptr);
  EXPECT_TRUE(state.report()->status == SolveStatus::Stopped ||
              state.report()->status == SolveStatus::Converged);
  EXPECT_TRUE(state.shown()->final);
}

TEST(AppState, WithoutAutoSolveAChangeWaits) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.set_auto_solve(false);
  const auto ticket = state.ticket();
  state.change_settings(with_fairing(state, 3.0), "Weight of fairing");
  for (int i = 0; i < 20; ++i) state.update(Clock::now());
  EXPECT_EQ(state.ticket(), ticket);
  EXPECT_FALSE(state.up_to_date());
  state.solve();
  ASSERT_TRUE(settle(state));
  EXPECT_GT(state.ticket(), ticket);
  EXPECT_TRUE(state.up_to_date());
}

TEST(AppState, ExportsWhatIsShown) {
  AppState state;
  const auto path = temporary("panels.obj");
  std::filesystem::remove(path);
  state.export_panels(path);
  EXPECT_EQ(state.messages().size(), 1u) << "nothing to export yet is said, not ignored";

  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.export_panels(path);
  ASSERT_TRUE(run_until(state, [&] { return !state.exporting(); }));
  const auto read = load_mesh(path);
  ASSERT_TRUE(read.has_value()) << read.error().text();
  EXPECT_EQ(read->mesh.face_count(), state.shown()->complex().plane_count());
  EXPECT_LE(measure_planarity(read->mesh.positions(), read->mesh.faces()).max_relative_to_bbox, 1e-9);

  state.export_panels("/nowhere/at/all.obj");
  ASSERT_TRUE(run_until(state, [&] { return !state.exporting(); }));
  EXPECT_EQ(state.messages().back().kind, Message::Kind::Error);
  std::filesystem::remove(path);
}

TEST(AppState, ColourRangeIsRoundAndLocks) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.colour_range(), 0.0);
  state.view_options.colours = ColourMap::Displacement;
  const double range = state.colour_range();
  EXPECT_GE(range, state.shown()->displacement.max);
  EXPECT_LE(range, 3 * std::max(state.shown()->displacement.max, 1e-3 * state.shown()->complex().mean_edge));
  state.view_options.lock_range = true;
  LayerSettings settings = state.document().settings();
  settings.offset = 5.0;
  state.change_settings(settings, "Offset");
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.colour_range(), range);
}

// --- The reference ---------------------------------------------------------------------------

// Panels that are fitted to the mesh would be taken for ones fitted to the reference that is asked for.
TEST(AppState, WithoutItsReferenceNothingIsSolved) {
  AppState state;
  state.open_sample("dome", 60);
  ASSERT_TRUE(settle(state));
  const auto solved = state.ticket();
  const Points points = state.document().mesh()->positions();
  const Polygons faces = state.document().mesh()->faces();
  Points far = points, raised = points;
  far.col(0).array() += 1e5;
  raised.col(2).array() += 0.1;
  const std::string far_file = temporary("far.obj").string(), good_file = temporary("raised.obj").string();
  ASSERT_TRUE(save_mesh(far_file, far, faces));
  ASSERT_TRUE(save_mesh(good_file, raised, faces));
  const auto choose = [&](const std::string& path) {
    Design design = state.document().design();
    design.reference = path;
    state.change_design(std::move(design), "Reference");
    ASSERT_TRUE(settle(state));
  };
  for (const std::string& bad : {far_file, temporary("none.obj").string()}) {
    choose(bad);
    EXPECT_EQ(state.ticket(), solved);
    ASSERT_EQ(state.messages().size(), 1u);
    EXPECT_NE(state.messages()[0].what.find("othing is solved until"), std::string::npos);
    EXPECT_EQ(state.layer_status(0), LayerStatus::Waiting);
    EXPECT_FALSE(state.up_to_date());
    // Neither a change nor a press of the button gets round it.
    state.change_settings(with_fairing(state, bad == far_file ? 1.0 : 2.0), "Weight of fairing");
    state.solve();
    ASSERT_TRUE(settle(state));
    EXPECT_EQ(state.ticket(), solved);
    EXPECT_EQ(state.messages().size(), 1u);
  }
  choose(good_file);
  EXPECT_GT(state.ticket(), solved);
  EXPECT_TRUE(state.messages().empty());
  EXPECT_EQ(state.layer_status(0), LayerStatus::Done);
  const auto with_reference = state.ticket();
  choose(far_file);
  EXPECT_EQ(state.ticket(), with_reference);
  choose("");  // removed: the mesh itself is meant
  EXPECT_GT(state.ticket(), with_reference);
  EXPECT_TRUE(state.messages().empty());
  EXPECT_EQ(state.layer_status(0), LayerStatus::Done);
  std::filesystem::remove(far_file);
  std::filesystem::remove(good_file);
}

}  // namespace
}  // namespace planewright::ui
