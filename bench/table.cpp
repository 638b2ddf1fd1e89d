#include "table.h"

#include <sys/resource.h>

#include <cstdio>

#include "core/diagnose/panel_shape.h"

namespace planewright::bench {

double cpu_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void measure_state(Row& row, const TangentComplex& complex, double mean_edge) {
  row.displacement = measure_displacement(row.report.state.x, complex.preferred);
  row.energy = row.displacement.per_point.squaredNorm() / (mean_edge * mean_edge);
  row.displacement.rms /= mean_edge;
  row.displacement.max /= mean_edge;
  const Panels panels = panels_of(complex, row.report.state);
  row.planarity = measure_planarity(panels.points, panels.polygons);
  row.self_crossing = static_cast<int>(find_self_crossing(panels.points, panels.polygons).size());
}

void print_head() {
  std::printf("%-34s %9s %9s %6s %12s %8s %8s %9s %6s %6s  %s\n", "", "wall s", "CPU s", "iter", "energy",
              "rms", "max", "planarity", "self-x", "cross", "status");
}

void print(const Row& row) {
  const std::string crossings = row.report.crossings < 0 ? "-" : std::to_string(row.report.crossings);
  std::printf("%-34s %9.2f %9.2f %6d %12.6g %8.4f %8.4f %9.1e %6d %6s  %s\n", row.name.c_str(), row.wall,
              row.cpu, row.report.iterations, row.energy, row.displacement.rms, row.displacement.max,
              row.planarity.max_relative_to_bbox, row.self_crossing, crossings.c_str(),
              name(row.report.status));
  std::fflush(stdout);
}

}  // namespace planewright::bench
