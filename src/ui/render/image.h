// An RGBA picture in memory, and the little drawing that legends need. No OpenGL.
//
// Units: pixels, (0, 0) top left. Threads: a plain value.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace planewright::render {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // height x width x 4, rows from the top

  // Mixes a colour (display RGB, 0..1) into a pixel; outside the picture: nothing.
  void blend(int x, int y, const glm::vec3& colour, float alpha);
  // An axis-parallel rectangle with corners rounded by `radius`, its rim smooth.
  void fill_rectangle(float x, float y, float width_of, float height_of, const glm::vec3& colour, float alpha,
                      float radius = 0.0f);
};

}  // namespace planewright::render
