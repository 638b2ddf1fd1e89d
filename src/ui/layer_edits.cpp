#include "ui/layer_edits.h"

#include <algorithm>
#include <cmath>

#include "core/problem/constraint.h"

namespace planewright::ui {

namespace {

double weight_in(const std::map<std::string, double>& weights, const std::string& name) {
  const auto found = weights.find(name);
  return found == weights.end() ? 0.0 : found->second;
}

bool same_weights(const std::map<std::string, double>& a, const std::map<std::string, double>& b) {
  const auto covers = [](const auto& some, const auto& others) {
    return std::all_of(some.begin(), some.end(),
                       [&](const auto& entry) { return weight_in(others, entry.first) == entry.second; });
  };
  return covers(a, b) && covers(b, a);
}

}  // namespace

const Preset* present_preset(const LayerSettings& settings) {
  const Preset* best = nullptr;
  for (const Preset& preset : presets()) {
    if (!preset.fits(settings.mode) || !same_weights(preset.weights, settings.weights)) continue;
    const auto is_listed = [&](const Demand& wanted) {
      const std::vector<Demand>& list = settings.demands.list;
      return std::find(list.begin(), list.end(), wanted) != list.end();
    };
    if (!std::all_of(preset.demands.begin(), preset.demands.end(), is_listed)) continue;
    if (best == nullptr || preset.demands.size() > best->demands.size()) best = &preset;
  }
  return best;
}

bool is_defined_for(const DemandInfo& info, ComplexKind mode) {
  return info.fits(mode);
}

std::vector<std::size_t> entries_of(const Demands& demands, const std::string& name) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < demands.list.size(); ++i) {
    if (demands.list[i].name == name) found.push_back(i);
  }
  return found;
}

bool is_on(const Demands& demands, const std::string& name) {
  return std::any_of(demands.list.begin(), demands.list.end(),
                     [&](const Demand& d) { return d.on && d.name == name; });
}

double parameter(const DemandInfo& info, const Demand& demand, std::size_t k) {
  return k < demand.values.size() ? demand.values[k] : info.parameters[k].default_value;
}

void set_parameter(const DemandInfo& info, Demand& demand, std::size_t k, double value) {
  for (std::size_t i = demand.values.size(); i < info.parameters.size(); ++i) {
    demand.values.push_back(info.parameters[i].default_value);
  }
  demand.values[k] = value;
}

double none_of(const DemandInfo& info, std::size_t k) {
  const DemandParameter& own = info.parameters[k];
  if (std::abs(own.default_value) >= kNoLimit) return own.default_value;
  const auto has = [&](const char* name) {
    return std::any_of(info.parameters.begin(), info.parameters.end(),
                       [&](const DemandParameter& p) { return p.name == name; });
  };
  if (!has("low") || !has("high")) return 0.0;
  return own.name == "low" ? -kUnbounded : own.name == "high" ? kUnbounded : 0.0;
}

const std::vector<std::string>& never_touch_demands() {
  static const std::vector<std::string> names = {"vertex", "face", "edge"};
  return names;
}

Switch never_touch(const LayerSettings& settings) {
  int on = settings.no_penetration ? 1 : 0;
  for (const std::string& name : never_touch_demands()) {
    for (const Demand& demand : settings.demands.list) {
      if (demand.on && demand.name == name && demand.selection.empty()) {
        ++on;
        break;
      }
    }
  }
  const int all = 1 + static_cast<int>(never_touch_demands().size());
  return on == 0 ? Switch::Off : on == all ? Switch::On : Switch::Mixed;
}

void set_never_touch(LayerSettings& settings, bool on) {
  settings.no_penetration = on;
  std::vector<Demand>& list = settings.demands.list;
  for (const std::string& name : never_touch_demands()) {
    bool everywhere = false;
    for (Demand& demand : list) {
      if (demand.name != name) continue;
      if (demand.selection.empty()) {
        demand.on = on;
        everywhere = true;
      } else if (!on) {
        demand.on = false;
      }
    }
    if (on && !everywhere) list.push_back({name, true, {}, {}});
  }
}

void give_up(Demands& demands, const std::vector<Waiver>& conflicts) {
  std::vector<Waiver>& waived = demands.waived;
  waived.insert(waived.end(), conflicts.begin(), conflicts.end());
  std::sort(waived.begin(), waived.end());
  waived.erase(std::unique(waived.begin(), waived.end()), waived.end());
}

int switch_off_undefined(LayerSettings& settings) {
  int count = 0;
  for (Demand& demand : settings.demands.list) {
    const auto info = find_demand(demand.name);
    if (!demand.on || !info || is_defined_for(**info, settings.mode)) continue;
    demand.on = false;
    ++count;
  }
  if (settings.mode != ComplexKind::Dual) settings.no_penetration = false;  // a test for layers beside a mesh
  return count;
}

}  // namespace planewright::ui
