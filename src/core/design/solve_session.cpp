#include "core/design/solve_session.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <new>
#include <stop_token>
#include <thread>

#include "core/design/design.h"
#include "core/design/layer_solve.h"

namespace planewright {

struct SolveSession::Impl {
  explicit Impl(std::function<void()> wake_up) : wake(std::move(wake_up)) {}

  struct Job {
    SolveRequest request;
    std::uint64_t ticket = 0;
    std::stop_source stop;
    std::stop_source abandoned;  // superseded, or the session ends: nobody wants the result
    void abandon() {
      stop.request_stop();
      abandoned.request_stop();
    }
  };

  // Turns solver callbacks into mailbox and queue entries.
  class Publisher final : public SolveObserver {
   public:
    Publisher(Impl& session, const Job& job, std::shared_ptr<const TangentComplex> complex)
        : session_(session), job_(job), complex_(std::move(complex)) {}

    void on_iteration(const Iteration& iteration, const State* state) override {
      std::shared_ptr<const Iterate> iterate;
      if (state && iteration.planar)
        iterate = std::make_shared<const Iterate>(Iterate{job_.ticket, complex_, *state, iteration});
      session_.publish(job_.ticket, iteration, std::move(iterate));
    }

   private:
    Impl& session_;
    const Job& job_;
    std::shared_ptr<const TangentComplex> complex_;
  };

  void publish(std::uint64_t of_ticket, Iteration iteration, std::shared_ptr<const Iterate> iterate) {
    {
      const std::lock_guard lock(mutex);
      if (of_ticket != ticket) return;  // superseded
      iterations.push_back(std::move(iteration));
      if (iterate) mailbox.swap(iterate);
    }  // what the mailbox held before is freed here, outside the lock
    if (wake) wake();
  }

  void work(const std::stop_token& quit) {
    while (true) {
      {
        std::unique_lock lock(mutex);
        changed.wait(lock, quit, [this] { return pending.has_value(); });
        if (quit.stop_requested()) return;
        active = std::move(pending);
        pending.reset();
      }
      const Job& job = *active;
      std::stop_callback quit_abandons(quit, [stop = job.stop, abandoned = job.abandoned]() mutable {
        stop.request_stop();
        abandoned.request_stop();
      });
      std::optional<SolveOutcome> outcome = solve(job);
      std::optional<Job> done;  // dies, perhaps with the last reference to a mesh, outside the lock
      {
        const std::lock_guard lock(mutex);
        done.swap(active);
        if (done->ticket == ticket) finished.swap(outcome);
      }
      if (wake) wake();
    }
  }

  SolveOutcome solve(const Job& job) {
    const LayerSettings& settings = job.request.settings;
    SolveOutcome outcome{job.ticket, nullptr, fail(ErrorCode::Refused, "nothing was solved")};
    try {
      const ClusteredMesh* clusters =
          settings.mode == ComplexKind::Cluster ? job.request.clusters.get() : nullptr;
      if (job.request.mesh != built_from || job.request.clusters != built_of ||
          !same_complex(settings, built_with)) {
        auto complex = build_complex(*job.request.mesh, settings, clusters ? &clusters->regions : nullptr);
        if (!complex) {
          outcome.report = tl::unexpected(complex.error());
          return outcome;
        }
        built = std::move(*complex);
        built_from = job.request.mesh;
        built_of = job.request.clusters;
        built_with = settings;
      }
      outcome.complex = built;
      const Iterate* warm = job.request.warm_start.get();
      const State start = start_state(*built, settings, warm ? warm->complex.get() : nullptr,
                                      warm ? &warm->state : nullptr, job.request.edited.get());
      Publisher publisher(*this, job, built);
      SolveOptions options = solve_options(settings);
      options.abandoned = job.abandoned.get_token();
      options.near_solution = warm != nullptr;
      outcome.report =
          solve_layer(solver(job.request.solver),
                      {built, settings, job.request.selections, job.request.reference, job.request.neighbour},
                      start, options, &publisher, job.stop.get_token());
    } catch (const std::bad_alloc&) {
      outcome.report = fail(ErrorCode::Unavailable, "the machine has not enough memory for this design", {},
                            "Take a coarser mesh");
    } catch (const std::exception& bug) {
      // An exception is a bug of ours, but the designer's window, and with it the work, has to survive it.
      outcome.report = fail(ErrorCode::Unavailable, std::string("internal error: ") + bug.what(), {},
                            "Save your work and report what you did");
    }
    return outcome;
  }

  // Kept from request to request, with what it knows of their common topology.
  Solver& solver(SolverKind kind) {
    std::unique_ptr<Solver>& kept = solvers[kind];
    if (!kept) kept = make_solver(kind);
    return *kept;
  }

  std::function<void()> wake;

  mutable std::mutex mutex;  // guards all below up to the blank line; held for moving pointers only
  std::condition_variable_any changed;
  std::uint64_t ticket = 0;
  std::optional<Job> pending, active;
  std::shared_ptr<const Iterate> mailbox;
  std::vector<Iteration> iterations;
  std::optional<SolveOutcome> finished;

  // The worker's own: the last complex built, kept for requests that change weights alone.
  std::shared_ptr<const PolygonMesh> built_from;
  SharedClusters built_of;
  LayerSettings built_with;
  std::shared_ptr<const TangentComplex> built;
  std::map<SolverKind, std::unique_ptr<Solver>> solvers;

  std::jthread worker;  // last, so that it stops before what it uses goes
};

SolveSession::SolveSession(std::function<void()> wake) : impl_(std::make_unique<Impl>(std::move(wake))) {
  impl_->worker = std::jthread([impl = impl_.get()](const std::stop_token& quit) { impl->work(quit); });
}

SolveSession::~SolveSession() = default;

std::uint64_t SolveSession::start(SolveRequest request) {
  // Whatever the superseded request leaves is freed after the lock is released.
  std::optional<Impl::Job> dropped;
  std::shared_ptr<const Iterate> old_iterate;
  std::optional<SolveOutcome> old_outcome;
  std::uint64_t ticket;
  {
    const std::lock_guard lock(impl_->mutex);
    ticket = ++impl_->ticket;
    dropped.swap(impl_->pending);
    impl_->pending.emplace(Impl::Job{std::move(request), ticket, {}, {}});
    if (impl_->active) impl_->active->abandon();
    old_iterate.swap(impl_->mailbox);
    old_outcome.swap(impl_->finished);
    impl_->iterations.clear();
  }
  impl_->changed.notify_one();
  return ticket;
}

void SolveSession::stop() {
  const std::lock_guard lock(impl_->mutex);
  if (impl_->active) impl_->active->stop.request_stop();
  if (impl_->pending) impl_->pending->stop.request_stop();
}

bool SolveSession::running() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->pending || impl_->active;
}

std::uint64_t SolveSession::current_ticket() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->ticket;
}

std::shared_ptr<const Iterate> SolveSession::take_iterate() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->mailbox, nullptr);
}

void SolveSession::drain_iterations(std::vector<Iteration>& out) {
  std::vector<Iteration> taken;
  {
    const std::lock_guard lock(impl_->mutex);
    taken.swap(impl_->iterations);
  }
  out.insert(out.end(), taken.begin(), taken.end());
}

std::optional<SolveOutcome> SolveSession::take_outcome() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->finished, std::nullopt);
}

}  // namespace planewright
