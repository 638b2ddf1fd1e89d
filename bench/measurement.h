// Measurement: what is told of one solve; plain data, so that it can come from another process.
#pragma once

#include <limits>
#include <string>

#include "child_process.h"
#include "core/complex/tangent_complex.h"
#include "core/solve/solve_report.h"

namespace planewright::bench {

// CPU time of this process so far, all threads, seconds.
double cpu_seconds();
// Wall clock, seconds from some fixed moment.
double wall_seconds();

struct Measurement {
  int panels = 0;
  SolveStatus status = SolveStatus::Failed;
  char reason[160] = {};         // SolveReport::stop_reason
  char solver[24] = {};          // SolveReport::solver
  double wall = 0.0, cpu = 0.0;  // of building the problem and solving it
  int iterations = 0;
  int ipopt_iterations = 0;  // of these, Ipopt's
  // First-order residual at the reported state by the one function of common_stop.h; nan: not measured.
  double residual = std::numeric_limits<double>::quiet_NaN();
  double planarity = 0.0;       // relative to the diagonal of the bounding box
  double energy = 0.0;          // sum |x - f|^2, mean edges squared
  double rms = 0.0, max = 0.0;  // displacement, mean edges
  int self_crossing = 0;        // panels
  int crossings = -1;           // pairs of a panel and a mesh face; -1: not counted
};

// Fills in all but times, residual and ipopt_iterations. mean_edge: model units, also where the complex calls
// something else its edge (raw_coordinates).
void measure_report(Measurement& row, const SolveReport& report, const TangentComplex& complex,
                    double mean_edge);

using MeasuredRow = ChildOutcome<Measurement>;

// "converged", "cut off", ... in at most 11 characters.
std::string verdict(const MeasuredRow& row);

// Runs `work` up to `repeats` times and gives the run with the least CPU time; the first one that does not
// finish ends it and is the answer.
MeasuredRow best_of(int repeats, const std::function<Measurement()>& work, const ChildLimits& limits);

}  // namespace planewright::bench
