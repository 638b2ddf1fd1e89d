#include "core/problem/demands/convex_demand.h"

#include <algorithm>

#include "core/problem/demands/panel_triangle_rows.h"
#include "core/problem/demands/value_checks.h"

namespace planewright {
namespace {

// Edges: wanted lengths below this say nothing about a panel's size.
constexpr double kLeastLength = 0.05;

}  // namespace

Result<Constraints> make_convex_demand(const DemandContext& context) {
  const TangentComplex& complex = context.complex;
  const double eps = context.values[0];
  if (auto sound = check_share("convex", "eps", eps); !sound) return tl::unexpected(sound.error());
  const auto length = [&complex](int a, int b) {
    return std::max((complex.preferred.row(b) - complex.preferred.row(a)).norm(), kLeastLength);
  };
  auto rows = std::make_unique<PanelTriangleRows>("convex", "");
  for (int i = 0; i < complex.panels.size(); ++i) {
    const auto corners = complex.panels[i];
    const size_t count = corners.size();
    if (count < 3 || !context.where.panels[static_cast<size_t>(i)]) continue;
    const auto product = [&](size_t b) {
      return length(corners[(b + count - 1) % count], corners[b]) *
             length(corners[b], corners[(b + 1) % count]);
    };
    size_t strictest = 0;
    for (size_t b = 1; b < count; ++b)
      if (product(b) > product(strictest)) strictest = b;
    for (size_t b = 0; b < count; ++b) {
      if (count == 3 && b != strictest) continue;
      // (x_b - x_a) x (x_c - x_b) = (x_c - x_b) x (x_a - x_b)
      rows->add(context.layout, i, corners[(b + 1) % count], corners[(b + count - 1) % count], {{corners[b]}},
                1.0 / product(b), {eps, kUnbounded}, {ElementKind::Panel, i});
    }
  }
  Constraints constraints;
  constraints.push_back(std::move(rows));
  return constraints;
}

}  // namespace planewright
