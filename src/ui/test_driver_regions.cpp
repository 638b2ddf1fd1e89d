// What scripts do to regions: the commands of script.h whose names end in _region or _border.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "ui/test_driver.h"

namespace planewright::ui {

std::optional<ImVec2> TestDriver::find_region(const std::string& which, const DriverContext& context) {
  const AppState& state = context.state;
  if (!state.clusters() || !state.region_view() || state.region_view()->clusters != state.clusters()) {
    fail_with("there are no regions to be seen");
    return std::nullopt;
  }
  if (which != "any") {
    const int region = static_cast<int>(number(which));
    const auto at = context.viewport.clickable_place_of_region(state, region);
    if (!at) fail_with("region " + which + " cannot be clicked in this view");
    remembered_["region"] = which;
    return at;
  }
  const Regions& regions = state.clusters()->regions;
  const auto& camera = context.viewport.camera();
  std::vector<std::pair<float, int>> candidates;
  for (int r = 0; r < regions.count(); ++r) {
    const Vector3d at =
        regions.origin + regions.proxies[static_cast<std::size_t>(r)].centre - state.scene_origin();
    const glm::vec2 pixel = camera.project(at);
    candidates.emplace_back(std::hypot(pixel.x - 0.5f * static_cast<float>(camera.width()),
                                       pixel.y - 0.5f * static_cast<float>(camera.height())),
                            r);
  }
  std::sort(candidates.begin(), candidates.end());
  for (const auto& [away, region] : candidates) {
    if (const auto at = context.viewport.clickable_place_of_region(state, region)) {
      remembered_["region"] = std::to_string(region);
      return at;
    }
  }
  fail_with("no region of this view can be clicked");
  return std::nullopt;
}

std::optional<ImVec2> TestDriver::find_neighbour(const std::string& which, bool border,
                                                 const DriverContext& context) {
  const AppState& state = context.state;
  const int region = static_cast<int>(number("$region"));
  std::set<int> beside;
  if (which != "beside") {
    beside.insert(static_cast<int>(number(which)));
  } else {
    const FaceGraph& graph = *state.clusters()->graph;
    const std::vector<int>& regions = state.clusters()->regions.region_of_face;
    for (std::size_t c = 0; c < graph.beside.size(); ++c) {
      if (graph.beside[c] < 0 || regions[static_cast<std::size_t>(graph.face_of_corner[c])] != region)
        continue;
      const int other = regions[static_cast<std::size_t>(graph.beside[c])];
      if (other != region) beside.insert(other);
    }
  }
  for (const int other : beside) {
    const auto at = border ? context.viewport.clickable_place_of_border(state, region, other)
                           : context.viewport.clickable_place_of_region(state, other);
    if (!at) continue;
    remembered_["neighbour"] = std::to_string(other);
    return at;
  }
  fail_with("nothing beside region " + std::to_string(region) + " can be clicked in this view");
  return std::nullopt;
}

void TestDriver::run_on_regions(const std::vector<std::string>& words, const DriverContext& context) {
  const std::string& verb = words[0];
  const std::string which = expanded(words[1]);
  const auto at = which == "beside" ? find_neighbour(which, false, context) : find_region(which, context);
  if (!at) return;
  if (verb == "click_region") {
    click_at(*at, words.size() > 2 ? held_in(words[2]) : HeldKeys());
  } else if (verb == "hover_region") {
    push({.mouse = *at}, 3);
  } else if (const auto other = find_neighbour(expanded(words[2]), verb == "click_border", context)) {
    if (verb == "click_border") {
      click_at(*other);
    } else {
      drag_line(*at, *other);
    }
  }
}

}  // namespace planewright::ui
