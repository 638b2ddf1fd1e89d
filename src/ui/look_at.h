// LookAt: a wish to the viewport's camera. Threads: a plain value. Units: scene coordinates.
#pragma once

#include "core/base/geometry.h"

namespace planewright::ui {

struct LookAt {
  Vector3d point;  // scene coordinates
  double radius;   // of what should fill the view
};

}  // namespace planewright::ui
