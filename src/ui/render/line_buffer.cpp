#include "ui/render/line_buffer.h"

namespace planewright::render {

LineBuffer::LineBuffer(const LineArrays& arrays) : index_count_(static_cast<int>(arrays.indices.size())) {
  if (empty()) return;
  const auto& vertices = arrays.vertices;
  const auto& indices = arrays.indices;
  arrays_ = GlVertexArray::create();
  ends_ = GlBuffer::create();
  indices_ = GlBuffer::create();
  glBindVertexArray(arrays_.get());
  glBindBuffer(GL_ARRAY_BUFFER, ends_.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sizeof(vertices[0]) * vertices.size()),
               vertices.data(), GL_STATIC_DRAW);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(vertices[0]), nullptr);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(vertices[0]),
                        reinterpret_cast<const void*>(3 * sizeof(float)));
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(sizeof(indices[0]) * indices.size()),
               indices.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  check_gl("uploading lines");
}

void LineBuffer::draw() const {
  if (empty()) return;
  glBindVertexArray(arrays_.get());
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
  glBindVertexArray(0);
}

}  // namespace planewright::render
