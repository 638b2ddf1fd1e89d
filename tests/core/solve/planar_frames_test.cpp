#include "core/solve/planar_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "core/solve/demand_projection.h"
#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

// Keeps what it is told, null states included; may want none.
class Watcher final : public SolveObserver {
 public:
  explicit Watcher(bool wants = true) : wants_(wants) {}
  void on_iteration(const Iteration& iteration, const State* state) override {
    iterations.push_back(iteration);
    states.push_back(state ? std::optional(*state) : std::nullopt);
  }
  bool wants_states() const override { return wants_; }
  int states_told() const {
    return static_cast<int>(
        std::count_if(states.begin(), states.end(), [](const auto& s) { return s.has_value(); }));
  }

  std::vector<Iteration> iterations;
  std::vector<std::optional<State>> states;

 private:
  bool wants_;
};

class PlanarFramesTest : public testing::Test {
 protected:
  Vector projected() const {
    Vector at = problem->from_state(initial_state(*complex));
    EXPECT_TRUE(project_onto_demands(*problem, at).planar);
    return at;
  }
  State state_of(const Vector& at) const {
    return problem->to_state({at.data(), static_cast<size_t>(at.size())});
  }

  SharedComplex complex = sample_complex("twisted-roof", 60);
  SharedProblem problem = problem_of(complex, {{"position", 1.0}, {"fairing", 0.2}});
  State planar = state_of(projected());
  Vector z = problem->from_state(perturbed(*complex, planar, 0.05));
  TangentCache cache;
};

TEST_F(PlanarFramesTest, EveryStateIsPlanarAndNearTheSolversOwn) {
  Watcher watcher;
  PlanarFrames frames(*problem, &watcher, cache, {});
  frames.tell_start(z);
  for (int step = 0; step < 12; ++step) {
    const State state = perturbed(*complex, planar, 0.02, static_cast<unsigned>(step));
    const Vector at = problem->from_state(state), before = at;
    frames.tell(at, 0.1, 0.01, PlanarFrames::Distance::Near);
    EXPECT_EQ(at, before);
    if (!watcher.states.back()) continue;
    EXPECT_LE(distance(*complex, *watcher.states.back(), state), 0.2);
    const Vector told = problem->from_state(*watcher.states.back());
    EXPECT_LE((*frames.newest() - told).cwiseAbs().maxCoeff(), 1e-12);
  }
  EXPECT_GE(watcher.states_told(), 5);
  for (size_t k = 0; k < watcher.states.size(); ++k) {
    EXPECT_EQ(watcher.iterations[k].planar, watcher.states[k].has_value()) << k;
    if (watcher.states[k]) {
      EXPECT_LE(off_plane(*complex, *watcher.states[k]), 1e-9) << k;
      EXPECT_LE((watcher.states[k]->n.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-14) << k;
    }
  }
}

TEST_F(PlanarFramesTest, NumbersCountStepsAndScalarsAreTheSteps) {
  Watcher watcher;
  PlanarFrames frames(*problem, &watcher, cache, {});
  EXPECT_EQ(frames.told(), 0);
  frames.tell_start(z);
  EXPECT_EQ(frames.told(), 0);
  for (int step = 1; step <= 9; ++step) {
    frames.tell(z, 0.5 / step, 0.1 * step, PlanarFrames::Distance::Far);
    EXPECT_EQ(frames.told(), step);
  }
  ASSERT_EQ(watcher.iterations.size(), 10u);
  const Vector values = constraint_values(*problem, z);
  double seconds = 0.0;
  for (int k = 0; k < 10; ++k) {
    const Iteration& told = watcher.iterations[static_cast<size_t>(k)];
    EXPECT_EQ(told.number, k);
    EXPECT_STREQ(told.solver, "tangent");
    EXPECT_FALSE(told.restoration);
    EXPECT_EQ(told.first_order, k == 0 ? 0.0 : 0.5 / k);
    EXPECT_EQ(told.step, 0.1 * k);
    EXPECT_GE(told.seconds, seconds);
    seconds = told.seconds;
    // Of the solver's state, not of the projected one.
    EXPECT_NEAR(told.objective, problem->objective(z.data()), 1e-12 * told.objective);
    EXPECT_NEAR(told.infeasibility, values.cwiseAbs().maxCoeff(), 1e-15);
    ASSERT_EQ(told.energies.size(), 2u);
    EXPECT_NEAR(told.energies[0].value + told.energies[1].value, told.objective, 1e-12 * told.objective);
  }
}

// A slider that is being dragged ends most solves after a few steps: those are shown; far from planar, where
// a projection is dear, few are.
TEST_F(PlanarFramesTest, TheFirstStepsNearAPlanarStateAreAllShown) {
  for (const auto distance : {PlanarFrames::Distance::Near, PlanarFrames::Distance::Far}) {
    const bool near = distance == PlanarFrames::Distance::Near;
    Watcher watcher;
    PlanarFrames frames(*problem, &watcher, cache, {});
    frames.tell_start(z);
    for (int step = 0; step < 24; ++step) frames.tell(z, 0.1, 0.1, distance);
    ASSERT_EQ(watcher.states.size(), 25u);
    EXPECT_TRUE(watcher.states[0]);
    for (size_t k = 1; k <= 3; ++k) EXPECT_EQ(watcher.states[k].has_value(), near) << k;
    // Never long without one.
    const int longest_wait = near ? 4 : 8;
    int wait = 0;
    for (const auto& state : watcher.states) {
      wait = state ? 0 : wait + 1;
      EXPECT_LT(wait, longest_wait);
    }
    EXPECT_LE(watcher.states_told(), near ? 12 : 4);
  }
}

TEST_F(PlanarFramesTest, AnObserverThatWantsNoStatesGetsNone) {
  // A projection would put its own analysis in the place of the oldest of these.
  std::vector<SharedProblem> others;
  std::vector<std::shared_ptr<TangentWorkspace>> kept;
  for (const int columns : {2, 3, 4}) {
    others.push_back(problem_of(planarize_of(twisted_grid(columns, 2).mesh()), {{"position", 1.0}}));
    kept.push_back(cache.find_or_make(*others.back(), EnergyCoupling::Dropped));
  }
  Watcher watcher(false);
  PlanarFrames frames(*problem, &watcher, cache, {});
  frames.tell_start(z);
  for (int step = 0; step < 20; ++step) frames.tell(z, 0.1, 0.1, PlanarFrames::Distance::Near);
  EXPECT_EQ(watcher.iterations.size(), 21u);
  EXPECT_EQ(watcher.states_told(), 0);
  EXPECT_FALSE(frames.newest());
  for (const Iteration& told : watcher.iterations) EXPECT_FALSE(told.planar);
  for (size_t k = 0; k < kept.size(); ++k)
    EXPECT_EQ(cache.find_or_make(*others[k], EnergyCoupling::Dropped), kept[k]);
}

TEST_F(PlanarFramesTest, WithoutAnObserverStepsAreCounted) {
  PlanarFrames frames(*problem, nullptr, cache, {});
  frames.tell_start(z);
  for (int step = 0; step < 5; ++step) frames.tell(z, 0.1, 0.1, PlanarFrames::Distance::Near);
  EXPECT_EQ(frames.told(), 5);
  EXPECT_FALSE(frames.newest());
}

TEST_F(PlanarFramesTest, AStopRequestEndsProjectionsButNotTheTelling) {
  std::stop_source stop;
  Watcher watcher;
  PlanarFrames frames(*problem, &watcher, cache, stop.get_token());
  frames.tell(z, 0.1, 0.1, PlanarFrames::Distance::Near);
  ASSERT_TRUE(watcher.states.back());
  const State shown = *watcher.states.back();
  const Vector newest = *frames.newest();
  stop.request_stop();
  frames.tell(z, 0.1, 0.1, PlanarFrames::Distance::Near);
  EXPECT_EQ(watcher.iterations.size(), 2u);
  EXPECT_FALSE(watcher.states.back());
  EXPECT_FALSE(watcher.iterations.back().planar);
  EXPECT_EQ(*frames.newest(), newest);
  // A state that is planar already needs no projection.
  frames.tell(newest, 0.1, 0.1, PlanarFrames::Distance::Near);
  ASSERT_TRUE(watcher.states.back());
  EXPECT_LE(distance(*complex, *watcher.states.back(), shown), 1e-9);
}

// The compromise between demands that contradict the incidences has gaps: the view never shows it.
TEST_F(PlanarFramesTest, DemandsOutOfReachGiveNoStateRatherThanOneWithGaps) {
  const SharedComplex saddle = dual_of(make_sample("saddle-roof", 60).value());
  const auto convex = Problem::create(saddle, demanding({demand("convex")})).value();
  Watcher watcher;
  PlanarFrames frames(*convex, &watcher, cache, {});
  frames.tell_start(convex->from_state(initial_state(*saddle)));
  ASSERT_EQ(watcher.iterations.size(), 1u);
  EXPECT_GT(watcher.iterations[0].infeasibility, 1e-3);
  EXPECT_EQ(watcher.iterations[0].planar, watcher.states[0].has_value());
  if (watcher.states[0]) {
    EXPECT_LE(off_plane(*saddle, *watcher.states[0]), 1e-9);
  }
}

}  // namespace
}  // namespace planewright
