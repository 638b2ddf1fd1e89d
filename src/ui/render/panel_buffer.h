// A polygon layer on the GPU: fixed triangles, and positions that are streamed.
//
// Threads: the thread of the current OpenGL context, alone. Throws std::runtime_error when an upload fails
// (out of GPU memory).
#pragma once

#include "ui/render/gl_objects.h"
#include "ui/render/panel_geometry.h"

namespace planewright::render {

class PanelBuffer {
 public:
  PanelBuffer() = default;  // empty: draws nothing
  explicit PanelBuffer(const PolygonLayer& layer);

  // As many points as the layer had. Empty values: plain card.
  void update(const Points& points, const Vector& polygon_values, const Vector& point_values);

  bool empty() const { return geometry_.vertex_count() == 0; }
  const PanelGeometry& geometry() const { return geometry_; }  // its shapes live on the GPU only
  void draw() const;                                           // with the program in use

 private:
  PanelGeometry geometry_;
  int point_count_ = 0;
  bool has_values_ = false;
  GlVertexArray arrays_;
  GlBuffer shapes_, places_, values_;
};

}  // namespace planewright::render
