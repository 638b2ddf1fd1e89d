// What a running solve tells about itself: one Iteration per step, handed to a SolveObserver.
#pragma once

#include <vector>

#include "core/complex/state.h"
#include "core/problem/problem.h"

namespace planewright {

// Scalars of one iteration. Lengths in mean edges (see TangentComplex::mean_edge), energies in weighted
// units.
struct Iteration {
  int number = 0;
  double objective = 0.0;      // sum of the weighted energies
  double infeasibility = 0.0;  // largest constraint violation
  double first_order = 0.0;    // inf-norm of the Lagrangian's gradient
  double step = 0.0;           // inf-norm of the last step
  double seconds = 0.0;        // wall time since the solve began
  const char* solver = "";     // who made it: "tangent", "ipopt"
  bool planar = false;         // the state told with it lies on all planes to rounding (1e-9 edges)
  bool restoration = false;    // the solver left the objective aside to find feasibility
  std::vector<Problem::EnergyShare> energies;  // what each adds to the objective; empty in restoration
};

// Called on the solving thread, once per iteration. Must be quick and must not throw.
class SolveObserver {
 public:
  virtual ~SolveObserver() = default;
  // `state` is null where there is none to show: in Ipopt's restoration phase, whose iterates are not this
  // problem's, and at steps of the tangent solver that it does not project.
  virtual void on_iteration(const Iteration& iteration, const State* state) = 0;
  // Whether it looks at states at all: those of the tangent solver cost a projection each.
  virtual bool wants_states() const { return true; }
};

}  // namespace planewright
