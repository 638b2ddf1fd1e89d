// Where a drawing has its parts: how each pattern lies on it. Internal to certify/. Units: mm. Threads: pure.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/certify/certificate.h"

namespace planewright {

struct PlacedPattern {
  const DrawingLine* line;     // on CUT, closed, of a panel
  const FlatPattern* pattern;  // null: that panel has none
  Eigen::Isometry2d motion;    // of the pattern to the drawing: never mirrored
  double difference = 0.0;     // mm, of the corner that it lays farthest off; infinite: not as many corners
};

// In the order of the drawing. Refers to both. patterns: #P, or null.
std::vector<PlacedPattern> placed_patterns(const Drawing& drawing, const std::vector<FlatPattern>* patterns);

}  // namespace planewright
