// The edges of a set of polygons, each once, with how many polygons use it. No OpenGL.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace planewright::render {

struct EdgeUse {
  int a, b;      // a < b
  int polygons;  // that run through it, in either direction; 1: border
};

struct EdgeList {
  std::vector<EdgeUse> edges;       // in the order in which the polygons first name them
  std::vector<int> edge_of_corner;  // per entry of Polygons::indices(): the edge from it to the next corner
};

// In linear time. An edge that a polygon has from a point to itself is listed as any other (a == b).
EdgeList list_edges(const Polygons& polygons);

}  // namespace planewright::render
