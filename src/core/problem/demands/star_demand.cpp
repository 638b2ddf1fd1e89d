#include "core/problem/demands/star_demand.h"

#include "core/problem/demands/star_rows.h"
#include "core/problem/demands/value_checks.h"

namespace planewright {

Result<Constraints> make_star_demand(const DemandContext& context) {
  const double eps = context.values[0];
  if (auto sound = check_share("star", "eps", eps); !sound) return tl::unexpected(sound.error());
  auto rows = std::make_unique<PanelTriangleRows>("star", "edges");
  for (int i = 0; i < context.complex.panels.size(); ++i)
    if (context.where.panels[static_cast<size_t>(i)] && context.complex.panels.valence(i) >= 3)
      add_star_rows(context, i, eps, *rows);
  Constraints constraints;
  constraints.push_back(std::move(rows));
  return constraints;
}

}  // namespace planewright
