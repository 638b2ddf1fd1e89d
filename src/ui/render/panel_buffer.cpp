#include "ui/render/panel_buffer.h"

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace planewright::render {
namespace {

enum Attribute : GLuint { kPosition, kNormal, kEdgeMask, kPanelSize, kValue };

// Gives the buffer new memory, so that the driver need not wait until the old is drawn. Leaves it bound.
template <class T>
void upload(const GlBuffer& buffer, std::span<const T> data, GLenum usage) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), usage);
}

}  // namespace

void PanelBuffer::create() {
  arrays_ = GlVertexArray::create();
  shapes_ = GlBuffer::create();
  places_ = GlBuffer::create();
  values_ = GlBuffer::create();

  glBindVertexArray(arrays_.get());
  glBindBuffer(GL_ARRAY_BUFFER, shapes_.get());
  const auto offset = [](size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  glVertexAttribIPointer(kEdgeMask, 1, GL_UNSIGNED_INT, sizeof(PanelShape),
                         offset(offsetof(PanelShape, edge_mask)));
  glVertexAttribPointer(kPanelSize, 1, GL_FLOAT, GL_FALSE, sizeof(PanelShape),
                        offset(offsetof(PanelShape, size)));
  glBindBuffer(GL_ARRAY_BUFFER, places_.get());
  glVertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, sizeof(PanelPlace), offset(0));
  glVertexAttribPointer(kNormal, 4, GL_INT_2_10_10_10_REV, GL_TRUE, sizeof(PanelPlace),
                        offset(offsetof(PanelPlace, normal)));
  glBindBuffer(GL_ARRAY_BUFFER, values_.get());
  glVertexAttribPointer(kValue, 1, GL_FLOAT, GL_FALSE, sizeof(float), offset(0));
  for (GLuint attribute : {kPosition, kNormal, kEdgeMask, kPanelSize}) glEnableVertexAttribArray(attribute);
  glBindVertexArray(0);
}

void PanelBuffer::set(const PanelArrays& panels) {
  const bool cut_alike = panels.geometry == geometry_;
  has_values_ = false;
  geometry_.reset();  // should an upload fail
  if (panels.geometry && panels.geometry->vertex_count() > 0) {
    const std::vector<PanelShape>& shapes = panels.geometry->shapes;
    assert(panels.places.size() == shapes.size());
    if (!arrays_) create();
    if (!cut_alike) upload(shapes_, std::span<const PanelShape>(shapes), GL_STATIC_DRAW);
    upload(places_, std::span<const PanelPlace>(panels.places), GL_STREAM_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    if (!cut_alike) check_gl("uploading polygons");
  }
  geometry_ = panels.geometry;
}

void PanelBuffer::set_values(const Vector& polygon_values, const Vector& point_values) {
  has_values_ = !empty() && (polygon_values.size() > 0 || point_values.size() > 0);
  if (!has_values_) return;
  std::vector<float> values(geometry_->shapes.size());
  write_values(*geometry_, polygon_values, point_values, values);
  upload(values_, std::span<const float>(values), GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void PanelBuffer::draw() const {
  if (empty()) return;
  glBindVertexArray(arrays_.get());
  if (has_values_) {
    glEnableVertexAttribArray(kValue);
  } else {
    glDisableVertexAttribArray(kValue);
    glVertexAttrib1f(kValue, kNoValue);
  }
  glDrawArrays(GL_TRIANGLES, 0, geometry_->vertex_count());
  glBindVertexArray(0);
}

}  // namespace planewright::render
