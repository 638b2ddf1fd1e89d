// Camera: an orbiting perspective camera with z up, as in CAD. No window, no OpenGL.
//
// Units: scene units; pixels with (0, 0) at the top left. Threads: a plain value.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/geometry.h"

namespace planewright::render {

struct Ray {
  Vector3d origin, direction;  // direction is unit
};

class Camera {
 public:
  void set_viewport(int width, int height);  // pixels, > 0
  // Looks at the whole box from the present direction, with a little air round it.
  void fit(const Vector3d& low, const Vector3d& high);
  // The standard three-quarter view from above, front-left.
  void reset_direction();

  // Orbits by a mouse move (pixels) round `pivot`, which keeps its place on the screen.
  void orbit(glm::vec2 pixels, const Vector3d& pivot);
  // Pans so that `anchor` follows the mouse.
  void pan(glm::vec2 pixels, const Vector3d& anchor);
  // Zooms by a factor (> 1: closer), keeping what is under `pixel` there.
  void zoom(double factor, glm::vec2 pixel);

  glm::mat4 view() const;
  glm::mat4 projection() const;  // near and far fitted to the box of the last fit()
  Ray ray(glm::vec2 pixel) const;
  glm::vec2 project(const Vector3d& point) const;  // to pixels
  double pixel_size_at(const Vector3d& point) const;  // scene units that one pixel covers there

  Vector3d eye() const;
  Vector3d target() const { return target_; }

 private:
  Vector3d target_ = Vector3d::Zero();
  double distance_ = 10.0;
  double azimuth_ = -0.9, elevation_ = 0.6;  // radians
  double field_of_view_ = 0.6;               // vertical, radians
  double scene_radius_ = 1.0;
  Vector3d scene_centre_ = Vector3d::Zero();
  int width_ = 1, height_ = 1;
};

}  // namespace planewright::render
