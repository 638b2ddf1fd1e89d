// Constraint: rows that have to stay between bounds; equal bounds make an equation.
#pragma once

#include <string_view>

#include "core/problem/row_family.h"

namespace planewright {

struct Bounds {
  double low, high;  // +-kUnbounded for none
};
inline constexpr double kUnbounded = 1e20;

class Constraint : public RowFamily {
 public:
  virtual std::string_view name() const = 0;
  virtual Bounds bounds(int row) const = 0;
  // What a violation is measured in: "edges", "" (unit-free).
  virtual std::string_view unit() const = 0;
};

}  // namespace planewright
