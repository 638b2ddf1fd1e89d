// Goals: what a comparison has to show, worked out of its rows: ratios of time, how time grows with size,
// memory. Rows that are missing make a goal "not measured"; a baseline that was cut off gives a bound.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "contenders.h"

namespace planewright::bench {

using Comparison = std::map<std::pair<std::string, Contender>, MeasuredRow>;  // by model and solver

void print_goals(const Comparison& rows);

}  // namespace planewright::bench
