// The session from the outside, as the window uses it: only by polling. Nothing here rests on how long
// anything takes; a wait ends when what it waits for is there, and ctest ends a test that hangs.
#include "core/design/solve_session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <random>
#include <thread>

#include "core/design/design.h"
#include "support/solves.h"

namespace planewright {
namespace {

using namespace test;

std::shared_ptr<const PolygonMesh> shared_sample(std::string_view name, int panels) {
  return std::make_shared<const PolygonMesh>(make_sample(name, panels).value());
}

// What a session wakes: counts, lets a test sleep until there is something new, and can hold the worker at a
// ring, so that a solve is certainly still running when something else happens.
class Bell {
 public:
  void ring() {
    std::unique_lock lock(mutex_);
    ++rings_;
    rung_.notify_all();
    released_.wait(lock, [&] { return rings_ < hold_from_; });
  }
  // The worker stays in its n-th ring from now until release().
  void hold_after(int more) {
    const std::lock_guard lock(mutex_);
    hold_from_ = rings_ + more;
  }
  void release() {
    {
      const std::lock_guard lock(mutex_);
      hold_from_ = std::numeric_limits<int>::max();
    }
    released_.notify_all();
  }
  int rings() const {
    const std::lock_guard lock(mutex_);
    return rings_;
  }
  void wait_for_more_than(int seen) {
    std::unique_lock lock(mutex_);
    rung_.wait(lock, [&] { return rings_ > seen; });
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable rung_, released_;
  int rings_ = 0;
  int hold_from_ = std::numeric_limits<int>::max();
};

class SolveSessionTest : public testing::Test {
 protected:
  void TearDown() override { bell_.release(); }

  // Drains until the outcome is there, as the window does at every frame.
  SolveOutcome wait_for_outcome() {
    while (true) {
      const int seen = bell_.rings();
      drain();
      if (auto outcome = session_.take_outcome()) return std::move(*outcome);
      bell_.wait_for_more_than(seen);
    }
  }
  // Starts a solve and returns while it is held in its iteration of this number.
  std::uint64_t start_and_hold(SolveRequest request, int number) {
    const int seen = bell_.rings();
    bell_.hold_after(number + 1);
    const std::uint64_t ticket = session_.start(std::move(request));
    bell_.wait_for_more_than(seen + number);
    drain();
    return ticket;
  }
  void drain() {
    session_.drain_iterations(iterations_);
    if (auto iterate = session_.take_iterate()) iterates_.push_back(std::move(iterate));
  }

  static SolveRequest request(std::string_view sample, int panels, double fairing = 0.0) {
    SolveRequest request;
    request.mesh = shared_sample(sample, panels);
    request.settings.weights["fairing"] = fairing;
    return request;
  }

  Bell bell_;
  SolveSession session_{[this] { bell_.ring(); }};
  std::vector<Iteration> iterations_;
  std::vector<std::shared_ptr<const Iterate>> iterates_;
};

TEST_F(SolveSessionTest, RestsBeforeTheFirstStart) {
  EXPECT_FALSE(session_.running());
  EXPECT_EQ(session_.current_ticket(), 0u);
  EXPECT_EQ(session_.take_iterate(), nullptr);
  EXPECT_FALSE(session_.take_outcome());
  session_.drain_iterations(iterations_);
  EXPECT_TRUE(iterations_.empty());
  session_.stop();
  EXPECT_FALSE(session_.running());
}

TEST_F(SolveSessionTest, SolvesOnTheWorkerAsTheSolverDoes) {
  const SolveRequest wanted = request("train-station", 100, 0.1);
  const std::uint64_t ticket = session_.start(wanted);
  EXPECT_GT(ticket, 0u);
  EXPECT_EQ(session_.current_ticket(), ticket);
  const SolveOutcome outcome = wait_for_outcome();
  EXPECT_EQ(outcome.ticket, ticket);
  ASSERT_TRUE(outcome.report) << outcome.report.error().text();
  EXPECT_EQ(outcome.report->status, SolveStatus::Converged);
  ASSERT_NE(outcome.complex, nullptr);
  EXPECT_FALSE(session_.take_outcome());  // once

  const auto problem =
      build_problem(build_complex(*wanted.mesh, wanted.settings).value(), wanted.settings).value();
  const State start = start_state(problem->complex(), wanted.settings);
  const SolveReport same =
      make_solver(wanted.solver)->solve(*problem, start, solve_options(wanted.settings), nullptr, {});
  EXPECT_EQ(outcome.report->iterations, same.iterations);
  EXPECT_TRUE(same_bits(outcome.report->state.x, same.state.x));
  EXPECT_TRUE(same_bits(outcome.report->state.n, same.state.n));
}

TEST_F(SolveSessionTest, LosesNoScalars) {
  session_.start(request("train-station", 150));
  const SolveOutcome outcome = wait_for_outcome();
  ASSERT_TRUE(outcome.report);
  drain();
  ASSERT_EQ(static_cast<int>(iterations_.size()), outcome.report->iterations + 1);
  for (size_t k = 0; k < iterations_.size(); ++k) EXPECT_EQ(iterations_[k].number, static_cast<int>(k));
}

// The worker is held at every wake until its iterate has been taken: so every one arrives before the outcome.
TEST(SolveSessionStream, IteratesArriveBeforeTheOutcome) {
  std::mutex mutex;
  std::condition_variable changed;
  bool waiting = false, go_on = false;
  SolveSession session([&] {
    std::unique_lock lock(mutex);
    waiting = true;
    changed.notify_all();
    changed.wait(lock, [&] { return go_on; });
    go_on = false;
  });
  SolveRequest request;
  request.mesh = shared_sample("train-station", 100);
  const std::uint64_t ticket = session.start(request);

  std::vector<std::shared_ptr<const Iterate>> before;
  std::optional<SolveOutcome> outcome;
  while (!outcome) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return waiting; });
    waiting = false;
    if (auto iterate = session.take_iterate()) {
      EXPECT_TRUE(session.running());
      before.push_back(iterate);
    }
    outcome = session.take_outcome();
    go_on = true;
    changed.notify_all();
  }
  ASSERT_TRUE(outcome->report);
  ASSERT_GE(before.size(), 3u);
  int different = 0;
  for (size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(before[k]->ticket, ticket);
    EXPECT_EQ(before[k]->complex, outcome->complex);
    EXPECT_EQ(before[k]->iteration.solver, std::string("tangent"));
    EXPECT_TRUE(before[k]->iteration.planar);
    EXPECT_LE(off_plane(*outcome->complex, before[k]->state), 1e-9);
    if (k > 0) {
      EXPECT_GT(before[k]->iteration.number, before[k - 1]->iteration.number);
    }
    different += k > 0 && !same_bits(before[k]->state.x, before[k - 1]->state.x);
  }
  EXPECT_GE(different, 2);
}

TEST_F(SolveSessionTest, TheMailboxHoldsTheNewestIterateOnly) {
  session_.start(request("dome", 100));
  while (session_.running()) {
    const int seen = bell_.rings();
    if (session_.running()) bell_.wait_for_more_than(seen);
    if (session_.take_outcome()) break;
  }
  session_.drain_iterations(iterations_);
  const auto newest = session_.take_iterate();
  ASSERT_NE(newest, nullptr);
  EXPECT_EQ(newest->iteration.number, iterations_.back().number);
  EXPECT_EQ(session_.take_iterate(), nullptr);
}

TEST_F(SolveSessionTest, ANewStartSupersedesTheRunningOne) {
  const std::uint64_t first = start_and_hold(request("train-station", 150), 2);
  EXPECT_EQ(iterations_.size(), 3u);
  ASSERT_FALSE(iterates_.empty());
  EXPECT_EQ(iterates_.back()->ticket, first);
  const std::uint64_t second = session_.start(request("dome", 80));
  EXPECT_GT(second, first);
  EXPECT_EQ(session_.current_ticket(), second);
  // From the moment start() returned, nothing of the first is handed out.
  iterations_.clear();
  iterates_.clear();
  bell_.release();
  const SolveOutcome outcome = wait_for_outcome();
  drain();
  EXPECT_EQ(outcome.ticket, second);
  ASSERT_TRUE(outcome.report);
  EXPECT_EQ(outcome.report->status, SolveStatus::Converged);
  for (const auto& iterate : iterates_) EXPECT_EQ(iterate->ticket, second);
  ASSERT_EQ(static_cast<int>(iterations_.size()), outcome.report->iterations + 1);
  EXPECT_EQ(iterations_.front().number, 0);
  EXPECT_FALSE(session_.take_outcome());
}

// An iterate and scalars that wait in the mailbox when the next request comes are gone with it.
TEST_F(SolveSessionTest, AStaleIterateInTheMailboxIsDropped) {
  const int seen = bell_.rings();
  bell_.hold_after(2);
  session_.start(request("train-station", 100));
  bell_.wait_for_more_than(seen + 1);
  session_.start(request("dome", 60));
  EXPECT_EQ(session_.take_iterate(), nullptr);
  session_.drain_iterations(iterations_);
  EXPECT_TRUE(iterations_.empty());
  bell_.release();
  EXPECT_TRUE(wait_for_outcome().report);
}

// The same with an outcome that nobody has taken yet.
TEST_F(SolveSessionTest, AStaleOutcomeIsDropped) {
  session_.start(request("dome", 60));
  while (session_.running()) std::this_thread::yield();
  bell_.hold_after(1);
  session_.start(request("dome", 50));
  EXPECT_FALSE(session_.take_outcome());
  bell_.release();
  const SolveOutcome outcome = wait_for_outcome();
  EXPECT_EQ(outcome.ticket, session_.current_ticket());
}

TEST_F(SolveSessionTest, ARequestThatWaitsIsReplaced) {
  start_and_hold(request("train-station", 150), 1);
  session_.start(request("torus", 60));
  session_.start(request("vault", 60));
  const std::uint64_t last = session_.start(request("dome", 60));
  bell_.release();
  const SolveOutcome outcome = wait_for_outcome();
  EXPECT_EQ(outcome.ticket, last);
  ASSERT_TRUE(outcome.report);
  EXPECT_EQ(outcome.complex->plane_count(), request("dome", 60).mesh->vertex_count());
}

TEST_F(SolveSessionTest, StopKeepsTheBestState) {
  start_and_hold(request("train-station", 150), 3);
  EXPECT_TRUE(session_.running());
  session_.stop();
  EXPECT_TRUE(session_.running());  // until its outcome is there
  bell_.release();
  const SolveOutcome outcome = wait_for_outcome();
  EXPECT_FALSE(session_.running());
  ASSERT_TRUE(outcome.report);
  EXPECT_EQ(outcome.report->status, SolveStatus::Stopped);
  EXPECT_EQ(outcome.report->iterations, 3);
  EXPECT_LE(off_plane(*outcome.complex, outcome.report->state), 1e-12);
}

TEST_F(SolveSessionTest, StopBeforeTheWorkerCameToIt) {
  // Straight after start: whether the worker has the request yet or not, it has to end as stopped.
  bell_.hold_after(1);
  session_.start(request("train-station", 150));
  session_.stop();
  bell_.release();
  const SolveOutcome outcome = wait_for_outcome();
  ASSERT_TRUE(outcome.report);
  EXPECT_EQ(outcome.report->status, SolveStatus::Stopped);
  // And the next request is not stopped by the old wish.
  session_.start(request("dome", 60));
  const SolveOutcome next = wait_for_outcome();
  ASSERT_TRUE(next.report);
  EXPECT_EQ(next.report->status, SolveStatus::Converged);
}

TEST_F(SolveSessionTest, RestartsFromTheCurrentState) {
  SolveRequest wanted = request("train-station", 150);
  session_.start(wanted);
  const SolveOutcome cold = wait_for_outcome();
  ASSERT_TRUE(cold.report);
  drain();
  iterations_.clear();
  iterates_.clear();
  // Another weight, from where we are.
  wanted.settings.weights["fairing"] = 0.01;
  wanted.warm_start =
      std::make_shared<const Iterate>(Iterate{cold.ticket, cold.complex, cold.report->state, {}});
  session_.start(wanted);
  const SolveOutcome warm = wait_for_outcome();
  ASSERT_TRUE(warm.report);
  EXPECT_EQ(warm.report->status, SolveStatus::Converged);
  drain();
  // It began there: planar from the first iteration on, which the builder's own start is not.
  ASSERT_FALSE(iterations_.empty());
  EXPECT_LE(iterations_.front().infeasibility, 1e-9);
  // The complex is kept while weights alone change.
  EXPECT_EQ(warm.complex, cold.complex);
}

TEST_F(SolveSessionTest, RestartsAfterAFlip) {
  SolveRequest wanted = request("dome", 120);
  session_.start(wanted);
  const SolveOutcome before = wait_for_outcome();
  ASSERT_TRUE(before.report);
  PolygonMesh flipped = *wanted.mesh;
  int edge = 0;
  while (!flipped.flip(edge)) ++edge;
  wanted.mesh = std::make_shared<const PolygonMesh>(std::move(flipped));
  wanted.warm_start =
      std::make_shared<const Iterate>(Iterate{before.ticket, before.complex, before.report->state, {}});
  session_.start(wanted);
  const SolveOutcome after = wait_for_outcome();
  ASSERT_TRUE(after.report);
  EXPECT_NE(after.complex, before.complex);
  EXPECT_EQ(after.report->status, SolveStatus::Converged) << after.report->stop_reason;
  EXPECT_LE(off_plane(*after.complex, after.report->state), 1e-12);
}

TEST_F(SolveSessionTest, ErrorsAreOutcomes) {
  SolveRequest wanted = request("dome", 60);
  wanted.settings.weights["no such energy"] = 1.0;
  const std::uint64_t ticket = session_.start(wanted);
  const SolveOutcome refused = wait_for_outcome();
  EXPECT_EQ(refused.ticket, ticket);
  ASSERT_FALSE(refused.report);
  EXPECT_EQ(refused.report.error().code, ErrorCode::Usage);
  EXPECT_NE(refused.report.error().what.find("no such energy"), std::string::npos);

  wanted = request("dome", 60);
  wanted.settings.offset = std::numeric_limits<double>::quiet_NaN();
  session_.start(wanted);
  const SolveOutcome not_built = wait_for_outcome();
  ASSERT_FALSE(not_built.report);
  EXPECT_EQ(not_built.complex, nullptr);

  wanted = request("twisted-roof", 60);
  wanted.settings.mode = ComplexKind::Planarize;
  wanted.settings.freedom = Freedom::Fixed;
  session_.start(wanted);
  const SolveOutcome overdetermined = wait_for_outcome();
  ASSERT_FALSE(overdetermined.report);
  EXPECT_EQ(overdetermined.report.error().code, ErrorCode::Refused);

  // And the worker goes on.
  session_.start(request("dome", 60));
  EXPECT_TRUE(wait_for_outcome().report);
}

TEST(SolveSession, EndsWhileSolving) {
  std::atomic<int> rings = 0;
  for (int k = 0; k < 5; ++k) {
    Bell bell;
    SolveSession session([&] {
      ++rings;
      bell.ring();
    });
    SolveRequest request;
    request.mesh = shared_sample("train-station", 300);
    request.settings.tolerance = 1e-15;
    request.settings.max_iterations = 100000;
    session.start(request);
    if (k % 2 == 0) bell.wait_for_more_than(k);
    // The destructor stops the solve and joins.
  }
  EXPECT_GT(rings, 0);
}

TEST(SolveSession, EndsWithARequestWaiting) {
  SolveSession session;
  SolveRequest request;
  request.mesh = shared_sample("train-station", 300);
  request.settings.tolerance = 1e-15;
  session.start(request);
  session.start(request);
}

TEST(SolveSession, NeedsNobodyToWake) {
  SolveSession session;
  SolveRequest request;
  request.mesh = shared_sample("dome", 50);
  session.start(request);
  std::optional<SolveOutcome> outcome;
  while (!(outcome = session.take_outcome())) std::this_thread::yield();
  EXPECT_TRUE(outcome->report);
}

// Two sessions, as two windows in one process: the gate lets them factorise one after the other.
TEST(SolveSession, TwoSolveSideBySide) {
  SolveSession a, b;
  SolveRequest request;
  request.mesh = shared_sample("train-station", 100);
  a.start(request);
  b.start(request);
  std::optional<SolveOutcome> first, second;
  while (!first || !second) {
    if (!first) first = a.take_outcome();
    if (!second) second = b.take_outcome();
    std::this_thread::yield();
  }
  ASSERT_TRUE(first->report && second->report);
  EXPECT_TRUE(same_bits(first->report->state.x, second->report->state.x));
}

// What a person does to a slider, only faster. Every state handed out has to belong to the newest ticket and
// be whole; run under the thread sanitizer.
TEST_F(SolveSessionTest, SurvivesRapidRestarts) {
  std::mt19937 random(42);
  const auto mesh = shared_sample("train-station", 60);
  const auto other = shared_sample("dome", 40);
  std::shared_ptr<const Iterate> latest;
  std::uint64_t ticket = 0;
  for (int k = 0; k < 300; ++k) {
    SolveRequest wanted;
    wanted.mesh = random() % 4 ? mesh : other;
    wanted.settings.weights["fairing"] = static_cast<double>(random() % 100) / 50.0;
    if (random() % 8 == 0) wanted.settings.border = BorderPolicy::Interior;
    if (random() % 16 == 0) wanted.settings.weights["nothing"] = 1.0;
    if (latest && latest->complex->point_count() > 0 && random() % 2) wanted.warm_start = latest;
    ticket = session_.start(wanted);
    ASSERT_EQ(session_.current_ticket(), ticket);
    const int drains = static_cast<int>(random() % 4);
    for (int d = 0; d < drains; ++d) {
      if (random() % 2) std::this_thread::yield();
      // Whatever runs ends with a ring.
      const int seen = bell_.rings();
      if (random() % 2 && session_.running()) bell_.wait_for_more_than(seen);
      iterations_.clear();
      session_.drain_iterations(iterations_);
      for (size_t i = 1; i < iterations_.size(); ++i)
        ASSERT_EQ(iterations_[i].number, iterations_[i - 1].number + 1);
      if (auto iterate = session_.take_iterate()) {
        ASSERT_EQ(iterate->ticket, ticket);
        ASSERT_EQ(iterate->state.x.rows(), iterate->complex->point_count());
        ASSERT_EQ(iterate->state.n.rows(), iterate->complex->plane_count());
        latest = iterate;
      }
      if (auto outcome = session_.take_outcome()) {
        ASSERT_EQ(outcome->ticket, ticket);
      }
    }
    if (random() % 10 == 0) session_.stop();
  }
  SolveRequest last;
  last.mesh = mesh;
  ticket = session_.start(last);
  const SolveOutcome outcome = wait_for_outcome();
  EXPECT_EQ(outcome.ticket, ticket);
  ASSERT_TRUE(outcome.report);
  EXPECT_EQ(outcome.report->status, SolveStatus::Converged);
  EXPECT_FALSE(session_.running());
}

TEST(SolveSession, SolvesPanelsOfClustersAndOfOtherClustersOfTheSameMesh) {
  SolveSession session;
  SolveRequest request;
  request.mesh = shared_sample("torus", 400);
  request.settings.mode = ComplexKind::Cluster;
  const auto outcome_of = [&] {
    session.start(request);
    for (;;) {
      if (auto outcome = session.take_outcome()) return std::move(*outcome);
      std::this_thread::yield();
    }
  };
  const SolveOutcome refused = outcome_of();
  ASSERT_FALSE(refused.report);
  EXPECT_NE(refused.report.error().what.find("clustering"), std::string::npos);
  for (const int panels : {40, 60}) {
    ClusterOptions options;
    options.panels = panels;
    request.clusters = cluster_mesh(request.mesh, options).value();
    const SolveOutcome outcome = outcome_of();
    ASSERT_TRUE(outcome.report) << outcome.report.error().text();
    EXPECT_EQ(outcome.complex->plane_count(), request.clusters->regions.count());
  }
}

}  // namespace
}  // namespace planewright
