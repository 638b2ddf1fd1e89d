// Constraint: rows that have to stay between bounds; equal bounds make an equation.
//
// A demand of the designer becomes one or more constraints (demands/demand_catalogue.h); incidence and unit
// length of the normals are constraints that every problem has.
#pragma once

#include <span>
#include <string_view>

#include "core/problem/element.h"
#include "core/problem/row_family.h"

namespace planewright {

struct Bounds {
  double low, high;  // +-kUnbounded for none
};
inline constexpr double kUnbounded = 1e20;
inline constexpr double kNoLimit = 1e19;  // bounds beyond this are none

class Constraint : public RowFamily {
 public:
  // The demand that a designer knows it by: "vertex", "pin". Several constraints may share one.
  virtual std::string_view name() const = 0;
  virtual Bounds bounds(int row) const = 0;
  // What a violation is measured in: "edges", "" (unit-free).
  virtual std::string_view unit() const = 0;
  // What the row is about.
  virtual ElementRef element(int row) const = 0;

  // Rows that need not hold at z, because another row of the same alternative does better there ("one of the
  // two diagonals of a quad"): sets waived[row] (#rows) to 1 for those and leaves the others alone. Most
  // constraints have no alternatives.
  virtual void waive_alternatives(const double* /*z*/, std::span<char> /*waived*/) const {}
};

}  // namespace planewright
