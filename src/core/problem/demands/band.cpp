#include "core/problem/demands/band.h"

#include <algorithm>

namespace planewright {

Result<Bounds> band_bounds(const std::string& demand, double low, double high, double margin) {
  if (low > high || low >= kNoLimit || high <= -kNoLimit)
    return fail(ErrorCode::Infeasible,
                "the demand '" + demand + "' is an empty band: its low end lies above its high one",
                "demands", "Exchange the two ends, or leave one out");
  if (low == high) return Bounds{low, high};
  const bool has_low = low > -kNoLimit, has_high = high < kNoLimit;
  if (has_low && has_high) margin = std::min(margin, 0.25 * (high - low));
  return Bounds{has_low ? low + margin : -kUnbounded, has_high ? high - margin : kUnbounded};
}

bool endless(const Bounds& bounds) {
  return bounds.low <= -kNoLimit && bounds.high >= kNoLimit;
}

}  // namespace planewright
