#include "core/problem/demands/coplanar_beams_demand.h"

#include <algorithm>

#include "core/problem/demands/triple_product_rows.h"

namespace planewright {
namespace {

constexpr double kLeastDirected = 1e-3;  // edges
constexpr double kLeastWidth = 0.05;     // edges

}  // namespace

Result<Constraints> make_coplanar_beams_demand(const DemandContext& context) {
  const TangentComplex& complex = context.complex;
  if (!context.neighbour)
    return fail(ErrorCode::Usage, "the demand 'coplanar-beams' needs another layer to build beams to",
                "demands", "Name the layer that this one's edges are to be coplanar with");
  const TangentComplex& other = *context.neighbour->complex;
  if (other.point_origin != complex.point_origin || other.panels != complex.panels)
    return fail(ErrorCode::Usage, "the layer that 'coplanar-beams' refers to has other points or panels",
                "demands", "Give both layers the same mode and the same border policy");
  const Points& wanted = complex.preferred;
  const Points& there = context.neighbour->state.x;
  const auto selected = [&](int panel) {
    return panel >= 0 && context.where.panels[static_cast<size_t>(panel)];
  };
  auto rows = std::make_unique<TripleProductRows>("coplanar-beams", "edges");
  for (size_t e = 0; e < complex.panel_edges.size(); ++e) {
    const PanelEdge& edge = complex.panel_edges[e];
    if (!selected(edge.left) && !selected(edge.right)) continue;
    const Vector3d foot = there.row(edge.a);
    const Vector3d along = there.row(edge.b).transpose() - foot;
    const double length = along.norm();
    if (!(length >= kLeastDirected)) continue;
    const double width = std::max(
        0.5 * (wanted.row(edge.a) + wanted.row(edge.b) - there.row(edge.a) - there.row(edge.b)).norm(),
        kLeastWidth);
    rows->add(context.layout.x(edge.a), context.layout.x(edge.b), foot, along / (length * width), {0.0, 0.0},
              {ElementKind::PanelEdge, static_cast<int>(e)});
  }
  Constraints constraints;
  constraints.push_back(std::move(rows));
  return constraints;
}

}  // namespace planewright
