#include "ui/view_preparer.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "core/layers/beams.h"
#include "ui/frame_timings.h"

namespace planewright::ui {
namespace {

// Findings that take no longer come with their view: a list that is there in every frame does not flicker.
constexpr double kQuickFindings = 4;  // milliseconds
// A state on the way of a slow solve is searched only when none has followed for so long: the solver needs
// the machine more.
constexpr std::chrono::milliseconds kRest{300};

std::uint64_t fingerprint(const Points& points) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const double* values = points.data();
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(values[i])) * 0x100000001b3u;
    hash ^= hash >> 29;
  }
  return hash;
}

// shift: from the first complex's origin to the scene's.
PreparedBeams prepare_beams(const TangentComplex& first, const State& first_state,
                            const TangentComplex& second, const State& second_state, const Vector3d& shift) {
  PreparedBeams out;
  const Result<Beams> beams = make_beams(first, first_state, second, second_state);
  if (!beams) {
    out.refused = beams.error().what;
    return out;
  }
  const Points points = beams->points.rowwise() + shift.transpose();
  out.arrays = render::make_panel_arrays(points, beams->quads);
  out.arrays.shadow.reset();
  out.count = beams->quads.size();
  for (std::size_t i = 0; i < beams->twist.size(); ++i) {
    out.planarity = std::max(out.planarity, beams->planarity[i]);
    if (out.most_twisted >= 0 && !(beams->twist[i] > out.twist)) continue;
    out.twist = beams->twist[i];
    out.most_twisted = beams->edge[i];
  }
  return out;
}

std::shared_ptr<const PreparedThickness> prepare_thickness(const TangentComplex& complex, const State& state,
                                                           double thickness, const Vector3d& shift) {
  ParallelOffset offset = parallel_offset(complex, state, thickness);
  auto out = std::make_shared<PreparedThickness>();
  const Points points = offset.state.x.rowwise() + shift.transpose();
  out->back = render::make_panel_arrays(points, complex.panels);
  out->back.shadow.reset();
  out->sides = prepare_beams(complex, state, complex, offset.state, shift);
  out->blunted = std::move(offset.blunted);
  out->residuals = std::move(offset.residuals);
  for (const auto& residual : out->residuals) {
    out->largest_residual = std::max(out->largest_residual, residual.residual);
  }
  return out;
}

}  // namespace

PreparedView prepare_view(const PrepareJob& job, std::shared_ptr<const render::PanelGeometry> before) {
  const Stopwatch watch;
  const TangentComplex& complex = *job.iterate->complex;
  const State& state = job.iterate->state;

  PreparedView view;
  view.iterate = job.iterate;
  view.ids = job.ids;
  view.final = job.final;
  view.layer = job.layer;
  view.number = job.number;
  view.thickness_wanted = job.thickness;
  const Vector3d shift = complex.origin - job.scene_origin;
  view.points = state.x.rowwise() + shift.transpose();
  view.panels = render::make_panel_arrays(view.points, complex.panels, std::move(before));
  view.planarity = measure_planarity(state.x, complex.panels);
  view.displacement = measure_displacement(state.x, complex.preferred);
  if (job.thickness != 0.0) view.thickness = prepare_thickness(complex, state, job.thickness, shift);
  if (job.neighbour) {
    view.beams = std::make_shared<const PreparedBeams>(
        prepare_beams(complex, state, *job.neighbour->complex, job.neighbour->state, shift));
  }
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
  std::vector<PrepareJob> waiting;  // one per layer, the longest waiting first
  std::shared_ptr<const MeshView> waiting_mesh;
  std::vector<std::shared_ptr<const PreparedView>> ready;               // one per layer
  std::vector<std::shared_ptr<const PreparedFindings>> ready_findings;  // one per layer
  std::shared_ptr<const PreparedGhost> ready_ghost;
  std::jthread worker;  // last member: joins before the rest goes

  void run(const std::stop_token& stop);
  void deliver(std::shared_ptr<const PreparedGhost> made) {
    {
      const std::lock_guard lock(mutex);
      std::swap(ready_ghost, made);  // the old one is freed outside the lock
    }
    if (wake) wake();
  }
  // Either may be null.
  void deliver(std::shared_ptr<const PreparedView> view, std::shared_ptr<const PreparedFindings> findings) {
    {
      const std::lock_guard lock(mutex);
      if (view) put(ready, view);
      if (findings) put(ready_findings, findings);
    }
    if (wake) wake();
  }
  // In the place of what is there of the same layer; that is freed by the caller, outside the lock.
  template <class T>
  static void put(std::vector<std::shared_ptr<const T>>& list, std::shared_ptr<const T>& made) {
    const auto same =
        std::find_if(list.begin(), list.end(), [&](const auto& old) { return old->layer == made->layer; });
    if (same == list.end()) {
      list.push_back(std::move(made));
    } else {
      std::swap(*same, made);
    }
  }
};

void ViewPreparer::Impl::run(const std::stop_token& stop) {
  struct OfLayer {
    std::weak_ptr<const render::PanelGeometry> geometry;  // kept alive by whoever shows the view
    double findings_milliseconds = kQuickFindings + 1;    // that the last ones took
  };
  std::map<std::uint64_t, OfLayer> layers;
  std::vector<PrepareJob> unsearched;  // whose findings are due, one per layer
  for (;;) {
    std::optional<PrepareJob> job;
    std::shared_ptr<const MeshView> mesh;
    bool search = false;
    {
      std::unique_lock lock(mutex);
      const auto due = [&] { return !waiting.empty() || waiting_mesh; };
      if (unsearched.empty()) {
        changed.wait(lock, stop, due);
      } else if (!unsearched.front().final) {
        changed.wait_for(lock, stop, kRest, due);
      }
      if (stop.stop_requested()) return;
      mesh = std::exchange(waiting_mesh, nullptr);
      search = !mesh && waiting.empty();
      if (!mesh) {
        auto& from = search ? unsearched : waiting;
        job = std::move(from.front());
        from.erase(from.begin());
      }
    }
    if (mesh) {
      auto arrays = render::make_ghost_arrays(mesh->points, mesh->faces);
      deliver(std::make_shared<const PreparedGhost>(PreparedGhost{std::move(mesh), std::move(arrays)}));
      continue;
    }
    const auto of_layer = [&](const PrepareJob& other) { return other.layer == job->layer; };
    OfLayer& of = layers[job->layer];
    std::shared_ptr<const PreparedView> view;
    if (!search) {
      view = std::make_shared<const PreparedView>(prepare_view(*job, of.geometry.lock()));
      of.geometry = view->panels.geometry;
      std::erase_if(unsearched, of_layer);
    }
    std::shared_ptr<const PreparedFindings> findings;
    if (search || of.findings_milliseconds <= kQuickFindings) {
      findings = std::make_shared<const PreparedFindings>(prepare_findings(*job));
      of.findings_milliseconds = findings->milliseconds;
    } else {
      unsearched.push_back(*std::move(job));
    }
    std::erase_if(layers, [](const auto& entry) { return entry.second.geometry.expired(); });
    deliver(std::move(view), std::move(findings));
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
    const auto same = std::find_if(impl_->waiting.begin(), impl_->waiting.end(),
                                   [&](const PrepareJob& waits) { return waits.layer == replaced->layer; });
    if (same == impl_->waiting.end()) {
      impl_->waiting.push_back(*std::move(replaced));
    } else {
      std::swap(*same, *replaced);  // the old one is freed outside the lock
    }
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
  if (impl_->ready.empty()) return nullptr;
  auto view = std::move(impl_->ready.front());
  impl_->ready.erase(impl_->ready.begin());
  return view;
}

std::shared_ptr<const PreparedFindings> ViewPreparer::take_findings() {
  const std::lock_guard lock(impl_->mutex);
  if (impl_->ready_findings.empty()) return nullptr;
  auto findings = std::move(impl_->ready_findings.front());
  impl_->ready_findings.erase(impl_->ready_findings.begin());
  return findings;
}

std::shared_ptr<const PreparedGhost> ViewPreparer::take_ghost() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->ready_ghost, nullptr);
}

}  // namespace planewright::ui
