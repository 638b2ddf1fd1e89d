#include "core/problem/demands/separation.h"

#include "core/problem/demands/linear_rows.h"

namespace planewright {

std::unique_ptr<Constraint> make_separation_constraint(const Layout& layout,
                                                       const std::vector<Separation>& separations,
                                                       const Vector3d& centre, double scale) {
  auto rows = std::make_unique<LinearRows>(std::string(kSeparationName), "edges");
  for (const Separation& s : separations)
    rows->add_point(layout.x(s.point), s.normal, {(s.low - s.normal.dot(centre)) / scale, kUnbounded},
                    {ElementKind::Panel, s.panel});
  return rows;
}

}  // namespace planewright
