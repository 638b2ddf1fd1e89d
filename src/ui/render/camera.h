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
  Camera() { reset_direction(); }
  void set_viewport(int width, int height);  // pixels, > 0
  // Looks at the whole box from the present direction, with a little air round it. Nothing changes when the
  // box is empty or not finite.
  void fit(const Vector3d& low, const Vector3d& high);
  // The same for points (#N x 3), which is tighter than their box. Rows that are not finite are left out.
  void fit(const Points& points);
  // The standard three-quarter view from above, front-left (the front looks along +y).
  void reset_direction();
  // Looks from a direction given as azimuth (radians from +x round z) and elevation (radians above the
  // ground).
  void set_direction(double azimuth, double elevation);

  // Orbits by a mouse move (pixels) round `pivot`, which keeps its place on the screen.
  void orbit(glm::vec2 pixels, const Vector3d& pivot);
  // Pans so that `anchor` follows the mouse.
  void pan(glm::vec2 pixels, const Vector3d& anchor);
  // Zooms by a factor (> 1: closer), keeping what is under `pixel` there.
  void zoom(double factor, glm::vec2 pixel);
  // Zooms towards a point, which keeps its place on the screen and may be approached without end.
  void zoom(double factor, const Vector3d& anchor);

  // The way from one camera to another of the same scene and picture, t in 0..1; the nearer way round.
  static Camera between(const Camera& from, const Camera& to, double t);

  glm::mat4 view() const;
  glm::mat4 projection() const;  // near and far fitted to the box of the last fit()
  Ray ray(glm::vec2 pixel) const;
  glm::vec2 project(const Vector3d& point) const;  // to pixels; far outside for points behind the eye
  double depth(const Vector3d& point) const;       // distance in front of the eye along the view, < 0 behind
  double pixel_size_at(const Vector3d& point) const;  // scene units that one pixel covers there

  Vector3d eye() const { return target_ - distance_ * forward_; }
  Vector3d target() const { return target_; }
  const Vector3d& forward() const { return forward_; }  // unit, into the screen
  const Vector3d& right() const { return right_; }      // unit, horizontal
  const Vector3d& up() const { return up_; }            // unit, towards the top of the screen
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  void fit(const Points& points, const Vector3d& low, const Vector3d& high);
  void set_eye(const Vector3d& eye) { target_ = eye + distance_ * forward_; }

  Vector3d target_ = Vector3d::Zero();
  double distance_ = 10.0;
  double azimuth_ = 0.0, elevation_ = 0.0;  // of the eye seen from the target, radians
  Vector3d forward_, right_, up_;           // what the two angles mean
  double half_height_ = 0.30934;            // of the picture at distance 1: 0.6 radians from bottom to top
  double scene_radius_ = 1.0;
  Vector3d scene_centre_ = Vector3d::Zero();
  int width_ = 1, height_ = 1;
};

}  // namespace planewright::render
