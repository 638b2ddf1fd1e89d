// ReadMesh: what a reader found in a file of polygons, before anybody knows what should be in it. Internal to
// certify/. Threads: plain data.
#pragma once

#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

struct ReadMesh {
  Points points;  // as the file has them
  Polygons faces;
  std::vector<int> object_of_face;   // #faces, -1: of none
  std::vector<std::string> objects;  // names; empty where the format knows none
  bool single_precision = false;     // coordinates were read as float
  std::string unit;                  // as the file says it; empty: not
};

}  // namespace planewright
