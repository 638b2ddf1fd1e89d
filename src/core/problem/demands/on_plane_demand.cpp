#include "core/problem/demands/on_plane_demand.h"

#include "core/problem/demands/linear_rows.h"

namespace planewright {

Result<Constraints> make_on_plane_demand(const DemandContext& context) {
  const Vector3d p(context.values[0], context.values[1], context.values[2]);
  const Vector3d given(context.values[3], context.values[4], context.values[5]);
  const Vector3d normal = given.stableNormalized();
  if (!(normal.norm() > 0.5) || p.cwiseAbs().maxCoeff() >= kNoLimit)
    return fail(ErrorCode::Usage, "the plane of the demand 'on-plane' has no place or no direction",
                "demands", "Give a point and a normal of positive length");
  auto rows = std::make_unique<LinearRows>("on-plane", "edges");
  const double distance = normal.dot(p);
  for (int j = 0; j < context.complex.point_count(); ++j)
    if (context.where.points[static_cast<size_t>(j)])
      rows->add_point(context.layout.x(j), normal, {distance, distance}, {ElementKind::Point, j});
  Constraints constraints;
  constraints.push_back(std::move(rows));
  return constraints;
}

}  // namespace planewright
