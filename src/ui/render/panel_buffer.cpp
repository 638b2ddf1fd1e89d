#include "ui/render/panel_buffer.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace planewright::render {
namespace {

enum Attribute : GLuint { kPosition, kNormal, kEdgeMask, kPanelSize, kValue };

// Gives the buffer new memory, so that the driver need not wait until the old is drawn, and lets `write` fill
// it.
template <class T, class Write>
void refill(const GlBuffer& buffer, int count, Write write) {
  const GLsizeiptr bytes = static_cast<GLsizeiptr>(sizeof(T)) * count;
  glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
  // Memory can be lost while it is mapped (a display that sleeps); then it is filled again.
  for (int attempt = 0; attempt < 3; ++attempt) {
    glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
    void* memory =
        glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    if (memory == nullptr) break;
    write(std::span<T>(static_cast<T*>(memory), static_cast<size_t>(count)));
    if (glUnmapBuffer(GL_ARRAY_BUFFER) == GL_TRUE) break;
  }
}

}  // namespace

PanelBuffer::PanelBuffer(const PolygonLayer& layer)
    : geometry_(make_panel_geometry(layer.points, layer.polygons)),
      point_count_(static_cast<int>(layer.points.rows())) {
  if (empty()) return;
  arrays_ = GlVertexArray::create();
  shapes_ = GlBuffer::create();
  places_ = GlBuffer::create();
  values_ = GlBuffer::create();

  glBindVertexArray(arrays_.get());
  glBindBuffer(GL_ARRAY_BUFFER, shapes_.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sizeof(PanelShape) * geometry_.shapes.size()),
               geometry_.shapes.data(), GL_DYNAMIC_DRAW);
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

  update(layer.points, layer.polygon_values, layer.point_values);
  check_gl("uploading polygons");
}

void PanelBuffer::update(const Points& points, const Vector& polygon_values, const Vector& point_values) {
  assert(points.rows() == point_count_);
  if (empty() || points.rows() != point_count_) return;
  unfold(points);
  refill<PanelPlace>(places_, geometry_.vertex_count(),
                     [&](std::span<PanelPlace> out) { write_places(geometry_, points, out); });
  has_values_ = polygon_values.size() > 0 || point_values.size() > 0;
  if (has_values_) {
    refill<float>(values_, geometry_.vertex_count(),
                  [&](std::span<float> out) { write_values(geometry_, polygon_values, point_values, out); });
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

// A panel that crosses itself stays folded however it is cut; so that many of them cannot hold up the stream,
// each call looks at a limited number and the next goes on from there.
void PanelBuffer::unfold(const Points& points) {
  constexpr size_t kMost = 500;
  std::vector<int> folded = find_folded(geometry_, points);
  if (folded.empty()) return;
  if (folded.size() > kMost) {
    const auto next = std::lower_bound(folded.begin(), folded.end(), unfolded_to_);
    std::rotate(folded.begin(), next, folded.end());
    unfolded_to_ = folded[kMost];
    folded.resize(kMost);
  }
  glBindBuffer(GL_ARRAY_BUFFER, shapes_.get());
  for (int p : folded) {
    if (!cut_again(geometry_, points, p)) continue;
    const int from = 3 * geometry_.first_triangle[p], to = 3 * geometry_.first_triangle[p + 1];
    glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(sizeof(PanelShape)) * from,
                    static_cast<GLsizeiptr>(sizeof(PanelShape)) * (to - from),
                    geometry_.shapes.data() + from);
  }
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
  glDrawArrays(GL_TRIANGLES, 0, geometry_.vertex_count());
  glBindVertexArray(0);
}

}  // namespace planewright::render
