#include "cli/steering.h"

#include <utility>

#include "core/design/presets.h"

namespace planewright::cli {

Result<void> steer(const Steering& steering, LayerSettings& settings) {
  if (!steering.preset.empty()) {
    const auto preset = find_preset(steering.preset);
    auto applied = preset ? apply(**preset, settings) : Result<void>(tl::unexpected(preset.error()));
    if (!applied) {
      Error error = applied.error();
      error.where = "--preset";  // as the user gave it, not as the settings call it
      return tl::unexpected(std::move(error));
    }
  }
  for (const auto& [energy, weight] : steering.weights) settings.weights[energy] = weight;
  if (steering.no_penetration) {
    if (settings.mode != ComplexKind::Dual)
      return fail(ErrorCode::Usage, "panels that lie in the mesh's own faces cannot stay clear of it",
                  "--no-penetration", "Use it with dual");
    settings.no_penetration = true;
    for (const char* demand : {"vertex", "face", "edge"})
      set_demand(settings.demands.list, {demand, true, {}, {}});
  }
  for (const Demand& demand : steering.demands) set_demand(settings.demands.list, demand);
  if (steering.margin) settings.demands.margin = *steering.margin;
  if (steering.side) settings.side = *steering.side;
  return {};
}

}  // namespace planewright::cli
