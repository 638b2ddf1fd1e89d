// What faces bound: whether they close, and how much is inside. Internal to certify/. Threads: pure.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

// Fans from the first corner of each face that `chosen` lists. Of closed faces they bound the same volume as
// any other triangles, concave faces too.
std::vector<std::array<int, 3>> fans(const Polygons& faces, std::span<const int> chosen);

// Indices of points, equal coordinates having equal ones (-0 is 0).
std::vector<int> welded(const Points& points);

// Each directed edge of the faces once, and its reverse once; corners by `weld`. Faces that weld to fewer
// than three corners are left out.
bool is_closed(const Polygons& faces, std::span<const int> chosen, const std::vector<int>& weld);
// The same for several solids at once that may touch: as often one way as the other.
bool is_balanced(const Polygons& faces, std::span<const int> chosen, const std::vector<int>& weld);

struct SolidMeasure {
  double volume = 0.0, surface = 0.0;  // of the points' unit
};
SolidMeasure measure(const Points& points, const std::vector<std::array<int, 3>>& triangles);

// The points that these faces use, each once.
Points points_of(const Points& points, const Polygons& faces, std::span<const int> chosen);

std::vector<int> all_of(const Polygons& faces);

}  // namespace planewright
