#include "core/problem/demands/face_demand.h"

#include <array>

#include "core/problem/demands/linear_rows.h"

namespace planewright {

Result<Constraints> make_face_demand(const DemandContext& context) {
  auto rows = std::make_unique<LinearRows>("face", "edges");
  for (int i = 0; i < context.complex.plane_count(); ++i)
    if (context.where.panels[static_cast<size_t>(i)])
      rows->add(std::array{context.layout.h(i)}, std::array{context.side}, {context.margin, kUnbounded},
                {ElementKind::Panel, i});
  Constraints constraints;
  constraints.push_back(std::move(rows));
  return constraints;
}

}  // namespace planewright
