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

  // As many points as the layer had. Empty values: plain card. Polygons that the new points bent so that
  // their triangles fold over are cut again, some hundred of them per call.
  void update(const Points& points, const Vector& polygon_values, const Vector& point_values);

  bool empty() const { return geometry_.vertex_count() == 0; }
  const PanelGeometry& geometry() const { return geometry_; }
  void draw() const;  // with the program in use

 private:
  void unfold(const Points& points);

  PanelGeometry geometry_;
  int point_count_ = 0;
  int unfolded_to_ = 0;  // the polygon with which the next call goes on
  bool has_values_ = false;
  GlVertexArray arrays_;
  GlBuffer shapes_, places_, values_;
};

}  // namespace planewright::render
