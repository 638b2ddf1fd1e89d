// The colours of the drawing: a warm-grey ground, off-white card, and colour only where it means something.
// The window takes its marks' colours from here too. Display RGB in 0..1. No OpenGL.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "ui/render/renderer.h"

namespace planewright::render {

struct Palette {
  glm::vec3 ground_top, ground_bottom;
  glm::vec3 shadow;  // of the model on the ground
  float shadow_strength;
  glm::vec3 card;       // a panel in full light
  glm::vec3 back_tint;  // multiplies a panel's back side
  glm::vec3 edge;
  glm::vec3 other_card, back_card, beam, beam_edge;   // layers that are not worked on, and what joins layers
  glm::vec3 second_card, second_edge, crossing_card;  // a second surface, and panels that cross it
  glm::vec3 ghost;
  std::array<glm::vec3, kRegionColours> regions;  // of a clustered mesh, in full light; each beside each
  glm::vec3 warning, error, selected, outline;
  glm::vec3 text, faint_text;
};
const Palette& palette_of(const Theme& theme);

}  // namespace planewright::render
