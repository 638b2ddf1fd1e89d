// Straight lines on the GPU, drawn as rectangles of constant width on the screen (core OpenGL has no wide
// lines).
//
// Threads: the thread of the current OpenGL context, alone. Throws std::runtime_error when an upload fails.
#pragma once

#include <vector>

#include "ui/render/gl_objects.h"
#include "ui/render/scene.h"

namespace planewright::render {

class LineBuffer {
 public:
  LineBuffer() = default;  // empty: draws nothing
  // Pairs of ends, one after the other.
  explicit LineBuffer(const std::vector<Vector3d>& ends);

  bool empty() const { return count_ == 0; }
  void draw() const;  // with the program in use

 private:
  int count_ = 0;
  GlVertexArray arrays_;
  GlBuffer ends_, indices_;
};

// Both ends of each edge of the layer's polygons, each edge once.
std::vector<Vector3d> edge_ends(const PolygonLayer& layer);

}  // namespace planewright::render
