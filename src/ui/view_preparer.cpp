#include "ui/view_preparer.h"

#include <algorithm>
#include <bit>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "ui/frame_timings.h"

namespace planewright::ui {
namespace {

std::uint64_t fingerprint(const Points& points) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const double* values = points.data();
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(values[i])) * 0x100000001b3u;
    hash ^= hash >> 29;
  }
  return hash;
}

}  // namespace

PreparedView prepare_view(const PrepareJob& job) {
  const Stopwatch watch;
  const TangentComplex& complex = *job.iterate->complex;
  const State& state = job.iterate->state;

  PreparedView view;
  view.iterate = job.iterate;
  view.final = job.final;
  const Vector3d shift = complex.origin - job.scene_origin;
  view.points = state.x.rowwise() + shift.transpose();
  view.planarity = measure_planarity(state.x, complex.panels);
  view.displacement = measure_displacement(state.x, complex.preferred);
  view.ill_determined = find_ill_determined(complex, state);
  if (view.points.rows() > 0) {
    view.low = view.points.colwise().minCoeff().transpose();
    view.high = view.points.colwise().maxCoeff().transpose();
  }
  view.fingerprint = fingerprint(state.x);
  view.milliseconds = watch.milliseconds();
  return view;
}

struct ViewPreparer::Impl {
  std::function<void()> wake;
  std::mutex mutex;  // held only while pointers move
  std::condition_variable_any changed;
  std::optional<PrepareJob> waiting;
  std::shared_ptr<const PreparedView> ready;
  std::jthread worker;  // last member: joins before the rest goes

  void run(const std::stop_token& stop) {
    for (;;) {
      PrepareJob job;
      {
        std::unique_lock lock(mutex);
        if (!changed.wait(lock, stop, [&] { return waiting.has_value(); })) return;
        job = std::move(*waiting);
        waiting.reset();
      }
      auto view = std::make_shared<const PreparedView>(prepare_view(job));
      {
        const std::lock_guard lock(mutex);
        std::swap(ready, view);
      }
      if (wake) wake();
    }
  }
};

ViewPreparer::ViewPreparer(std::function<void()> wake) : impl_(std::make_unique<Impl>()) {
  impl_->wake = std::move(wake);
  impl_->worker = std::jthread([impl = impl_.get()](const std::stop_token& stop) { impl->run(stop); });
}

ViewPreparer::~ViewPreparer() = default;

void ViewPreparer::submit(PrepareJob job) {
  std::optional<PrepareJob> replaced = std::move(job);
  {
    const std::lock_guard lock(impl_->mutex);
    std::swap(impl_->waiting, replaced);  // the old one is freed outside the lock
  }
  impl_->changed.notify_one();
}

std::shared_ptr<const PreparedView> ViewPreparer::take() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->ready, nullptr);
}

}  // namespace planewright::ui
