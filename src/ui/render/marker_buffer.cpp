#include "ui/render/marker_buffer.h"

#include <cstddef>

namespace planewright::render {
namespace {

constexpr float kMarkerRadius[] = {2.9f, 3.3f, 4.6f, 3.4f};  // by Marker::Kind, pixels
constexpr float kLeastRadius[] = {1.1f, 1.3f, 4.6f, 2.6f};   // where panels are small on the screen

struct MarkerVertex {
  float x, y, z;
  float r, g, b;
  float radius, least;
};

}  // namespace

void MarkerBuffer::set(const std::vector<Marker>& markers) {
  markers_ = markers;
  filled_for_ = nullptr;
}

void MarkerBuffer::draw(const Palette& palette) {
  if (markers_.empty()) return;
  if (filled_for_ != &palette) fill(palette);
  glBindVertexArray(arrays_.get());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(markers_.size()));
  glBindVertexArray(0);
}

void MarkerBuffer::fill(const Palette& palette) {
  std::vector<MarkerVertex> vertices;
  vertices.reserve(markers_.size());
  for (const Marker& marker : markers_) {
    const glm::vec3& c = marker.kind == Marker::Kind::Warning ? palette.warning
                         : marker.kind == Marker::Kind::Error ? palette.error
                                                              : palette.selected;
    const auto& p = marker.position;
    vertices.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()), c.x,
                        c.y, c.z, kMarkerRadius[static_cast<int>(marker.kind)],
                        kLeastRadius[static_cast<int>(marker.kind)]});
  }
  if (!arrays_) {
    arrays_ = GlVertexArray::create();
    buffer_ = GlBuffer::create();
  }
  glBindVertexArray(arrays_.get());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sizeof(MarkerVertex) * vertices.size()),
               vertices.data(), GL_DYNAMIC_DRAW);
  const size_t offsets[] = {offsetof(MarkerVertex, x), offsetof(MarkerVertex, r),
                            offsetof(MarkerVertex, radius)};
  const GLint sizes[] = {3, 3, 2};
  for (GLuint i = 0; i < 3; ++i) {
    glVertexAttribPointer(i, sizes[i], GL_FLOAT, GL_FALSE, sizeof(MarkerVertex),
                          reinterpret_cast<const void*>(offsets[i]));
    glVertexAttribDivisor(i, 1);
    glEnableVertexAttribArray(i);
  }
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  check_gl("uploading markers");
  filled_for_ = &palette;
}

}  // namespace planewright::render
