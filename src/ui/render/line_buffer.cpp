#include "ui/render/line_buffer.h"

#include <array>
#include <cstdint>

#include "ui/render/edge_list.h"

namespace planewright::render {

LineBuffer::LineBuffer(const std::vector<Vector3d>& ends) : count_(static_cast<int>(ends.size() / 2)) {
  if (empty()) return;
  std::vector<std::array<float, 6>> vertices;
  std::vector<std::uint32_t> indices;
  vertices.reserve(4 * static_cast<size_t>(count_));
  indices.reserve(6 * static_cast<size_t>(count_));
  for (int i = 0; i < count_; ++i) {
    std::array<float, 6> line;
    for (int k = 0; k < 3; ++k) {
      line[k] = static_cast<float>(ends[2 * i][k]);
      line[k + 3] = static_cast<float>(ends[2 * i + 1][k]);
    }
    vertices.insert(vertices.end(), 4, line);
    const auto first = static_cast<std::uint32_t>(4 * i);
    for (std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) indices.push_back(first + corner);
  }

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
  glDrawElements(GL_TRIANGLES, 6 * count_, GL_UNSIGNED_INT, nullptr);
  glBindVertexArray(0);
}

std::vector<Vector3d> edge_ends(const PolygonLayer& layer) {
  std::vector<Vector3d> ends;
  const EdgeList list = list_edges(layer.polygons);
  ends.reserve(2 * list.edges.size());
  for (const EdgeUse& edge : list.edges) {
    ends.emplace_back(layer.points.row(edge.a).transpose());
    ends.emplace_back(layer.points.row(edge.b).transpose());
  }
  return ends;
}

}  // namespace planewright::render
