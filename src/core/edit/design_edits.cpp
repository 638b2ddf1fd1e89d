#include "core/edit/design_edits.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace planewright {
namespace {

bool taken(const Design& design, const std::string& layer) {
  return std::any_of(design.layers.begin(), design.layers.end(),
                     [&](const Layer& l) { return l.name == layer; });
}

std::string free_layer_name(const Design& design, const std::string& stem) {
  if (!taken(design, stem)) return stem;
  int number = 2;
  while (taken(design, stem + " " + std::to_string(number))) ++number;
  return stem + " " + std::to_string(number);
}

// Of what holds at another layer's place alone.
void make_free(Layer& layer) {
  layer.coplanar_with = -1;
  layer.settings.demands.pins.clear();
  layer.settings.demands.plane_pins.clear();
  layer.settings.demands.waived.clear();
}

Selection* find_selection(Design& design, const std::string& name) {
  const auto found = std::find_if(design.selections.begin(), design.selections.end(),
                                  [&](const Selection& s) { return s.name == name; });
  return found == design.selections.end() ? nullptr : &*found;
}

}  // namespace

Design with_layer_added(Design design, int active, double mean_edge) {
  const double step = kNewLayerOffset * mean_edge;
  if (design.layers.size() == 1) {
    Layer& first = design.layers.front();
    if (first.settings.offset == 0.0) first.settings.offset = step;
    const bool outside = first.settings.offset > 0.0;
    if (first.name == Layer{}.name) first.name = outside ? "outer" : "inner";
    Layer second = first;
    second.settings.offset = -first.settings.offset;
    make_free(second);
    second.name = free_layer_name(design, outside ? "inner" : "outer");
    design.layers.push_back(std::move(second));
    return design;
  }
  Layer next = design.layers[static_cast<std::size_t>(active)];
  const double sign = next.settings.offset < 0.0 ? -1.0 : 1.0;
  double farthest = 0.0;
  for (const Layer& layer : design.layers) farthest = std::max(farthest, sign * layer.settings.offset);
  next.settings.offset = sign * (farthest + step);
  make_free(next);
  next.name = free_layer_name(design, sign > 0.0 ? "outer" : "inner");
  design.layers.push_back(std::move(next));
  return design;
}

Design with_layer_duplicated(Design design, int layer) {
  Layer copy = design.layers[static_cast<std::size_t>(layer)];
  copy.name = free_layer_name(design, copy.name + " copy");
  design.layers.push_back(std::move(copy));
  return design;
}

Design with_layer_removed(Design design, int layer) {
  assert(design.layers.size() > 1);
  design.layers.erase(design.layers.begin() + layer);
  for (Layer& rest : design.layers) {
    if (rest.coplanar_with == layer) {
      rest.coplanar_with = -1;
    } else if (rest.coplanar_with > layer) {
      --rest.coplanar_with;
    }
  }
  return design;
}

Design with_selection_stored(Design design, Selection selection) {
  if (Selection* known = find_selection(design, selection.name)) {
    *known = std::move(selection);
  } else {
    design.selections.push_back(std::move(selection));
  }
  return design;
}

Result<Design> with_selection_renamed(Design design, const std::string& from, const std::string& to) {
  if (to.empty()) return fail(ErrorCode::Refused, "a selection needs a name", from);
  Selection* selection = find_selection(design, from);
  if (selection == nullptr) return fail(ErrorCode::Refused, "there is no such selection", from);
  if (from == to) return design;
  if (find_selection(design, to) != nullptr) {
    return fail(ErrorCode::Refused, "another selection has that name", to, "Take another name.");
  }
  selection->name = to;
  for (Layer& layer : design.layers) {
    for (Demand& demand : layer.settings.demands.list) {
      if (demand.selection == from) demand.selection = to;
    }
  }
  return design;
}

Design with_selection_removed(Design design, const std::string& name) {
  std::erase_if(design.selections, [&](const Selection& s) { return s.name == name; });
  for (Layer& layer : design.layers) {
    std::erase_if(layer.settings.demands.list, [&](const Demand& d) { return d.selection == name; });
  }
  return design;
}

int demands_on(const Design& design, const std::string& selection) {
  std::ptrdiff_t count = 0;
  for (const Layer& layer : design.layers) {
    const auto& list = layer.settings.demands.list;
    count +=
        std::count_if(list.begin(), list.end(), [&](const Demand& d) { return d.selection == selection; });
  }
  return static_cast<int>(count);
}

std::string free_selection_name(const Design& design) {
  for (int number = 1;; ++number) {
    const std::string name = "selection " + std::to_string(number);
    const bool known = std::any_of(design.selections.begin(), design.selections.end(),
                                   [&](const Selection& s) { return s.name == name; });
    if (!known) return name;
  }
}

void set_pin(Demands& demands, const Pin& pin) {
  const auto held = std::find_if(demands.pins.begin(), demands.pins.end(),
                                 [&](const Pin& p) { return p.point == pin.point; });
  if (held == demands.pins.end()) {
    demands.pins.push_back(pin);
  } else {
    *held = pin;
  }
}

void set_plane_pin(Demands& demands, const PlanePin& pin) {
  const auto held = std::find_if(demands.plane_pins.begin(), demands.plane_pins.end(),
                                 [&](const PlanePin& p) { return p.panel_origin == pin.panel_origin; });
  if (held == demands.plane_pins.end()) {
    demands.plane_pins.push_back(pin);
  } else {
    *held = pin;
  }
}

}  // namespace planewright
