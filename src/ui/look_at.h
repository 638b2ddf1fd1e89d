// LookAt: a wish to the viewport's camera. Threads: a plain value. Units: scene coordinates.
#pragma once

#include "core/base/geometry.h"

namespace planewright::ui {

struct LookAt {
  Vector3d point;  // scene coordinates
  double radius;   // of what should fill the view
  // The outside of what is looked at, unit: the camera turns to where it can be seen face on, if it would see
  // it at a slant. 0: any side will do.
  Vector3d outside = Vector3d::Zero();
};

}  // namespace planewright::ui
