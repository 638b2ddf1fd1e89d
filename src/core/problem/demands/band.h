// Bands: a low and a high end of one number, either of them missing. Internal to demands/.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/problem/constraint.h"

namespace planewright {

// The bounds that keep `margin` to both ends; less in a band so narrow that its middle half would be lost.
// low
// == high: an equation without margin. Fails with ErrorCode::Infeasible for low > high.
Result<Bounds> band_bounds(const std::string& demand, double low, double high, double margin);

// Whether there is neither end.
bool endless(const Bounds& bounds);

}  // namespace planewright
