// Edits of a layer's settings as the left panel offers them: presets, one switch per demand, one for "never
// touch the mesh", parameters that may be empty, and demands that are given up.
//
// Lengths: model units; "none" (an open end of a band) is +-kUnbounded, as in core/problem/constraint.h.
// Threads: pure functions on values.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/design/layer_settings.h"
#include "core/design/presets.h"
#include "core/problem/demands/demand_catalogue.h"

namespace planewright::ui {

// The preset that the settings are: its weights and no others, and its demands on. Null where the designer
// went on from there, or where none fits the mode. Of several, the one that demands most.
const Preset* present_preset(const LayerSettings& settings);

// Whether the demand means something for that kind of panels.
bool is_defined_for(const DemandInfo& info, ComplexKind mode);

// Where the entries of a demand are in Demands::list, ascending; one per place that it is demanded of.
std::vector<std::size_t> entries_of(const Demands& demands, const std::string& name);
// Whether any entry of that name is on.
bool is_on(const Demands& demands, const std::string& name);

// The entry's k-th parameter, or its default.
double parameter(const DemandInfo& info, const Demand& demand, std::size_t k);
void set_parameter(const DemandInfo& info, Demand& demand, std::size_t k, double value);
// What an empty field means for the k-th parameter: +-kUnbounded for the ends of a band, 0 if it may not be
// empty.
double none_of(const DemandInfo& info, std::size_t k);

// "Never touch the mesh": corners, panels and edges in front everywhere, and the test for crossings.
enum class Switch { Off, Mixed, On };
const std::vector<std::string>& never_touch_demands();
Switch never_touch(const LayerSettings& settings);
void set_never_touch(LayerSettings& settings, bool on);

// Adds to Demands::waived, each once, ascending.
void give_up(Demands& demands, const std::vector<Waiver>& conflicts);

// Switches off what means nothing in the present mode; returns how many demands that were.
int switch_off_undefined(LayerSettings& settings);

}  // namespace planewright::ui
