#include "ui/render/picking.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/mesh/triangulate.h"

namespace planewright::render {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

// Distance along the ray to a triangle met from either side, or kNowhere. A hair of tolerance (in barycentric
// coordinates) closes the cracks between neighbours.
double meet_triangle(const Ray& ray, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  constexpr double kHair = 1e-9;
  const Vector3d ab = b - a, ac = c - a;
  const Vector3d p = ray.direction.cross(ac);
  const double determinant = ab.dot(p);
  if (determinant == 0.0) return kNowhere;
  const Vector3d from_a = ray.origin - a;
  const double u = from_a.dot(p) / determinant;
  if (!(u >= -kHair && u <= 1.0 + kHair)) return kNowhere;
  const Vector3d q = from_a.cross(ab);
  const double v = ray.direction.dot(q) / determinant;
  if (!(v >= -kHair && u + v <= 1.0 + kHair)) return kNowhere;
  const double distance = ac.dot(q) / determinant;
  return distance >= 0.0 ? distance : kNowhere;
}

// Whether the ray, widened to a cone (radius per unit of distance), may meet the polygon: by its bounding
// ball.
bool may_meet(const Ray& ray, double widening, const Points& points, std::span<const int> polygon) {
  Vector3d low = points.row(polygon[0]).transpose(), high = low;
  for (int i : polygon.subspan(1)) {
    low = low.cwiseMin(points.row(i).transpose());
    high = high.cwiseMax(points.row(i).transpose());
  }
  const Vector3d centre = 0.5 * (low + high) - ray.origin;
  const double radius = 0.5 * (high - low).norm();
  const double along = centre.dot(ray.direction);
  if (along < -radius) return false;
  const double reach = radius * (1.0 + 1e-9) + widening * (along + radius);
  return centre.squaredNorm() - along * along <= reach * reach + 1e-12 * centre.squaredNorm();
}

// The polygons round a pixel, ready to be asked by several rays through its neighbourhood.
class Occluder {
 public:
  Occluder(const PolygonLayer* layer, const Camera& camera, glm::vec2 pixel, float radius) {
    if (layer == nullptr) return;
    const Ray centre = camera.ray(pixel);
    const Ray side = camera.ray(pixel + glm::vec2(radius + 1.0f, radius + 1.0f));
    const double widening = 1.1 * (side.direction - centre.direction).norm();
    for (int i = 0; i < layer->polygons.size(); ++i) {
      if (layer->polygons.valence(i) < 3) continue;
      if (!may_meet(centre, widening, layer->points, layer->polygons[i])) continue;
      for (const auto& t : triangulate(layer->points, layer->polygons[i])) {
        triangles_.push_back({layer->points.row(t[0]), layer->points.row(t[1]), layer->points.row(t[2])});
      }
    }
  }

  // Whether something stands more than `slack` before `point`, as seen from `eye`.
  bool hides(const Vector3d& point, const Vector3d& eye, double slack) const {
    const Vector3d from_eye = point - eye;
    const double distance = from_eye.norm();
    if (!(distance > 0.0)) return false;
    const Ray ray{eye, from_eye / distance};
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const auto& t) {
      return meet_triangle(ray, t[0], t[1], t[2]) < distance - slack;
    });
  }

 private:
  std::vector<std::array<Vector3d, 3>> triangles_;
};

struct Candidate {
  float pixels;  // from the mouse
  double depth;
  int index;
  Vector3d place;  // the point of the element that is nearest to the mouse on the screen
  double slack;
};

std::optional<int> nearest_visible(std::vector<Candidate>& candidates, const Occluder& occluder,
                                   const Vector3d& eye) {
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    if (a.pixels != b.pixels) return a.pixels < b.pixels;
    if (a.depth != b.depth) return a.depth < b.depth;
    return a.index < b.index;
  });
  for (const Candidate& c : candidates) {
    if (!occluder.hides(c.place, eye, c.slack)) return c.index;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Hit> pick_polygon(const PolygonLayer& layer, const Ray& ray) {
  std::optional<Hit> best;
  for (int i = 0; i < layer.polygons.size(); ++i) {
    const auto polygon = layer.polygons[i];
    if (polygon.size() < 3 || !may_meet(ray, 0.0, layer.points, polygon)) continue;
    for (const auto& t : triangulate(layer.points, polygon)) {
      const double distance =
          meet_triangle(ray, layer.points.row(t[0]).transpose(), layer.points.row(t[1]).transpose(),
                        layer.points.row(t[2]).transpose());
      if (distance < (best ? best->distance : kNowhere))
        best = Hit{i, ray.origin + distance * ray.direction, distance};
    }
  }
  return best;
}

std::optional<int> pick_edge(const Points& points, const std::vector<std::pair<int, int>>& edges,
                             const Camera& camera, glm::vec2 pixel, float radius,
                             const PolygonLayer* occluder) {
  const Vector3d eye = camera.eye();
  std::vector<Candidate> candidates;
  for (size_t i = 0; i < edges.size(); ++i) {
    Vector3d a = points.row(edges[i].first).transpose(), b = points.row(edges[i].second).transpose();
    const double length = (b - a).norm();
    double depth_a = camera.depth(a), depth_b = camera.depth(b);
    // What is behind the eye is cut off before projecting.
    const double nearest = 1e-6 * std::max(depth_a, depth_b);
    if (!(nearest > 0.0)) continue;
    if (depth_a < nearest) {
      a += (nearest - depth_a) / (depth_b - depth_a) * (b - a);
      depth_a = nearest;
    } else if (depth_b < nearest) {
      b += (nearest - depth_b) / (depth_a - depth_b) * (a - b);
      depth_b = nearest;
    }
    const glm::vec2 from = camera.project(a), along = camera.project(b) - from, to_pixel = pixel - from;
    const float squared = along.x * along.x + along.y * along.y;
    const float dot = to_pixel.x * along.x + to_pixel.y * along.y;
    const float s = squared > 0.0f ? std::clamp(dot / squared, 0.0f, 1.0f) : 0.0f;
    const float pixels = std::hypot(to_pixel.x - s * along.x, to_pixel.y - s * along.y);
    if (!(pixels <= radius)) continue;
    // Halfway on the screen is not halfway in space: 1/depth is what is linear on the screen.
    const double t = s * depth_a / (s * depth_a + (1.0 - s) * depth_b);
    const Vector3d place = a + t * (b - a);
    candidates.push_back({pixels, camera.depth(place), static_cast<int>(i), place, 0.5 * length});
  }
  if (candidates.empty()) return std::nullopt;
  return nearest_visible(candidates, Occluder(occluder, camera, pixel, radius), eye);
}

std::optional<int> pick_point(const Points& points, const Camera& camera, glm::vec2 pixel, float radius,
                              const PolygonLayer* occluder) {
  std::vector<Candidate> candidates;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vector3d p = points.row(i).transpose();
    const double depth = camera.depth(p);
    if (!(depth > 0.0)) continue;
    const glm::vec2 away = camera.project(p) - pixel;
    const float pixels = std::hypot(away.x, away.y);
    if (!(pixels <= radius)) continue;
    candidates.push_back({pixels, depth, static_cast<int>(i), p, 2.0 * radius * camera.pixel_size_at(p)});
  }
  if (candidates.empty()) return std::nullopt;
  return nearest_visible(candidates, Occluder(occluder, camera, pixel, radius), camera.eye());
}

}  // namespace planewright::render
