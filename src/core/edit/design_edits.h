// Edits of a Design as a whole: layers and named selections, with everything that refers to them kept true.
// Each takes a design and gives the changed one, which Document::change_design makes a step of undo.
//
// Units: model units. Indices 0-based. Threads: pure.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/design/layer_settings.h"

namespace planewright {

// Offset of a new layer where the first has none, mean edges.
inline constexpr double kNewLayerOffset = 0.3;

// A layer like the first, on the other side of the design. To a single layer without offset both sides are
// given kNewLayerOffset; the two are then named "outer" and "inner". Later ones lie beyond the farthest layer
// of the active one's side. Pins stay with the layer that has them. mean_edge: model units. The new layer is
// the last one.
Design with_layer_added(Design design, int active, double mean_edge);
// A copy of a layer at the end, named "... copy".
Design with_layer_duplicated(Design design, int layer);
// Precondition: more than one layer. Layers that were to be coplanar with it are free.
Design with_layer_removed(Design design, int layer);

// Replaces the selection of the same name, or adds it.
Design with_selection_stored(Design design, Selection selection);
// Demands follow. Refused: an empty name, or one that is taken.
Result<Design> with_selection_renamed(Design design, const std::string& from, const std::string& to);
// Demands on it go too: without their selection they would hold for the whole model.
Design with_selection_removed(Design design, const std::string& name);
int demands_on(const Design& design, const std::string& selection);
// "selection 3": not taken yet.
std::string free_selection_name(const Design& design);

// Holds a point; replaces the pin that the point has.
void set_pin(Demands& demands, const Pin& pin);
void set_plane_pin(Demands& demands, const PlanePin& pin);

}  // namespace planewright
