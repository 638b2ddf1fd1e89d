#include "ui/render/panel_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/mesh/triangulate.h"
#include "ui/render/edge_list.h"

namespace planewright::render {
namespace {

// The corner of the polygon at which its edge a -> b starts; -1 when a, b is a diagonal.
int corner_of_edge(std::span<const int> polygon, int a, int b) {
  for (size_t k = 0; k < polygon.size(); ++k) {
    if (polygon[k] == a && polygon[k + 1 < polygon.size() ? k + 1 : 0] == b) return static_cast<int>(k);
  }
  return -1;
}

// Which edges of a triangle of polygon p are the polygon's own, and which of these are borders.
std::uint32_t edge_mask(const PanelGeometry& geometry, int p, std::span<const int> triangle) {
  std::uint32_t mask = 0;
  for (int k = 0; k < 3; ++k) {
    const int corner = corner_of_edge(geometry.polygons[p], triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
    if (corner < 0) continue;
    mask |= edge_bit(k);
    if (geometry.border[geometry.polygons.offsets()[p] + corner]) mask |= border_edge_bit(k);
  }
  return mask;
}

}  // namespace

PanelGeometry make_panel_geometry(const Points& points, const Polygons& polygons) {
  PanelGeometry geometry;
  geometry.polygons = polygons;
  const EdgeList edges = list_edges(polygons);
  geometry.border.reserve(edges.edge_of_corner.size());
  for (int e : edges.edge_of_corner) geometry.border.push_back(edges.edges[e].polygons == 1);

  const size_t corner_count = polygons.indices().size();
  geometry.corners.reserve(3 * corner_count);
  geometry.shapes.reserve(3 * corner_count);
  geometry.first_triangle.reserve(static_cast<size_t>(polygons.size()) + 1);
  geometry.first_triangle.push_back(0);
  for (int p = 0; p < polygons.size(); ++p) {
    const auto polygon = polygons[p];
    if (polygon.size() >= 3) {
      const float size = static_cast<float>(std::sqrt(0.5 * newell_vector(points, polygon).norm()));
      for (const auto& triangle : triangulate(points, polygon)) {
        geometry.corners.insert(geometry.corners.end(), triangle.begin(), triangle.end());
        geometry.shapes.insert(geometry.shapes.end(), 3, PanelShape{edge_mask(geometry, p, triangle), size});
      }
    }
    geometry.first_triangle.push_back(static_cast<int>(geometry.corners.size() / 3));
  }
  return geometry;
}

std::vector<int> find_folded(const PanelGeometry& geometry, const Points& points) {
  constexpr double kNoise = 1e-9;  // of the polygon's area: corners in line are no fold
  std::vector<int> folded;
  for (int p = 0; p < geometry.polygons.size(); ++p) {
    if (geometry.polygons.valence(p) <= 3) continue;
    const Vector3d normal = newell_vector(points, geometry.polygons[p]);
    const double limit = -kNoise * normal.squaredNorm();
    for (int t = geometry.first_triangle[p]; t < geometry.first_triangle[p + 1]; ++t) {
      const Vector3d a = points.row(geometry.corners[3 * t]).transpose();
      const Vector3d ab = points.row(geometry.corners[3 * t + 1]).transpose() - a;
      const Vector3d ac = points.row(geometry.corners[3 * t + 2]).transpose() - a;
      if (ab.cross(ac).dot(normal) < limit) {
        folded.push_back(p);
        break;
      }
    }
  }
  return folded;
}

bool cut_again(PanelGeometry& geometry, const Points& points, int polygon) {
  const auto triangles = triangulate(points, geometry.polygons[polygon]);
  const int first = 3 * geometry.first_triangle[polygon];
  bool changed = false;
  for (size_t t = 0; t < triangles.size(); ++t) {
    const auto old = geometry.corners.begin() + first + static_cast<std::ptrdiff_t>(3 * t);
    if (std::equal(triangles[t].begin(), triangles[t].end(), old)) continue;
    std::copy(triangles[t].begin(), triangles[t].end(), old);
    const std::uint32_t mask = edge_mask(geometry, polygon, triangles[t]);
    for (size_t k = 0; k < 3; ++k) geometry.shapes[first + 3 * t + k].edge_mask = mask;
    changed = true;
  }
  return changed;
}

void write_places(const PanelGeometry& geometry, const Points& points, std::span<PanelPlace> out) {
  for (int p = 0; p < geometry.polygons.size(); ++p) {
    const int from = 3 * geometry.first_triangle[p], to = 3 * geometry.first_triangle[p + 1];
    if (from == to) continue;
    const std::uint32_t normal = pack_normal(newell_vector(points, geometry.polygons[p]));
    for (int k = from; k < to; ++k) {
      const double* point = points.data() + 3 * static_cast<Eigen::Index>(geometry.corners[k]);
      out[k] = {static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2]),
                normal};
    }
  }
}

void write_values(const PanelGeometry& geometry, const Vector& polygon_values, const Vector& point_values,
                  std::span<float> out) {
  const auto as_float = [](double value) {
    return std::isfinite(value) && std::abs(value) < kNoValue ? static_cast<float>(value) : kNoValue;
  };
  if (polygon_values.size() == geometry.polygons.size() && polygon_values.size() > 0) {
    for (int p = 0; p < geometry.polygons.size(); ++p) {
      const int from = 3 * geometry.first_triangle[p], to = 3 * geometry.first_triangle[p + 1];
      std::fill(out.begin() + from, out.begin() + to, as_float(polygon_values[p]));
    }
    return;
  }
  for (size_t k = 0; k < out.size(); ++k) {
    const int point = geometry.corners[k];
    out[k] = point < point_values.size() ? as_float(point_values[point]) : kNoValue;
  }
}

std::uint32_t pack_normal(const Vector3d& normal) {
  constexpr double kScale = 511.0;
  const double length = normal.norm();
  if (!(length > 0.0) || !std::isfinite(length)) return static_cast<std::uint32_t>(kScale) << 20;
  std::uint32_t packed = 0;
  for (int k = 0; k < 3; ++k) {
    const int component = static_cast<int>(std::lround(normal[k] / length * kScale));
    packed |= (static_cast<std::uint32_t>(component) & 0x3ffu) << (10 * k);
  }
  return packed;
}

}  // namespace planewright::render
