#include "core/problem/demands/vertex_demand.h"

#include <algorithm>

#include "core/problem/demands/linear_rows.h"

namespace planewright {

Result<Constraints> make_vertex_demand(const DemandContext& context) {
  const TangentComplex& complex = context.complex;
  auto rows = std::make_unique<LinearRows>("vertex", "edges");
  for (int j = 0; j < complex.point_count(); ++j) {
    const int face = complex.face_of_point[static_cast<size_t>(j)];
    if (face < 0 || !context.where.points[static_cast<size_t>(j)]) continue;
    const Vector3d out = context.side * complex.input.face_normals.row(face).transpose();
    double farthest = -kUnbounded;
    for (int v : complex.input.faces[face])
      farthest = std::max(farthest, out.dot(complex.input.vertices.row(v)));
    rows->add_point(context.layout.x(j), out, {farthest + context.margin, kUnbounded},
                    {ElementKind::Point, j});
  }
  Constraints constraints;
  constraints.push_back(std::move(rows));
  return constraints;
}

}  // namespace planewright
