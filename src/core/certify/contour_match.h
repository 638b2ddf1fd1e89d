// Which contour of a file is which of the drawing. Internal to certify/. Units: mm. Threads: pure.
#pragma once

#include <limits>
#include <vector>

#include "core/pattern/flat_pattern.h"

namespace planewright {

struct ContourMatch {
  int read = -1;  // -1: no contour of the file has as many points
  double difference = std::numeric_limits<double>::infinity();  // of the farthest point
};

// For each wanted contour the nearest of those read, each used once. Contours have the same points in the
// same cyclic order (open: the same order), in either direction. closed: both lists are of closed contours.
std::vector<ContourMatch> match_contours(const std::vector<const Contour*>& wanted,
                                         const std::vector<const Contour*>& read, bool closed, double limit);

// The farthest that a corner of one contour is from the other's border, either way round: for formats that
// leave out corners where a line goes straight on.
double border_distance(const Contour& a, const Contour& b);

}  // namespace planewright
