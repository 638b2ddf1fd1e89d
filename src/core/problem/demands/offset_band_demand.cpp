#include "core/problem/demands/offset_band_demand.h"

#include <array>

#include "core/problem/demands/band.h"
#include "core/problem/demands/linear_rows.h"

namespace planewright {

Result<Constraints> make_offset_band_demand(const DemandContext& context) {
  const auto band = band_bounds("offset-band", context.values[0], context.values[1], context.margin);
  if (!band) return tl::unexpected(band.error());
  auto rows = std::make_unique<LinearRows>("offset-band", "edges");
  for (int i = 0; i < context.complex.plane_count() && !endless(*band); ++i)
    if (context.where.panels[static_cast<size_t>(i)])
      rows->add(std::array{context.layout.h(i)}, std::array{1.0}, *band, {ElementKind::Panel, i});
  Constraints constraints;
  constraints.push_back(std::move(rows));
  return constraints;
}

}  // namespace planewright
