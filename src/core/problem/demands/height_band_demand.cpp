#include "core/problem/demands/height_band_demand.h"

#include "core/problem/demands/band.h"
#include "core/problem/demands/linear_rows.h"

namespace planewright {

Result<Constraints> make_height_band_demand(const DemandContext& context) {
  const auto band = band_bounds("height-band", context.values[0], context.values[1], context.margin);
  if (!band) return tl::unexpected(band.error());
  const InputSurface& input = context.complex.input;
  auto rows = std::make_unique<LinearRows>("height-band", "edges");
  for (int j = 0; j < context.complex.point_count() && !endless(*band); ++j) {
    if (!context.where.points[static_cast<size_t>(j)]) continue;
    const int face = context.complex.face_of_point[static_cast<size_t>(j)];
    const int vertex = context.complex.point_origin[static_cast<size_t>(j)].element;  // used without a face
    const Vector3d up = face >= 0 ? input.face_normals.row(face) : input.vertex_normals.row(vertex);
    const Vector3d foot =
        face >= 0 ? centroid(input.vertices, input.faces[face]) : input.vertices.row(vertex).transpose();
    const double ground = up.dot(foot);  // an end that is missing stays so
    rows->add_point(context.layout.x(j), up,
                    {band->low > -kNoLimit ? band->low + ground : -kUnbounded,
                     band->high < kNoLimit ? band->high + ground : kUnbounded},
                    {ElementKind::Point, j});
  }
  Constraints constraints;
  constraints.push_back(std::move(rows));
  return constraints;
}

}  // namespace planewright
