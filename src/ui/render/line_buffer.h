// Straight lines on the GPU, drawn as rectangles of constant width on the screen (core OpenGL has no wide
// lines).
//
// Threads: the thread of the current OpenGL context, alone. Throws std::runtime_error when an upload fails.
#pragma once

#include "ui/render/gl_objects.h"
#include "ui/render/panel_arrays.h"

namespace planewright::render {

class LineBuffer {
 public:
  LineBuffer() = default;  // empty: draws nothing
  explicit LineBuffer(const LineArrays& arrays);

  bool empty() const { return index_count_ == 0; }
  void draw() const;  // with the program in use

 private:
  int index_count_ = 0;
  GlVertexArray arrays_;
  GlBuffer ends_, indices_;
};

}  // namespace planewright::render
