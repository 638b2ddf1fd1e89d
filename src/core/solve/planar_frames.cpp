#include "core/solve/planar_frames.h"

#include "core/solve/demand_projection.h"

namespace planewright {
namespace {

// Steps between two frames; the first kEager steps after a start close to planar are all shown, because a
// slider that is being dragged ends most solves after them.
constexpr int kEager = 3, kNearInterval = 4, kFarInterval = 8;
// A frame may be left out rather than wait for a projection that finds no way.
constexpr int kMostSteps = 30;

}  // namespace

PlanarFrames::PlanarFrames(const Problem& problem, SolveObserver* observer, TangentCache& cache,
                           std::stop_token stop)
    : problem_(problem),
      observer_(observer),
      cache_(cache),
      stop_(std::move(stop)),
      begun_(std::chrono::steady_clock::now()) {}

void PlanarFrames::tell_start(const Vector& z) {
  if (observer_) hand_out(z, 0.0, 0.0, observer_->wants_states());
}

void PlanarFrames::tell(const Vector& z, double first_order, double step, Distance distance) {
  ++number_;
  if (!observer_) return;
  ++since_frame_;
  const bool near = distance == Distance::Near;
  const bool due = (near && number_ <= kEager) || since_frame_ >= (near ? kNearInterval : kFarInterval);
  if (due) since_frame_ = 0;
  hand_out(z, first_order, step, due && observer_->wants_states());
}

void PlanarFrames::hand_out(const Vector& z, double first_order, double step, bool with_state) {
  Iteration iteration;
  iteration.number = number_;
  iteration.solver = "tangent";
  iteration.first_order = first_order;
  iteration.step = step;
  const auto measure = [&](const Vector& at) {
    iteration.energies = problem_.energy_shares(at.data());
    iteration.objective = iteration.infeasibility = 0.0;
    for (const auto& share : iteration.energies) iteration.objective += share.value;
    for (const auto& v : problem_.violations(at.data(), kDemandTolerance))
      iteration.infeasibility = std::max(iteration.infeasibility, v.max_violation);
  };
  measure(z);
  std::optional<State> state;
  if (with_state) {
    Vector frame = z;
    const DemandProjectionReport report =
        project_onto_demands(problem_, frame, kMostSteps, stop_, &cache_, kFrameTarget);
    // Demands may be out of reach here; planar is what a frame has to be.
    iteration.planar = report.planar;
    if (report.planar) {
      state = problem_.to_state({frame.data(), static_cast<size_t>(frame.size())});
      newest_ = std::move(frame);
      newest_meets_demands_ = report.met;
    }
  }
  iteration.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  observer_->on_iteration(iteration, state ? &*state : nullptr);
}

}  // namespace planewright
