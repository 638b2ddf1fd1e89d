// value_of: for benchmarks, whose inputs are their own: an Error is the end of the measurement.
#pragma once

#include <stdexcept>
#include <utility>

#include "core/base/result.h"

namespace planewright::bench {

// Throws std::runtime_error with the error's text.
template <class T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().text());
  return std::move(*result);
}

}  // namespace planewright::bench
