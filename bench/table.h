// What every benchmark of this program measures of a solve, and how it prints it.
#pragma once

#include <string>

#include "core/diagnose/planarity.h"
#include "core/solve/solve_report.h"

namespace planewright::bench {

// User and system time of this process so far.
double cpu_seconds();

struct Row {
  std::string name;
  SolveReport report;
  double wall = 0.0, cpu = 0.0;
  double energy = 0.0;        // sum |x - f|^2, mean edges squared
  Displacement displacement;  // mean edges
  Planarity planarity;
  int self_crossing = 0;
};

// Fills in what follows from report.state. complex: that it belongs to; mean_edge: model units.
void measure_state(Row& row, const TangentComplex& complex, double mean_edge);

void print_head();
void print(const Row& row);

}  // namespace planewright::bench
