#include "ui/render/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace planewright::render {
namespace {

constexpr double kStandardAzimuth = -2.15, kStandardElevation = 0.55;
constexpr double kElevationLimit = 1.5533;  // 89 degrees: "up" stays defined
constexpr double kAir = 0.90;               // part of the picture that a fitted model may fill
constexpr double kOrbitPerHeight = 4.0;     // radians for a drag over the whole height
constexpr double kNearestEye = 1e-5, kFarthestEye = 100.0;  // distance to the target, in scene radii
constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr float kFarOutside = -1e6f;

}  // namespace

void Camera::set_viewport(int width, int height) {
  width_ = std::max(width, 1);
  height_ = std::max(height, 1);
}

void Camera::fit(const Vector3d& low, const Vector3d& high) {
  Points corners(8, 3);
  for (int i = 0; i < 8; ++i) {
    corners.row(i) << ((i & 1) ? high : low).x(), ((i & 2) ? high : low).y(), ((i & 4) ? high : low).z();
  }
  fit(corners);
}

void Camera::fit(const Points& points) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite()) continue;
    low = low.cwiseMin(points.row(i).transpose());
    high = high.cwiseMax(points.row(i).transpose());
  }
  if (low.allFinite() && high.allFinite()) fit(points, low, high);
}

// The eye's place with respect to the centre, in the camera's own axes (x right, y up, z towards the eye),
// follows from the four planes of the view pyramid alone: each must have every point on its inner side.
void Camera::fit(const Points& points, const Vector3d& low, const Vector3d& high) {
  scene_centre_ = 0.5 * (low + high);
  const double radius = 0.5 * (high - low).norm();
  scene_radius_ = radius > 0.0 ? radius : 1.0;

  const double tan_y = kAir * half_height(), tan_x = tan_y * width_ / height_;
  const double none = -std::numeric_limits<double>::infinity();
  double beyond_right = none, beyond_left = none, beyond_top = none, beyond_bottom = none;
  const Vector3d r = right(), u = up(), back = -forward();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite()) continue;
    const Vector3d p = points.row(i).transpose() - scene_centre_;
    const double x = p.dot(r), y = p.dot(u), z = p.dot(back);
    beyond_right = std::max(beyond_right, x + tan_x * z);
    beyond_left = std::max(beyond_left, -x + tan_x * z);
    beyond_top = std::max(beyond_top, y + tan_y * z);
    beyond_bottom = std::max(beyond_bottom, -y + tan_y * z);
  }
  const double x = 0.5 * (beyond_right - beyond_left), y = 0.5 * (beyond_top - beyond_bottom);
  const double z =
      std::max((beyond_right + beyond_left) / (2.0 * tan_x), (beyond_top + beyond_bottom) / (2.0 * tan_y));
  // A single point, or a model seen exactly edge-on from inside, still gets a sensible distance.
  distance_ = std::max(z, 0.05 * scene_radius_);
  target_ = scene_centre_ + x * r + y * u;
}

void Camera::reset_direction() {
  set_direction(kStandardAzimuth, kStandardElevation);
}

void Camera::set_direction(double azimuth, double elevation) {
  azimuth_ = std::remainder(azimuth, kFullTurn);
  elevation_ = std::clamp(elevation, -kElevationLimit, kElevationLimit);
}

void Camera::orbit(glm::vec2 pixels, const Vector3d& pivot) {
  const Vector3d from_eye = pivot - eye();
  const double x = from_eye.dot(right()), y = from_eye.dot(up()), z = from_eye.dot(forward());
  const double step = kOrbitPerHeight / height_;
  azimuth_ = std::remainder(azimuth_ - step * pixels.x, kFullTurn);
  elevation_ = std::clamp(elevation_ + step * pixels.y, -kElevationLimit, kElevationLimit);
  set_eye(pivot - x * right() - y * up() - z * forward());
}

void Camera::pan(glm::vec2 pixels, const Vector3d& anchor) {
  const double size = pixel_size_at(anchor);
  target_ += size * (-static_cast<double>(pixels.x) * right() + static_cast<double>(pixels.y) * up());
}

// Moving the eye along the ray of the pixel keeps everything on that ray where it is on the screen.
void Camera::zoom(double factor, glm::vec2 pixel) {
  if (!(factor > 0.0) || !std::isfinite(factor)) return;
  const Ray along = ray(pixel);
  const Vector3d from = eye();
  const double before = distance_;
  distance_ = std::clamp(before / factor, kNearestEye * scene_radius_, kFarthestEye * scene_radius_);
  set_eye(from + (before - distance_) / along.direction.dot(forward()) * along.direction);
}

void Camera::zoom(double factor, const Vector3d& anchor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) return;
  const Vector3d from = eye();
  const double anchor_depth = depth(anchor);
  if (anchor_depth <= 0.0) return;
  // What is being looked at is now the anchor: its depth becomes the orbit distance.
  distance_ = std::clamp(anchor_depth / factor, kNearestEye * scene_radius_, kFarthestEye * scene_radius_);
  set_eye(anchor + distance_ / anchor_depth * (from - anchor));
}

glm::mat4 Camera::view() const {
  const Vector3d r = right(), u = up(), back = -forward(), e = eye();
  glm::mat4 m(1.0f);
  for (int k = 0; k < 3; ++k) {
    m[k][0] = static_cast<float>(r[k]);
    m[k][1] = static_cast<float>(u[k]);
    m[k][2] = static_cast<float>(back[k]);
  }
  m[3][0] = static_cast<float>(-r.dot(e));
  m[3][1] = static_cast<float>(-u.dot(e));
  m[3][2] = static_cast<float>(-back.dot(e));
  return m;
}

glm::mat4 Camera::projection() const {
  const double centre = depth(scene_centre_), radius = 1.05 * scene_radius_;
  const double far = std::max(centre + radius, 2.0 * distance_);
  // Inside the scene the near plane follows the eye's distance to what is looked at, so that close views do
  // not cut it; far away from it depth precision goes first, where nobody looks.
  const double near = std::max(centre - radius, std::min(0.1 * distance_, 1e-3 * far));
  const double t = half_height();
  glm::mat4 m(0.0f);
  m[0][0] = static_cast<float>(height_ / (t * width_));
  m[1][1] = static_cast<float>(1.0 / t);
  m[2][2] = static_cast<float>(-(far + near) / (far - near));
  m[2][3] = -1.0f;
  m[3][2] = static_cast<float>(-2.0 * far * near / (far - near));
  return m;
}

Ray Camera::ray(glm::vec2 pixel) const {
  const double t = half_height();
  const double x = (2.0 * pixel.x / width_ - 1.0) * t * width_ / height_,
               y = (1.0 - 2.0 * pixel.y / height_) * t;
  return {eye(), (forward() + x * right() + y * up()).normalized()};
}

glm::vec2 Camera::project(const Vector3d& point) const {
  const Vector3d from_eye = point - eye();
  const double z = from_eye.dot(forward());
  if (!(z > 0.0)) return {kFarOutside, kFarOutside};
  const double scale = 0.5 * height_ / (half_height() * z);
  return {static_cast<float>(0.5 * width_ + scale * from_eye.dot(right())),
          static_cast<float>(0.5 * height_ - scale * from_eye.dot(up()))};
}

double Camera::depth(const Vector3d& point) const {
  return (point - eye()).dot(forward());
}

double Camera::pixel_size_at(const Vector3d& point) const {
  return 2.0 * half_height() * std::abs(depth(point)) / height_;
}

Vector3d Camera::eye() const {
  return target_ - distance_ * forward();
}

Vector3d Camera::forward() const {
  return {-std::cos(elevation_) * std::cos(azimuth_), -std::cos(elevation_) * std::sin(azimuth_),
          -std::sin(elevation_)};
}

Vector3d Camera::right() const {
  return {-std::sin(azimuth_), std::cos(azimuth_), 0.0};
}

Vector3d Camera::up() const {
  return {-std::sin(elevation_) * std::cos(azimuth_), -std::sin(elevation_) * std::sin(azimuth_),
          std::cos(elevation_)};
}

double Camera::half_height() const {
  return std::tan(0.5 * field_of_view_);
}

}  // namespace planewright::render
