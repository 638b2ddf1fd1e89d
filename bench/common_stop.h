// CommonStop: one question for every solver, "are you there yet?", asked and answered in the same units
// whatever coordinates a solver works in, so that their times are times to the same place.
//
// A state is there if its first-order residual (inf-norm of the Lagrangian's gradient, largest weight 1,
// lengths in mean edges: Problem::first_order_residual of the normalised problem) is at most the tolerance
// and no row, incidence or unit normal, is violated by more than `feasible`. Threads: immutable.
#pragma once

#include <memory>

#include "core/problem/problem.h"

namespace planewright::bench {

struct StopTest {
  double tolerance = 1e-3;  // first-order residual
  double feasible = 1e-7;   // mean edges, and unit-free; as the shipped solvers ask
};

// The projection that follows a baseline's stop may move its residual by this much.
inline constexpr double kAfterProjection = 1.05;

class CommonStop {
 public:
  // normalised: the problem in mean edges. solved: what the solver works on, the same problem or the one in
  // raw coordinates. Energies have to be squared lengths (position, fairing, ...), and there may be no rows
  // but incidences and unit normals: what both are in other units is then known.
  CommonStop(std::shared_ptr<const Problem> normalised, std::shared_ptr<const Problem> solved,
             const StopTest& test);

  // z, multipliers: of the solved problem.
  bool met(const Vector& z, const Vector& multipliers) const;
  // The residual by itself; nan where a solver tells no multipliers. state: model units.
  double residual(const State& state, const Vector& multipliers) const;

 private:
  Vector normalised_multipliers(const Vector& multipliers) const;

  std::shared_ptr<const Problem> normalised_, solved_;
  double scale_;  // mean edges in units of the solved problem
  StopTest test_;
};

}  // namespace planewright::bench
