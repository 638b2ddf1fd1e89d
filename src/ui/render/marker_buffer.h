// Marks as discs on the GPU, as large on the screen whatever the distance; small where panels are small.
//
// Their colours hang on the theme, so the buffer is filled when the theme changes. Threads: the thread of the
// current OpenGL context, alone. Throws std::runtime_error when an upload fails.
#pragma once

#include <vector>

#include "ui/render/gl_objects.h"
#include "ui/render/palette.h"
#include "ui/render/scene.h"

namespace planewright::render {

class MarkerBuffer {
 public:
  void set(const std::vector<Marker>& markers);
  void draw(const Palette& palette);  // with the program in use
  bool empty() const { return markers_.empty(); }

 private:
  void fill(const Palette& palette);

  std::vector<Marker> markers_;
  const Palette* filled_for_ = nullptr;
  GlVertexArray arrays_;
  GlBuffer buffer_;
};

}  // namespace planewright::render
