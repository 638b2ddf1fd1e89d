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

std::vector<int> points_in_box(const Points& points, const Camera& camera, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 low(std::min(a.x, b.x), std::min(a.y, b.y)), high(std::max(a.x, b.x), std::max(a.y, b.y));
  std::vector<int> inside;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vector3d p = points.row(i).transpose();
    if (!p.allFinite() || !(camera.depth(p) > 0.0)) continue;
    const glm::vec2 at = camera.project(p);
    if (at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y) {
      inside.push_back(static_cast<int>(i));
    }
  }
  return inside;
}

std::vector<int> polygons_in_box(const PolygonLayer& layer, const Camera& camera, glm::vec2 a, glm::vec2 b) {
  std::vector<char> in(static_cast<size_t>(layer.points.rows()), 0);
  for (const int i : points_in_box(layer.points, camera, a, b)) in[static_cast<size_t>(i)] = 1;
  std::vector<int> inside;
  for (int p = 0; p < layer.polygons.size(); ++p) {
    const auto corners = layer.polygons[p];
    if (!corners.empty() &&
        std::all_of(corners.begin(), corners.end(), [&](int c) { return in[static_cast<size_t>(c)] != 0; })) {
      inside.push_back(p);
    }
  }
  return inside;
}

std::vector<char> polygons_in_sight(const PolygonLayer& layer, const Camera& camera) {
  const int width = camera.width(), height = camera.height();
  const auto pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
  std::vector<float> nearest(pixels, 0.0f);  // 1 / depth, which is linear on the screen; 0: far away
  std::vector<int> owner(pixels, -1);
  for (int p = 0; p < layer.polygons.size(); ++p) {
    const auto corners = layer.polygons[p];
    if (corners.size() < 3) continue;
    if (std::any_of(corners.begin(), corners.end(), [&](int c) {
          const Vector3d at = layer.points.row(c).transpose();
          return !at.allFinite() || !(camera.depth(at) > 0.0);
        })) {
      continue;
    }
    for (const auto& t : triangulate(layer.points, corners)) {
      glm::vec2 at[3];
      float inverse[3];
      for (int k = 0; k < 3; ++k) {
        const Vector3d corner = layer.points.row(t[static_cast<size_t>(k)]).transpose();
        at[k] = camera.project(corner);
        inverse[k] = static_cast<float>(1.0 / camera.depth(corner));
      }
      const glm::vec2 ab = at[1] - at[0], ac = at[2] - at[0];
      const float area = ab.x * ac.y - ab.y * ac.x;
      if (area == 0.0f) continue;
      const auto range = [](float x, float y, float z, int most) {
        const float low = std::clamp(std::floor(std::min({x, y, z})), 0.0f, static_cast<float>(most - 1));
        const float high = std::clamp(std::ceil(std::max({x, y, z})), 0.0f, static_cast<float>(most - 1));
        return std::pair(static_cast<int>(low), static_cast<int>(high));
      };
      const auto [left, right] = range(at[0].x, at[1].x, at[2].x, width);
      const auto [top, bottom] = range(at[0].y, at[1].y, at[2].y, height);
      for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
          const glm::vec2 way = glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f) - at[0];
          const float v = (way.x * ac.y - way.y * ac.x) / area, w = (ab.x * way.y - ab.y * way.x) / area;
          if (v < 0.0f || w < 0.0f || v + w > 1.0f) continue;
          const float near = inverse[0] + v * (inverse[1] - inverse[0]) + w * (inverse[2] - inverse[0]);
          const auto pixel = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
          if (near <= nearest[pixel]) continue;
          nearest[pixel] = near;
          owner[pixel] = p;
        }
      }
    }
  }
  std::vector<char> seen(static_cast<size_t>(layer.polygons.size()), 0);
  for (const int p : owner) {
    if (p >= 0) seen[static_cast<size_t>(p)] = 1;
  }
  return seen;
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
