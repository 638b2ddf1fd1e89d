#include "ui/advice_task.h"

#include <sys/resource.h>

#include <chrono>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>

namespace planewright::ui {
namespace {

using namespace std::chrono_literals;

// A frame for every edit that is rated would cost more than the rating.
constexpr auto kBetweenWakes = 150ms;
constexpr int kNiceness = 10;

struct Wish {
  MeshEdit edit;
  std::optional<Candidate> candidate;
};

// Two findings can call for the same edit. Those at one edge stand beside each other.
std::vector<Candidate> each_once(std::vector<Candidate> candidates) {
  std::vector<Candidate> once;
  for (Candidate& candidate : candidates) {
    bool known = false;
    for (auto other = once.rbegin(); other != once.rend() && other->mesh_edge == candidate.mesh_edge; ++other)
      known = known || other->edit == candidate.edit;
    if (!known) once.push_back(std::move(candidate));
  }
  return once;
}

// A job under way, on the worker alone.
struct Work {
  AdviceJob job;
  std::stop_token stop;
  std::optional<Result<PatchSolver>> solver;
  std::optional<std::vector<Candidate>> candidates;
  std::size_t next = 0;
  bool told_end = false;

  bool rating() const { return job.rates && !told_end; }
  const PatchSolver* ready() {
    if (!solver) {
      solver = PatchSolver::create(
          {job.mesh, job.iterate->complex, job.iterate->state, job.settings, job.selections, job.reference});
    }
    return *solver ? &**solver : nullptr;
  }
  // The candidates that share a patch, which is then solved once as it is.
  std::vector<Candidate> next_group() {
    std::vector<Candidate> group;
    while (next < candidates->size() &&
           (group.empty() || (*candidates)[next].centre == group.front().centre)) {
      group.push_back((*candidates)[next++]);
    }
    return group;
  }
};

}  // namespace

struct AdviceTask::Impl {
  std::function<void()> wake;
  std::mutex mutex;  // held only while values move
  std::condition_variable_any changed;
  std::optional<AdviceJob> waiting;
  bool dropped = false;          // the present job is not wanted any more
  std::stop_source stop_source;  // of the newest job
  std::optional<Wish> wish;
  std::optional<AdviceNews> news;
  std::chrono::steady_clock::time_point woken{};  // the worker's own
  std::jthread worker;                            // last member: joins before the rest goes

  void run(const std::stop_token& stop);
  void rate_next(Work& work);

  // Hands over what `add` puts into the news, unless the work is not wanted any more.
  template <class Add>
  void tell(const Work& work, bool at_once, Add add) {
    {
      const std::lock_guard lock(mutex);
      if (work.stop.stop_requested()) return;
      if (!news) news.emplace().number = work.job.number;
      add(*news);
    }
    const auto now = std::chrono::steady_clock::now();
    if (!at_once && now - woken < kBetweenWakes) return;
    woken = now;
    if (wake) wake();
  }
  // To be freed outside the lock.
  using Forgotten = std::pair<std::optional<AdviceJob>, std::optional<AdviceNews>>;
  Forgotten forget() {
    stop_source.request_stop();
    stop_source = {};
    wish.reset();
    dropped = true;
    return {std::exchange(waiting, std::nullopt), std::exchange(news, std::nullopt)};
  }
};

void AdviceTask::Impl::rate_next(Work& work) {
  const PatchSolver* solver = work.ready();
  if (solver == nullptr) {
    work.told_end = true;
    tell(work, true, [&](AdviceNews& of) {
      of.refused = work.solver->error();
      of.listed = of.done = true;
    });
    return;
  }
  std::vector<Suggestion> rated;
  if (!work.candidates) {
    work.candidates = each_once(find_candidates(solver->advised(), work.job.findings->diagnosis.findings));
  } else {
    AdviceOptions options;
    options.radius = kAdviceRadius;
    rated = rate(*solver, work.next_group(), options, {}, work.stop);
  }
  work.told_end = work.next == work.candidates->size();
  tell(work, work.told_end, [&](AdviceNews& of) {
    of.rated.insert(of.rated.end(), std::make_move_iterator(rated.begin()),
                    std::make_move_iterator(rated.end()));
    of.tried = static_cast<int>(work.next);
    of.candidates = static_cast<int>(work.candidates->size());
    of.listed = true;
    of.done = work.told_end;
  });
}

void AdviceTask::Impl::run(const std::stop_token& stop) {
  setpriority(PRIO_PROCESS, 0, kNiceness);  // on Linux: of this thread
  std::optional<Work> work;
  for (;;) {
    std::optional<Wish> wanted;
    std::optional<Work> old;
    {
      std::unique_lock lock(mutex);
      changed.wait(lock, stop, [&] { return waiting || dropped || (work && (wish || work->rating())); });
      if (stop.stop_requested()) return;
      if (std::exchange(dropped, false)) old = std::exchange(work, std::nullopt);
      if (waiting)
        work = Work{*std::exchange(waiting, std::nullopt), stop_source.get_token(), {}, {}, 0, false};
      if (work) wanted = std::exchange(wish, std::nullopt);
    }
    old.reset();
    if (wanted) {
      const PatchSolver* solver = work->ready();
      auto made = std::make_shared<EditPreview>(EditPreview{wanted->edit, {}, {}});
      if (solver != nullptr) {
        *made = preview(*solver, wanted->edit, std::move(wanted->candidate), kAdviceRadius, work->stop);
      }
      tell(*work, true, [&](AdviceNews& of) { of.previews.push_back(std::move(made)); });
    } else if (work && work->rating()) {
      rate_next(*work);
    }
  }
}

AdviceTask::AdviceTask(std::function<void()> wake) : impl_(std::make_unique<Impl>()) {
  impl_->wake = std::move(wake);
  impl_->worker = std::jthread([impl = impl_.get()](const std::stop_token& stop) { impl->run(stop); });
}

AdviceTask::~AdviceTask() {
  stop();
}

void AdviceTask::submit(AdviceJob job) {
  Impl::Forgotten old;
  {
    const std::lock_guard lock(impl_->mutex);
    old = impl_->forget();
    impl_->waiting = std::move(job);
  }
  impl_->changed.notify_one();
}

void AdviceTask::stop() {
  Impl::Forgotten old;
  {
    const std::lock_guard lock(impl_->mutex);
    old = impl_->forget();
  }
  impl_->changed.notify_one();
}

void AdviceTask::want(const MeshEdit& edit, std::optional<Candidate> candidate) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->wish = Wish{edit, std::move(candidate)};
  }
  impl_->changed.notify_one();
}

std::optional<AdviceNews> AdviceTask::take() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->news, std::nullopt);
}

}  // namespace planewright::ui
