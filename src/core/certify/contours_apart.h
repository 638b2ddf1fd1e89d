// Whether two parts on a sheet leave each other alone. Of its own: no code of the nesting. Internal to
// certify/. Units: mm. Threads: pure.
#pragma once

#include "core/pattern/flat_pattern.h"

namespace planewright {

enum class Apart { Yes, TooNear, Overlap };

// Contours are simple; they may touch where spacing is 0. With a spacing, whether they meet is decided
// exactly, and their distance may be below it by `tolerance`; without, one may reach into the other by that.
Apart apart(const Contour& a, const Contour& b, double spacing, double tolerance);

}  // namespace planewright
