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
  if (!low.allFinite() || !high.allFinite() || (high.array() < low.array()).any()) return;
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

// How far the eye must be follows from the four planes of the view pyramid alone: each must have every point
// on its inner side. Where it stands beside the centre then follows from the picture, in which the model
// stands in the middle. Both in the camera's own axes (x right, y up, z towards the eye) with the box's
// centre as origin.
void Camera::fit(const Points& points, const Vector3d& low, const Vector3d& high) {
  scene_centre_ = 0.5 * (low + high);
  const double radius = 0.5 * (high - low).norm();
  scene_radius_ = radius > 0.0 ? radius : 1.0;

  Eigen::Matrix3d axes;  // rows
  axes << right_.transpose(), up_.transpose(), -forward_.transpose();
  Points seen(points.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (points.row(i).allFinite())
      seen.row(count++) = (axes * (points.row(i).transpose() - scene_centre_)).transpose();
  }
  seen.conservativeResize(count, 3);

  const double tan_y = kAir * half_height_, tan_x = tan_y * width_ / height_;
  const auto nearest_eye = [&](int axis, double tangent) {
    return ((seen.col(axis) + tangent * seen.col(2)).maxCoeff() +
            (-seen.col(axis) + tangent * seen.col(2)).maxCoeff()) /
           (2.0 * tangent);
  };
  // A single point, or points one behind the other, still get a sensible distance.
  distance_ =
      std::max({nearest_eye(0, tan_x), nearest_eye(1, tan_y), seen.col(2).maxCoeff() + 0.05 * scene_radius_});
  const Eigen::ArrayXd depths = distance_ - seen.col(2).array();
  Vector3d eye(0.0, 0.0, distance_);
  for (int axis : {0, 1}) {
    constexpr int kRounds = 12;  // Newton's method on a piecewise simple function: two or three do
    for (int round = 0; round < kRounds; ++round) {
      Eigen::Index last = 0, first = 0;
      const Eigen::ArrayXd in_picture = (seen.col(axis).array() - eye[axis]) / depths;
      const double sum = in_picture.maxCoeff(&last) + in_picture.minCoeff(&first);
      eye[axis] += sum / (1.0 / depths[last] + 1.0 / depths[first]);
    }
  }
  target_ = scene_centre_ + eye.x() * right_ + eye.y() * up_;
}

void Camera::reset_direction() {
  set_direction(kStandardAzimuth, kStandardElevation);
}

void Camera::set_direction(double azimuth, double elevation) {
  azimuth_ = std::remainder(azimuth, kFullTurn);
  elevation_ = std::clamp(elevation, -kElevationLimit, kElevationLimit);
  const double ca = std::cos(azimuth_), sa = std::sin(azimuth_), ce = std::cos(elevation_),
               se = std::sin(elevation_);
  forward_ = {-ce * ca, -ce * sa, -se};
  right_ = {-sa, ca, 0.0};
  up_ = {-se * ca, -se * sa, ce};
}

void Camera::orbit(glm::vec2 pixels, const Vector3d& pivot) {
  const Vector3d from_eye = pivot - eye();
  const double x = from_eye.dot(right_), y = from_eye.dot(up_), z = from_eye.dot(forward_);
  const double step = kOrbitPerHeight / height_;
  set_direction(azimuth_ - step * pixels.x, elevation_ + step * pixels.y);
  set_eye(pivot - x * right_ - y * up_ - z * forward_);
}

void Camera::pan(glm::vec2 pixels, const Vector3d& anchor) {
  const double size = pixel_size_at(anchor);
  target_ += size * (-static_cast<double>(pixels.x) * right_ + static_cast<double>(pixels.y) * up_);
}

// Moving the eye along the ray of the pixel keeps everything on that ray where it is on the screen.
void Camera::zoom(double factor, glm::vec2 pixel) {
  if (!(factor > 0.0) || !std::isfinite(factor)) return;
  const Ray along = ray(pixel);
  const Vector3d from = eye();
  const double before = distance_;
  distance_ = std::clamp(before / factor, kNearestEye * scene_radius_, kFarthestEye * scene_radius_);
  set_eye(from + (before - distance_) / along.direction.dot(forward_) * along.direction);
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

// Distances by their ratio, so that a way in looks as fast as the way out.
Camera Camera::between(const Camera& from, const Camera& to, double t) {
  Camera camera = to;
  if (t >= 1.0) return camera;
  const double turn = std::remainder(to.azimuth_ - from.azimuth_, kFullTurn);
  camera.set_direction(from.azimuth_ + t * turn, from.elevation_ + t * (to.elevation_ - from.elevation_));
  const double ratio = to.distance_ / from.distance_;
  camera.distance_ = from.distance_ * std::pow(ratio, t);
  // The target moves as the distance does, so that what is approached stands still in the picture.
  const double part = std::abs(ratio - 1.0) < 1e-6 ? t : (std::pow(ratio, t) - 1.0) / (ratio - 1.0);
  camera.target_ = from.target_ + part * (to.target_ - from.target_);
  return camera;
}

glm::mat4 Camera::view() const {
  const Vector3d r = right_, u = up_, back = -forward_, e = eye();
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
  const double t = half_height_;
  glm::mat4 m(0.0f);
  m[0][0] = static_cast<float>(height_ / (t * width_));
  m[1][1] = static_cast<float>(1.0 / t);
  m[2][2] = static_cast<float>(-(far + near) / (far - near));
  m[2][3] = -1.0f;
  m[3][2] = static_cast<float>(-2.0 * far * near / (far - near));
  return m;
}

Ray Camera::ray(glm::vec2 pixel) const {
  const double t = half_height_;
  const double x = (2.0 * pixel.x / width_ - 1.0) * t * width_ / height_,
               y = (1.0 - 2.0 * pixel.y / height_) * t;
  return {eye(), (forward_ + x * right_ + y * up_).normalized()};
}

glm::vec2 Camera::project(const Vector3d& point) const {
  const Vector3d from_eye = point - eye();
  const double z = from_eye.dot(forward_);
  if (!(z > 0.0)) return {kFarOutside, kFarOutside};
  const double scale = 0.5 * height_ / (half_height_ * z);
  return {static_cast<float>(0.5 * width_ + scale * from_eye.dot(right_)),
          static_cast<float>(0.5 * height_ - scale * from_eye.dot(up_))};
}

double Camera::depth(const Vector3d& point) const {
  return (point - eye()).dot(forward_);
}

double Camera::pixel_size_at(const Vector3d& point) const {
  return 2.0 * half_height_ * std::abs(depth(point)) / height_;
}

}  // namespace planewright::render
