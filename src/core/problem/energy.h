// Energy: E_k = w_k (X / N_k) sum of squared residuals ([Z] section 2 and 4; weighting: ours, so that weight
// 1 means the same on every model and at every resolution). X: points of the complex, N_k: terms of the
// energy.
#pragma once

#include <string_view>

#include "core/problem/row_family.h"

namespace planewright {

class Energy : public RowFamily {
 public:
  virtual std::string_view name() const = 0;
  // N_k: one term may have several residual rows (the three coordinates of one distance are one term).
  virtual int terms() const = 0;
};

}  // namespace planewright
