// A panel's outline in its own plane. Internal to certify/. Units: mm. Threads: pure.
#pragma once

#include "core/pattern/flat_pattern.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

// The corners in their order, relative to the first, in some right-handed frame of the panel's plane: those
// of a panel that runs counter-clockwise about its normal run counter-clockwise.
Contour outline_in_plane(const WorkshopModel& model, int panel);

}  // namespace planewright
