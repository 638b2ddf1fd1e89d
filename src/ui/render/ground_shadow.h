// The model's soft shadow on the ground: its plan, darker where it stands lower, blurred. No OpenGL.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ui/render/scene.h"

namespace planewright::render {

struct GroundShadow {
  static constexpr int kCells = 128;   // in each direction
  Vector3d low, high;                  // the rectangle on the ground, low.z == high.z
  std::vector<std::uint8_t> darkness;  // kCells x kCells, row by row from low
};

// Nothing for a layer without extent in plan (or with no finite polygon).
std::optional<GroundShadow> make_ground_shadow(const PolygonLayer& layer);

}  // namespace planewright::render
