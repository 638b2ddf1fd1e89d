// The model's soft shadow on the ground: its plan, darker where it stands lower, blurred. No OpenGL.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace planewright::render {

struct GroundShadow {
  static constexpr int kCells = 128;   // in each direction
  Vector3d low, high;                  // the rectangle on the ground, low.z == high.z
  std::vector<std::uint8_t> darkness;  // kCells x kCells, row by row from low
};

// points: #N x 3, corners: three rows of it per triangle. Nothing without extent in plan. Triangles with a
// corner that is not finite are left out.
std::optional<GroundShadow> make_ground_shadow(const Points& points, std::span<const int> corners);

}  // namespace planewright::render
