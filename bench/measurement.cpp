#include "measurement.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "core/diagnose/panel_shape.h"
#include "core/diagnose/planarity.h"

namespace planewright::bench {

double cpu_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void measure_report(Measurement& row, const SolveReport& report, const TangentComplex& complex,
                    double mean_edge) {
  row.panels = complex.plane_count();
  row.status = report.status;
  std::snprintf(row.reason, sizeof row.reason, "%s", report.stop_reason.c_str());
  std::snprintf(row.solver, sizeof row.solver, "%s", report.solver.c_str());
  row.iterations = report.iterations;
  row.crossings = report.crossings;
  const Displacement displacement = measure_displacement(report.state.x, complex.preferred);
  row.energy = displacement.per_point.squaredNorm() / (mean_edge * mean_edge);
  row.rms = displacement.rms / mean_edge;
  row.max = displacement.max / mean_edge;
  const Panels panels = panels_of(complex, report.state);
  row.planarity = measure_planarity(panels.points, panels.polygons).max_relative_to_bbox;
  row.self_crossing = static_cast<int>(find_self_crossing(panels.points, panels.polygons).size());
}

std::string verdict(const MeasuredRow& row) {
  switch (row.end) {
    case ChildEnd::CutOff:
      return "cut off";
    case ChildEnd::Failed:
      return "failed";
    case ChildEnd::Crashed:
      return "crashed";
    case ChildEnd::Finished:
      break;
  }
  return row.value.status == SolveStatus::Planar ? "unconverged" : name(row.value.status);
}

MeasuredRow best_of(int repeats, const std::function<Measurement()>& work, const ChildLimits& limits) {
  MeasuredRow best = run_in_child<Measurement>(work, limits);
  for (int k = 1; k < repeats && best.end == ChildEnd::Finished; ++k) {
    MeasuredRow next = run_in_child<Measurement>(work, limits);
    if (next.end != ChildEnd::Finished || next.value.cpu < best.value.cpu) best = std::move(next);
  }
  return best;
}

}  // namespace planewright::bench
