#include "table.h"

#include <cmath>
#include <cstdio>

namespace planewright::bench {
namespace {

// A dash where there is nothing to tell.
std::string number(const char* format, double value) {
  if (!std::isfinite(value)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// Below a row that did not end as it should.
void print_reason(const MeasuredRow& row) {
  if (row.end != ChildEnd::Finished)
    std::printf("    %s\n", row.why.c_str());
  else if (row.value.status != SolveStatus::Converged)
    std::printf("    %s\n", row.value.reason);
  std::fflush(stdout);
}

// Times and memory of a row that has nothing else are the whole child's.
double wall(const MeasuredRow& row) {
  return row.end == ChildEnd::Finished ? row.value.wall : row.usage.wall;
}
double cpu(const MeasuredRow& row) {
  return row.end == ChildEnd::Finished ? row.value.cpu : row.usage.cpu;
}

}  // namespace

void print_solver_head() {
  std::printf("%-24s %7s %8s %8s %5s %6s %8s %9s %10s %7s %7s %s\n", "", "panels", "wall s", "CPU s", "iter",
              "MB", "residual", "planarity", "energy", "rms", "max", "status");
}

void print_solver_row(const std::string& name, const MeasuredRow& row) {
  std::printf("%-24s ", name.c_str());
  if (row.end == ChildEnd::Finished) {
    const Measurement& m = row.value;
    std::printf("%7d %8.3f %8.3f %5d %6.0f %8s %9.1e %10.6g %7.4f %7.4f", m.panels, m.wall, m.cpu,
                m.iterations, row.usage.peak_mb, number("%.1e", m.residual).c_str(), m.planarity, m.energy,
                m.rms, m.max);
  } else {
    std::printf("%7s %8.3f %8.3f %5s %6.0f %8s %9s %10s %7s %7s", "-", wall(row), cpu(row), "-",
                row.usage.peak_mb, "-", "-", "-", "-", "-");
  }
  std::printf(" %s\n", verdict(row).c_str());
  print_reason(row);
}

void print_demand_head() {
  std::printf("%-25s %6s %-7s %7s %7s %5s %6s %6s %6s %9s %6s %5s %s\n", "", "offset", "solver", "wall s",
              "CPU s", "iter", "MB", "rms", "max", "planarity", "self-x", "cross", "status");
}

void print_demand_row(const std::string& name, double offset, const std::string& solver,
                      const MeasuredRow& row) {
  std::printf("%-25s %6g %-7s ", name.c_str(), offset, solver.c_str());
  if (row.end == ChildEnd::Finished) {
    const Measurement& m = row.value;
    std::printf("%7.2f %7.2f %5d %6.0f %6.3f %6.3f %9.1e %6d %5s", m.wall, m.cpu, m.iterations,
                row.usage.peak_mb, m.rms, m.max, m.planarity, m.self_crossing,
                m.crossings < 0 ? "-" : std::to_string(m.crossings).c_str());
  } else {
    std::printf("%7.2f %7.2f %5s %6.0f %6s %6s %9s %6s %5s", wall(row), cpu(row), "-", row.usage.peak_mb, "-",
                "-", "-", "-", "-");
  }
  std::printf(" %s\n", verdict(row).c_str());
  print_reason(row);
}

void print_skipped(const std::string& name, const std::string& why) {
  std::printf("%-24s SKIPPED: %s\n", name.c_str(), why.c_str());
  std::fflush(stdout);
}

}  // namespace planewright::bench
