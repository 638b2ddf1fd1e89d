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

PreparedView prepare_view(const PrepareJob& job, std::shared_ptr<const render::PanelGeometry> before) {
  const Stopwatch watch;
  const TangentComplex& complex = *job.iterate->complex;
  const State& state = job.iterate->state;

  PreparedView view;
  view.iterate = job.iterate;
  view.final = job.final;
  const Vector3d shift = complex.origin - job.scene_origin;
  view.points = state.x.rowwise() + shift.transpose();
  view.panels = render::make_panel_arrays(view.points, complex.panels, std::move(before));
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
  std::shared_ptr<const MeshView> waiting_mesh;
  std::shared_ptr<const PreparedView> ready;
  std::shared_ptr<const PreparedGhost> ready_ghost;
  std::jthread worker;  // last member: joins before the rest goes

  void run(const std::stop_token& stop);
  template <class T>
  void deliver(std::shared_ptr<const T>& to, std::shared_ptr<const T> made) {
    {
      const std::lock_guard lock(mutex);
      std::swap(to, made);  // the old one is freed outside the lock
    }
    if (wake) wake();
  }
};

void ViewPreparer::Impl::run(const std::stop_token& stop) {
  std::shared_ptr<const render::PanelGeometry> geometry;  // of the last view
  for (;;) {
    std::optional<PrepareJob> job;
    std::shared_ptr<const MeshView> mesh;
    {
      std::unique_lock lock(mutex);
      if (!changed.wait(lock, stop, [&] { return waiting || waiting_mesh; })) return;
      mesh = std::exchange(waiting_mesh, nullptr);
      if (!mesh) job = std::exchange(waiting, std::nullopt);
    }
    if (mesh) {
      auto arrays = render::make_ghost_arrays(mesh->points, mesh->faces);
      deliver(ready_ghost,
              std::make_shared<const PreparedGhost>(PreparedGhost{std::move(mesh), std::move(arrays)}));
    } else {
      auto view = std::make_shared<const PreparedView>(prepare_view(*job, std::move(geometry)));
      geometry = view->panels.geometry;
      deliver(ready, std::move(view));
    }
  }
}

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

void ViewPreparer::submit(std::shared_ptr<const MeshView> mesh) {
  {
    const std::lock_guard lock(impl_->mutex);
    std::swap(impl_->waiting_mesh, mesh);
  }
  impl_->changed.notify_one();
}

std::shared_ptr<const PreparedView> ViewPreparer::take() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->ready, nullptr);
}

std::shared_ptr<const PreparedGhost> ViewPreparer::take_ghost() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->ready_ghost, nullptr);
}

}  // namespace planewright::ui
