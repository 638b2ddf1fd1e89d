#include "ui/render/panel_arrays.h"

#include "ui/render/edge_list.h"

namespace planewright::render {
namespace {

// The same geometry, or a copy in which folded polygons are cut anew. A polygon that crosses itself stays
// folded however it is cut, and makes no copy.
std::shared_ptr<const PanelGeometry> unfolded(std::shared_ptr<const PanelGeometry> geometry,
                                              const Points& points) {
  const std::vector<int> folded = find_folded(*geometry, points);
  if (folded.empty()) return geometry;
  auto copy = std::make_shared<PanelGeometry>(*geometry);
  bool changed = false;
  for (int p : folded) changed |= cut_again(*copy, points, p);
  return changed ? std::move(copy) : std::move(geometry);
}

}  // namespace

PanelArrays make_panel_arrays(const Points& points, const Polygons& polygons,
                              std::shared_ptr<const PanelGeometry> before) {
  PanelArrays arrays;
  if (before && before->polygons == polygons) {
    arrays.geometry = unfolded(std::move(before), points);
  } else {
    arrays.geometry = std::make_shared<const PanelGeometry>(make_panel_geometry(points, polygons));
  }
  arrays.places.resize(static_cast<size_t>(arrays.geometry->vertex_count()));
  write_places(*arrays.geometry, points, arrays.places);
  arrays.shadow = make_ground_shadow(points, arrays.geometry->corners);
  return arrays;
}

PanelArrays triangles_of(const PanelArrays& all, const std::vector<int>& polygons) {
  PanelArrays out;
  if (!all.geometry) return out;
  const PanelGeometry& from = *all.geometry;
  auto geometry = std::make_shared<PanelGeometry>();
  geometry->first_triangle.push_back(0);
  for (const int p : polygons) {
    if (p < 0 || p >= from.polygons.size()) continue;
    const int first = 3 * from.first_triangle[p], last = 3 * from.first_triangle[p + 1];
    geometry->polygons.push_back(from.polygons[p]);
    geometry->corners.insert(geometry->corners.end(), from.corners.begin() + first,
                             from.corners.begin() + last);
    geometry->shapes.insert(geometry->shapes.end(), from.shapes.begin() + first, from.shapes.begin() + last);
    geometry->first_triangle.push_back(static_cast<int>(geometry->corners.size() / 3));
    out.places.insert(out.places.end(), all.places.begin() + first, all.places.begin() + last);
  }
  out.geometry = std::move(geometry);
  return out;
}

LineArrays make_line_arrays(const std::vector<Vector3d>& ends) {
  LineArrays arrays;
  const size_t count = ends.size() / 2;
  arrays.vertices.reserve(4 * count);
  arrays.indices.reserve(6 * count);
  for (size_t i = 0; i < count; ++i) {
    std::array<float, 6> line;
    for (int k = 0; k < 3; ++k) {
      line[k] = static_cast<float>(ends[2 * i][k]);
      line[k + 3] = static_cast<float>(ends[2 * i + 1][k]);
    }
    arrays.vertices.insert(arrays.vertices.end(), 4, line);
    const auto first = static_cast<std::uint32_t>(4 * i);
    for (std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) arrays.indices.push_back(first + corner);
  }
  return arrays;
}

GhostArrays make_ghost_arrays(const Points& points, const Polygons& polygons) {
  GhostArrays ghost;
  ghost.faces = make_panel_arrays(points, polygons);
  const EdgeList list = list_edges(polygons);
  std::vector<Vector3d> ends;
  ends.reserve(2 * list.edges.size());
  double length = 0.0;
  for (const EdgeUse& edge : list.edges) {
    ends.emplace_back(points.row(edge.a).transpose());
    ends.emplace_back(points.row(edge.b).transpose());
    length += (ends.back() - ends[ends.size() - 2]).norm();
  }
  ghost.lines = make_line_arrays(ends);
  if (!list.edges.empty())
    ghost.mean_edge = static_cast<float>(length / static_cast<double>(list.edges.size()));
  return ghost;
}

}  // namespace planewright::render
