// Panels, or the ghost's faces, on the GPU: triangles that seldom change, and positions that are streamed.
//
// Threads: the thread of the current OpenGL context, alone. Throws std::runtime_error when an upload fails
// (out of GPU memory).
#pragma once

#include <memory>

#include "ui/render/gl_objects.h"
#include "ui/render/panel_arrays.h"

namespace planewright::render {

class PanelBuffer {
 public:
  PanelBuffer() = default;  // empty: draws nothing

  // Copies memory and no more; the triangles only where the geometry is another object than before. Leaves
  // the panels without values.
  void set(const PanelArrays& panels);
  // One value per polygon or per point; both empty: plain card.
  void set_values(const Vector& polygon_values, const Vector& point_values);

  bool empty() const { return !geometry_ || geometry_->vertex_count() == 0; }
  void draw() const;  // with the program in use

 private:
  void create();

  std::shared_ptr<const PanelGeometry> geometry_;
  bool has_values_ = false;
  GlVertexArray arrays_;
  GlBuffer shapes_, places_, values_;
};

}  // namespace planewright::render
