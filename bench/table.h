// The tables: one line per measurement, units in the head, at most 120 columns.
#pragma once

#include <string>

#include "measurement.h"

namespace planewright::bench {

// For solvers side by side.
void print_solver_head();
void print_solver_row(const std::string& name, const MeasuredRow& row);

// For solves with demands. offset: mean panel edges.
void print_demand_head();
void print_demand_row(const std::string& name, double offset, const std::string& solver,
                      const MeasuredRow& row);

// For what was not measured at all.
void print_skipped(const std::string& name, const std::string& why);

}  // namespace planewright::bench
