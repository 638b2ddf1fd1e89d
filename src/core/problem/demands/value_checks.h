// Checks of what a designer gives a demand.
#pragma once

#include <string>

#include "core/base/result.h"

namespace planewright {

// Fails with ErrorCode::Usage unless 0 <= value <= 1.
inline Result<void> check_share(const std::string& demand, const std::string& parameter, double value) {
  if (value >= 0.0 && value <= 1.0) return {};
  return fail(ErrorCode::Usage, "'" + parameter + "' of the demand '" + demand + "' is not from 0 to 1",
              "demands", "Give a share from 0 to 1");
}

}  // namespace planewright
