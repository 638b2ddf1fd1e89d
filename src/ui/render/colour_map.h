// The colour maps: viridis, perceptually even and readable by the colour-blind, with a hard break at a
// tolerance; one for severities, in the amber and red of the marks; and one for verdicts, in cool colours
// what keeps a limit, in amber and red what does not.
//
// The shader panel.frag does the same as `map_position` and looks the colour up in the same table. No OpenGL.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "ui/render/scene.h"

namespace planewright::render {

// viridis at t in 0..1 (clamped; not a number gives 0), display RGB in 0..1. Luminance rises with t.
glm::vec3 viridis(float t);

// Pale at 0, amber in the middle, red at 1; t as above. Darker as t rises.
glm::vec3 severity_colour(float t);

// At t as map_position() gives it where there is a tolerance: from pale to deep teal below the break, from
// amber to red above it.
glm::vec3 verdict_colour(float t);

// 256 x RGBA, 8 bits, for a texture: entry i is viridis(i / 255), or what the other maps make of it.
using ColourTable = std::array<std::uint8_t, 256 * 4>;
ColourTable viridis_table();
ColourTable severity_table();
ColourTable verdict_table();

// How values turn into places 0..1 on the map. Without a tolerance: evenly from low to high. With one: what
// keeps the tolerance takes the dark part up to kBreakBelow, what misses it the bright part from kBreakAbove,
// so that the limit shows as an edge.
inline constexpr float kBreakBelow = 0.52f, kBreakAbove = 0.80f;
struct MapScale {
  float low = 0.0f, tolerance = 0.0f;
  float per_unit_below = 0.0f, per_unit_above = 0.0f;  // map positions per value on either side of the break
  float below_end = 1.0f, above_start = 1.0f;
};
MapScale map_scale(const ColourScale& scale);
float map_position(const MapScale& scale, float value);

// The colour of a value, without light.
glm::vec3 colour_of(const ColourScale& scale, double value);

}  // namespace planewright::render
