#include "core/problem/demands/edge_demand.h"

#include <algorithm>

#include "core/problem/demands/triple_product_rows.h"

namespace planewright {
namespace {

// Edges: wanted lengths below this say nothing about a panel edge's size.
constexpr double kLeastLength = 0.05;

}  // namespace

Result<Constraints> make_edge_demand(const DemandContext& context) {
  const TangentComplex& complex = context.complex;
  auto rows = std::make_unique<TripleProductRows>("edge", "edges");
  for (size_t e = 0; e < complex.panel_edges.size(); ++e) {
    const PanelEdge& edge = complex.panel_edges[e];
    const auto [i, j] = complex.crossed_edge[e];
    if (i < 0 || !context.where.has_edge(edge)) continue;
    const Vector3d foot = complex.input.vertices.row(i);
    const Vector3d along = complex.input.vertices.row(j).transpose() - foot;
    if (!(along.norm() > 0.0)) continue;
    const double wanted =
        std::max((complex.preferred.row(edge.a) - complex.preferred.row(edge.b)).norm(), kLeastLength);
    // The outline of i's panel runs a -> b and goes counter-clockwise, so b belongs to the face left of ij.
    rows->add(context.layout.x(edge.b), context.layout.x(edge.a), foot,
              context.side / (along.norm() * wanted) * along, {context.margin, kUnbounded},
              {ElementKind::PanelEdge, static_cast<int>(e)});
  }
  Constraints constraints;
  constraints.push_back(std::move(rows));
  return constraints;
}

}  // namespace planewright
