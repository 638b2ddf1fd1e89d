#include "cli/steering.h"

#include <algorithm>
#include <utility>

#include "core/design/presets.h"

namespace planewright::cli {
namespace {

// Only what was there before gives way. The same twice is one.
void add_demands(const std::vector<Demand>& added, std::vector<Demand>& list) {
  std::erase_if(list, [&](const Demand& there) {
    return std::any_of(added.begin(), added.end(), [&](const Demand& demand) {
      return demand.name == there.name && demand.selection == there.selection;
    });
  });
  for (const Demand& demand : added)
    if (std::find(list.begin(), list.end(), demand) == list.end()) list.push_back(demand);
}

}  // namespace

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
  if (steering.no_penetration.value_or(false)) {
    if (settings.mode != ComplexKind::Dual)
      return fail(ErrorCode::Usage, "panels that lie in the mesh's own faces cannot stay clear of it",
                  "--no-penetration", "Use it with dual");
    settings.no_penetration = true;
    for (const char* demand : {"vertex", "face", "edge"})
      set_demand(settings.demands.list, {demand, true, {}, {}});
  }
  add_demands(steering.demands, settings.demands.list);
  if (steering.margin) settings.demands.margin = *steering.margin;
  if (steering.side) settings.side = *steering.side;
  return {};
}

}  // namespace planewright::cli
